/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * Point Cloud Library (PCL) - www.pointclouds.org
 * Copyright (c) 2026, pcl_shape contributors
 *
 * All rights reserved
 */

#pragma once

#include <nlohmann/json.hpp>

#include <array>
#include <string>

namespace pcl::app {

/** \brief A value of a JSON file that knows where it is, for messages. All methods
 * throw an InputError that says where, what is there and what is allowed. */
class JsonValue {
public:
  /** \brief The whole file. */
  static JsonValue read(const std::string& path);

  bool has(const std::string& member) const;

  JsonValue at(const std::string& member) const;

  std::vector<JsonValue> array() const;

  std::string text() const;

  bool flag() const;

  /** \brief A finite number. */
  float number() const;

  /** \brief A whole number from 0 to 2^32 - 1. */
  std::uint32_t count() const;

  /** \brief Three finite numbers. */
  std::array<float, 3> vector() const;

  [[noreturn]] void fail(const std::string& allowed) const;

private:
  JsonValue(std::string path, std::string place, nlohmann::json value)
  : path_(std::move(path))
  , place_(std::move(place))
  , value_(std::move(value))
  {}

  std::string path_;
  std::string place_;
  nlohmann::json value_;
};

} // namespace pcl::app
