// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// PURPOSE

#include "io/cloud_file.h"

#include "cli/errors.h"

#include <pcl/common/point_tests.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <stdexcept>

namespace pcl::app {

pcl::PointCloud<pcl::PointXYZ>::Ptr
pointsOf(const CloudFile& cloud)
{
  const std::vector<float> x = floatsOf(cloud, "x");
  const std::vector<float> y = floatsOf(cloud, "y");
  const std::vector<float> z = floatsOf(cloud, "z");
  pcl::PointCloud<pcl::PointXYZ>::Ptr points(
      new pcl::PointCloud<pcl::PointXYZ>(cloud.blob.width, cloud.blob.height));
  for (std::size_t i = 0; i < x.size(); ++i)
    (*points)[i] = pcl::PointXYZ(x[i], y[i], z[i]);
  const auto& v = cloud.viewpoint;
  points->sensor_origin_ = Eigen::Vector4f(v[0], v[1], v[2], 0.0f);
  points->sensor_orientation_ = Eigen::Quaternionf(v[3], v[4], v[5], v[6]);
  const std::size_t finite = countFinite(*points);
  if (finite == 0)
    throw InputError(cloud.path + ": none of its " + std::to_string(points->size()) +
                     " points is finite: allowed is a cloud with at least one");
  points->is_dense = finite == points->size();
  return points;
}

std::size_t
countFinite(const pcl::PointCloud<pcl::PointXYZ>& points)
{
  return static_cast<std::size_t>(
      std::count_if(points.begin(), points.end(), [](const pcl::PointXYZ& point) {
        return pcl::isXYZFinite(point);
      }));
}

pcl::PointCloud<pcl::Normal>::Ptr
normalsOf(const CloudFile& cloud)
{
  const std::vector<float> x = floatsOf(cloud, "normal_x");
  const std::vector<float> y = floatsOf(cloud, "normal_y");
  const std::vector<float> z = floatsOf(cloud, "normal_z");
  pcl::PointCloud<pcl::Normal>::Ptr normals(
      new pcl::PointCloud<pcl::Normal>(cloud.blob.width, cloud.blob.height));
  normals->is_dense = false;
  for (std::size_t i = 0; i < x.size(); ++i)
    (*normals)[i] = pcl::Normal(x[i], y[i], z[i]);
  if (findField(cloud, "curvature")) {
    const std::vector<float> curvature = floatsOf(cloud, "curvature");
    for (std::size_t i = 0; i < curvature.size(); ++i)
      (*normals)[i].curvature = curvature[i];
  }
  return normals;
}

namespace {

std::string
fieldNames(const CloudFile& cloud)
{
  std::string names;
  for (const auto& field : cloud.blob.fields)
    names += ' ' + field.name;
  return names;
}

const pcl::PCLPointField&
singleField(const CloudFile& cloud, const std::string& name)
{
  const pcl::PCLPointField* const field = findField(cloud, name);
  if (!field)
    throw InputError(cloud.path + ": field '" + name +
                     "' is missing: allowed is a file with it; this one has" +
                     fieldNames(cloud));
  if (field->count != 1)
    throw InputError(cloud.path + ": field '" + name + "' has COUNT " +
                     std::to_string(field->count) + ": allowed is 1");
  return *field;
}

const pcl::PCLPointField&
floatField(const CloudFile& cloud, const std::string& name)
{
  const pcl::PCLPointField& field = singleField(cloud, name);
  if (field.datatype != pcl::PCLPointField::FLOAT32)
    throw InputError(cloud.path + ": field '" + name + "' has another type than " +
                     "float32: allowed is SIZE 4, TYPE F");
  return field;
}

template <typename T>
double
valueAt(const std::uint8_t* bytes)
{
  T value;
  std::memcpy(&value, bytes, sizeof(value));
  return static_cast<double>(value);
}

double
valueOf(std::uint8_t datatype, const std::uint8_t* bytes)
{
  switch (datatype) {
  case pcl::PCLPointField::INT8:
    return valueAt<std::int8_t>(bytes);
  case pcl::PCLPointField::UINT8:
    return valueAt<std::uint8_t>(bytes);
  case pcl::PCLPointField::INT16:
    return valueAt<std::int16_t>(bytes);
  case pcl::PCLPointField::UINT16:
    return valueAt<std::uint16_t>(bytes);
  case pcl::PCLPointField::INT32:
    return valueAt<std::int32_t>(bytes);
  case pcl::PCLPointField::UINT32:
    return valueAt<std::uint32_t>(bytes);
  case pcl::PCLPointField::INT64:
    return valueAt<std::int64_t>(bytes);
  case pcl::PCLPointField::UINT64:
    return valueAt<std::uint64_t>(bytes);
  case pcl::PCLPointField::FLOAT32:
    return valueAt<float>(bytes);
  default:
    return valueAt<double>(bytes);
  }
}

} // namespace

std::size_t
valueSize(std::uint8_t datatype)
{
  switch (datatype) {
  case pcl::PCLPointField::INT8:
  case pcl::PCLPointField::UINT8:
    return 1;
  case pcl::PCLPointField::INT16:
  case pcl::PCLPointField::UINT16:
    return 2;
  case pcl::PCLPointField::INT32:
  case pcl::PCLPointField::UINT32:
  case pcl::PCLPointField::FLOAT32:
    return 4;
  default:
    return 8;
  }
}

const pcl::PCLPointField*
findField(const CloudFile& cloud, const std::string& name)
{
  for (const auto& field : cloud.blob.fields)
    if (field.name == name)
      return &field;
  return nullptr;
}

std::vector<float>
floatsOf(const CloudFile& cloud, const std::string& field)
{
  const std::uint32_t offset = floatField(cloud, field).offset;
  std::vector<float> values(cloud.size());
  for (std::size_t i = 0; i < values.size(); ++i)
    std::memcpy(&values[i],
                cloud.blob.data.data() + i * cloud.blob.point_step + offset,
                sizeof(float));
  return values;
}

std::vector<double>
numbersOf(const CloudFile& cloud, const std::string& field)
{
  const pcl::PCLPointField& source = singleField(cloud, field);
  std::vector<double> values(cloud.size());
  for (std::size_t i = 0; i < values.size(); ++i)
    values[i] =
        valueOf(source.datatype,
                cloud.blob.data.data() + i * cloud.blob.point_step + source.offset);
  return values;
}

std::vector<std::uint32_t>
labelsOf(const CloudFile& cloud, const std::string& field)
{
  const std::vector<double> values = numbersOf(cloud, field);
  std::vector<std::uint32_t> labels(values.size());
  for (std::size_t i = 0; i < labels.size(); ++i) {
    const double value = values[i];
    if (!(value >= 0.0 && value <= std::numeric_limits<std::uint32_t>::max()) ||
        value != std::floor(value))
      throw InputError(cloud.path + ": field '" + field + "' of point " +
                       std::to_string(i) + " is " + std::to_string(value) +
                       ": allowed is a whole number from 0 to 4294967295");
    labels[i] = static_cast<std::uint32_t>(value);
  }
  return labels;
}

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
