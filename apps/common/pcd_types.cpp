/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * Point Cloud Library (PCL) - www.pointclouds.org
 * Copyright (c) 2026, pcl_shape contributors
 *
 * All rights reserved
 */

#include "pcd_types.h"

#include <pcl/PCLPointField.h>

#include <map>
#include <utility>

namespace pcl::app {

const char*
nameOf(PCDFormat format)
{
  switch (format) {
  case PCDFormat::ascii:
    return "ascii";
  case PCDFormat::binary:
    return "binary";
  default:
    return "binary_compressed";
  }
}

std::optional<PCDFormat>
formatOf(std::string_view name)
{
  for (const PCDFormat format :
       {PCDFormat::ascii, PCDFormat::binary, PCDFormat::binary_compressed})
    if (name == nameOf(format))
      return format;
  return std::nullopt;
}

char
typeLetter(std::uint8_t datatype)
{
  switch (datatype) {
  case pcl::PCLPointField::FLOAT32:
  case pcl::PCLPointField::FLOAT64:
    return 'F';
  case pcl::PCLPointField::UINT8:
  case pcl::PCLPointField::UINT16:
  case pcl::PCLPointField::UINT32:
  case pcl::PCLPointField::UINT64:
    return 'U';
  default:
    return 'I';
  }
}

std::optional<std::uint8_t>
datatypeOf(std::string_view type, std::string_view size)
{
  static const std::map<std::pair<std::string_view, std::string_view>, std::uint8_t>
      types{{{"I", "1"}, pcl::PCLPointField::INT8},
            {{"I", "2"}, pcl::PCLPointField::INT16},
            {{"I", "4"}, pcl::PCLPointField::INT32},
            {{"I", "8"}, pcl::PCLPointField::INT64},
            {{"U", "1"}, pcl::PCLPointField::UINT8},
            {{"U", "2"}, pcl::PCLPointField::UINT16},
            {{"U", "4"}, pcl::PCLPointField::UINT32},
            {{"U", "8"}, pcl::PCLPointField::UINT64},
            {{"F", "4"}, pcl::PCLPointField::FLOAT32},
            {{"F", "8"}, pcl::PCLPointField::FLOAT64}};
  const auto found = types.find({type, size});
  if (found == types.end())
    return std::nullopt;
  return found->second;
}

} // namespace pcl::app
