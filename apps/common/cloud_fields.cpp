/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * Point Cloud Library (PCL) - www.pointclouds.org
 * Copyright (c) 2026, pcl_shape contributors
 *
 * All rights reserved
 */

#include "cloud_file.h"
#include "errors.h"

#include <cmath>
#include <cstring>
#include <limits>

namespace pcl::app {
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

} // namespace pcl::app
