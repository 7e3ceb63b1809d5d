/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * Point Cloud Library (PCL) - www.pointclouds.org
 * Copyright (c) 2026, pcl_shape contributors
 *
 * All rights reserved
 */

#include "errors.h"
#include "shape_model_json.h"

#include <pcl/features/shape_model.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <unistd.h>

namespace pcl {
namespace {

/** \brief Write to a file beside the target, then rename it. */
void
writeWhole(const std::string& file_name, const std::string& text)
{
  const std::string part = file_name + ".part" + std::to_string(::getpid());
  const auto fail = [&] {
    const std::string reason = std::strerror(errno);
    std::remove(part.c_str());
    raise<IOException>(textOf(file_name, ": cannot be written: ", reason));
  };
  {
    std::ofstream stream(part, std::ios::binary);
    stream << text;
    stream.close();
    if (!stream) {
      fail();
    }
  }
  if (std::rename(part.c_str(), file_name.c_str()) != 0) {
    fail();
  }
}

} // namespace

ShapeModel
ShapeModel::load(const std::string& file_name)
{
  if (std::filesystem::is_directory(file_name)) {
    raise<IOException>(textOf(file_name, ": is a directory, not a model file"));
  }
  std::ifstream stream(file_name, std::ios::binary);
  if (!stream) {
    raise<IOException>(textOf(file_name, ": cannot be read: ", std::strerror(errno)));
  }
  const std::string text{std::istreambuf_iterator<char>(stream), {}};
  return parse(text, file_name);
}

ShapeModel
ShapeModel::parse(const std::string& text, const std::string& file_name)
{
  try {
    return detail::modelFrom(detail::Json::parse(text));
  }
  catch (const detail::Json::exception& e) {
    raise<IOException>(textOf(file_name, ": is not a complete JSON file: ", e.what()));
  }
  catch (const BadArgumentException& e) {
    raise<IOException>(textOf(file_name, ": is not a usable model: ", messageOf(e)));
  }
}

void
ShapeModel::save(const std::string& file_name) const
{
  if (classes_.empty()) {
    raise<BadArgumentException>(
        textOf("a model without a class cannot be saved: add() one"));
  }
  writeWhole(file_name, detail::toJson(*this).dump(1) + "\n");
}

} // namespace pcl
