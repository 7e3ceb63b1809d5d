/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * Point Cloud Library (PCL) - www.pointclouds.org
 * Copyright (c) 2026, pcl_shape contributors
 *
 * All rights reserved
 */

#include "json_value.h"

#include "common/errors.h"
#include "common/pcd_values.h"

#include <cmath>
#include <fstream>
#include <iterator>
#include <limits>

namespace pcl::app {

JsonValue
JsonValue::read(const std::string& path)
{
  std::ifstream stream(path, std::ios::binary);
  std::string text{std::istreambuf_iterator<char>(stream), {}};
  if (!stream.is_open() || stream.bad())
    throw InputError(path + ": cannot be read: allowed is a JSON file");
  auto value = nlohmann::json::parse(text, nullptr, false);
  if (!value.is_object())
    throw InputError(path + ": is no JSON object: allowed is a file that one of the "
                            "applications wrote");
  return {path, "", std::move(value)};
}

void
JsonValue::fail(const std::string& allowed) const
{
  using Handler = nlohmann::json::error_handler_t;
  throw InputError(path_ + ": '" + place_ + "' is " +
                   app::quoted(value_.dump(-1, ' ', true, Handler::replace)) +
                   ": allowed is " + allowed);
}

bool
JsonValue::has(const std::string& member) const
{
  return value_.is_object() && value_.contains(member);
}

JsonValue
JsonValue::at(const std::string& member) const
{
  if (!has(member))
    throw InputError(path_ + ": '" + (place_.empty() ? "" : place_ + '.') + member +
                     "' is missing");
  return {path_, place_.empty() ? member : place_ + '.' + member, value_[member]};
}

std::vector<JsonValue>
JsonValue::array() const
{
  if (!value_.is_array())
    fail("an array");
  std::vector<JsonValue> values;
  values.reserve(value_.size());
  for (std::size_t i = 0; i < value_.size(); ++i)
    values.push_back({path_, place_ + '[' + std::to_string(i) + ']', value_[i]});
  return values;
}

std::string
JsonValue::text() const
{
  if (!value_.is_string())
    fail("a text");
  return value_.get<std::string>();
}

bool
JsonValue::flag() const
{
  if (!value_.is_boolean())
    fail("true or false");
  return value_.get<bool>();
}

float
JsonValue::number() const
{
  const bool is_number = value_.is_number();
  if (!is_number || !std::isfinite(value_.get<float>()))
    fail("a finite number");
  return value_.get<float>();
}

std::uint32_t
JsonValue::count() const
{
  if (!value_.is_number_unsigned() ||
      value_.get<std::uint64_t>() > std::numeric_limits<std::uint32_t>::max())
    fail("a whole number from 0 to 4294967295");
  return value_.get<std::uint32_t>();
}

std::array<float, 3>
JsonValue::vector() const
{
  if (!value_.is_array() || value_.size() != 3)
    fail("three finite numbers");
  const std::vector<JsonValue> values = array();
  return {values[0].number(), values[1].number(), values[2].number()};
}

} // namespace pcl::app
