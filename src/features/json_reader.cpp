/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * Point Cloud Library (PCL) - www.pointclouds.org
 * Copyright (c) 2026, pcl_shape contributors
 *
 * All rights reserved
 */

#include "json_reader.h"

#include "errors.h"

#include <utility>

namespace pcl::detail {

template <typename T>
T
JsonReader::value(const char* name, bool is_right, const char* allowed) const
{
  if (!is_right) {
    fail(std::string("'") + name + "' is " + object_[name].dump().substr(0, 40) +
         ": it must be " + allowed);
  }
  return object_[name].get<T>();
}

JsonReader::JsonReader(const Json& object,
                       std::string where,
                       std::initializer_list<const char*> members)
: object_(object)
, where_(std::move(where))
{
  if (!object.is_object()) {
    fail("must be an object");
  }
  for (const char* member : members) {
    if (!object.contains(member)) {
      fail(std::string("has no '") + member + "'");
    }
  }
  if (object.size() != members.size()) {
    for (const auto& item : object.items()) {
      checkKnown(item.key(), members);
    }
  }
}

double
JsonReader::number(const char* name) const
{
  return value<double>(name, object_[name].is_number(), "a number");
}

std::uint64_t
JsonReader::count(const char* name) const
{
  return value<std::uint64_t>(
      name, object_[name].is_number_unsigned(), "a whole number, not negative");
}

std::string
JsonReader::text(const char* name) const
{
  return value<std::string>(name, object_[name].is_string(), "a string");
}

const Json&
JsonReader::array(const char* name) const
{
  if (!object_[name].is_array()) {
    fail(std::string("'") + name + "' must be an array");
  }
  return object_[name];
}

void
JsonReader::fail(const std::string& problem) const
{
  raise<BadArgumentException>(textOf(where_, " ", problem));
}

void
JsonReader::checkKnown(const std::string& name,
                       std::initializer_list<const char*> members) const
{
  for (const char* member : members) {
    if (name == member) {
      return;
    }
  }
  fail("has an unknown member '" + name + "'");
}

} // namespace pcl::detail
