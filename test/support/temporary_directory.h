// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// A directory that is removed at the end of a test.

#pragma once

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <string>

namespace pcl {
namespace test {

/** \brief An empty directory that is removed in the end. */
class TemporaryDirectory {
public:
  TemporaryDirectory()
  {
    path_ = (std::filesystem::temp_directory_path() / "pcl_shape_XXXXXX").string();
    if (!mkdtemp(path_.data()))
      throw std::runtime_error("no temporary directory");
  }

  TemporaryDirectory(const TemporaryDirectory&) = delete;
  TemporaryDirectory& operator=(const TemporaryDirectory&) = delete;

  ~TemporaryDirectory()
  {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }

  const std::string&
  path() const
  {
    return path_;
  }

  std::string
  file(const std::string& name) const
  {
    return path_ + "/" + name;
  }

  std::size_t
  countFiles() const
  {
    const std::filesystem::directory_iterator files(path_);
    return static_cast<std::size_t>(std::distance(begin(files), end(files)));
  }

private:
  std::string path_;
};

inline std::string
contentOf(const std::string& file_name)
{
  std::ifstream stream(file_name, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
}

inline void
writeFile(const std::string& file_name, const std::string& content)
{
  std::ofstream(file_name, std::ios::binary) << content;
}

} // namespace test
} // namespace pcl
