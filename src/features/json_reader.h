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

#include <cstdint>
#include <initializer_list>
#include <string>

namespace pcl::detail {

using Json = nlohmann::ordered_json; ///< members stay in the order of the file

/** \brief Reads values out of a JSON object, and says where one is missing or wrong. */
class JsonReader {
public:
  /** \param[in] where what the object is called in messages
   * \param[in] members all that it must have
   * \throws BadArgumentException if it has not these, or others */
  JsonReader(const Json& object,
             std::string where,
             std::initializer_list<const char*> members);

  double number(const char* name) const;

  std::uint64_t count(const char* name) const;

  std::string text(const char* name) const;

  const Json& array(const char* name) const;

  const Json&
  member(const char* name) const
  {
    return object_[name];
  }

  /** \throws BadArgumentException that names the object */
  [[noreturn]] void fail(const std::string& problem) const;

private:
  void checkKnown(const std::string& name,
                  std::initializer_list<const char*> members) const;

  template <typename T>
  T value(const char* name, bool is_right, const char* allowed) const;

  const Json& object_;
  std::string where_;
};

} // namespace pcl::detail
