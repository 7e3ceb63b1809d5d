/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * Point Cloud Library (PCL) - www.pointclouds.org
 * Copyright (c) 2026, pcl_shape contributors
 *
 * All rights reserved
 */

#include "cloud_file.h"

#include <algorithm>
#include <cstring>
#include <stdexcept>

namespace pcl::app {
namespace {

void
setField32(CloudFile& cloud,
           const std::string& name,
           std::uint8_t datatype,
           const void* values)
{
  const pcl::PCLPointCloud2& old = cloud.blob;
  std::vector<pcl::PCLPointField> fields = old.fields;
  const auto found = std::find_if(fields.begin(), fields.end(), [&](const auto& field) {
    return field.name == name;
  });
  const auto place = static_cast<std::size_t>(found - fields.begin());
  if (found == fields.end())
    fields.emplace_back();
  fields[place].name = name;
  fields[place].datatype = datatype;
  fields[place].count = 1;
  std::uint32_t step = 0;
  for (auto& field : fields) {
    field.offset = step;
    step += static_cast<std::uint32_t>(valueSize(field.datatype)) * field.count;
  }

  const std::size_t size = cloud.size();
  std::vector<std::uint8_t> data(size * step);
  for (std::size_t f = 0; f < fields.size(); ++f) {
    const bool is_new = f == place;
    const std::size_t bytes = valueSize(fields[f].datatype) * fields[f].count;
    const auto* from = is_new ? static_cast<const std::uint8_t*>(values)
                              : old.data.data() + old.fields[f].offset;
    const std::size_t from_step = is_new ? bytes : old.point_step;
    std::uint8_t* to = data.data() + fields[f].offset;
    for (std::size_t i = 0; i < size; ++i)
      std::memcpy(to + i * step, from + i * from_step, bytes);
  }
  cloud.blob.fields = std::move(fields);
  cloud.blob.data = std::move(data);
  cloud.blob.point_step = step;
  cloud.blob.row_step = step * cloud.blob.width;
}

void
requireSize(std::size_t values, const CloudFile& cloud)
{
  if (values != cloud.size())
    throw std::logic_error(cloud.path + ": " + std::to_string(values) +
                           " values for a field of " + std::to_string(cloud.size()) +
                           " points");
}

} // namespace

void
setField(CloudFile& cloud, const std::string& name, const std::vector<float>& values)
{
  requireSize(values.size(), cloud);
  setField32(cloud, name, pcl::PCLPointField::FLOAT32, values.data());
}

void
setField(CloudFile& cloud,
         const std::string& name,
         const std::vector<std::uint32_t>& values)
{
  requireSize(values.size(), cloud);
  setField32(cloud, name, pcl::PCLPointField::UINT32, values.data());
}

void
setNormals(CloudFile& cloud, const pcl::PointCloud<pcl::Normal>& normals)
{
  std::array<std::vector<float>, 4> columns;
  for (auto& column : columns)
    column.reserve(normals.size());
  for (const pcl::Normal& normal : normals) {
    columns[0].push_back(normal.normal_x);
    columns[1].push_back(normal.normal_y);
    columns[2].push_back(normal.normal_z);
    columns[3].push_back(normal.curvature);
  }
  setField(cloud, "normal_x", columns[0]);
  setField(cloud, "normal_y", columns[1]);
  setField(cloud, "normal_z", columns[2]);
  setField(cloud, "curvature", columns[3]);
}

} // namespace pcl::app
