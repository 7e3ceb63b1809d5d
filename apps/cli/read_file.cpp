// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Reads a regular file, or says what is there instead.

#include "cli/read_file.h"

#include "cli/errors.h"

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>

namespace fs = std::filesystem;

namespace pcl::app {

std::string
readFile(const std::string& path, const std::string& expected)
{
  const auto bad = [&](const std::string& what, const char* readable = "") {
    return InputError(path + ": " + what + "; expected " + readable + expected);
  };
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  if (!fs::exists(status))
    throw bad(error ? error.message() : "no such file");
  if (!fs::is_regular_file(status))
    throw bad(fs::is_directory(status) ? "is a directory" : "is not a regular file");
  std::ifstream stream(path, std::ios::binary);
  if (!stream)
    throw bad(std::strerror(errno), "a readable file: ");
  std::string contents(fs::file_size(path), '\0');
  stream.read(contents.data(), static_cast<std::streamsize>(contents.size()));
  if (!stream)
    throw bad("reading failed", "a readable file: ");
  return contents;
}

} // namespace pcl::app
