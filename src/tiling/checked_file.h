// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Files that are complete or absent, with a checksum.

#pragma once

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <memory>
#include <string>
#include <vector>

namespace pcl::tiling {

using Bytes = std::vector<std::uint8_t>;

/** \param[in] before the checksum of the bytes before them, if there are any */
std::uint32_t checksumOf(const void* data, std::size_t size, std::uint32_t before = 0);

/** \brief Eight digits. */
std::string toText(std::uint32_t checksum);

struct CloseFile {
  void
  operator()(std::FILE* file) const
  {
    std::fclose(file);
  }
};
using File = std::unique_ptr<std::FILE, CloseFile>;

/** \brief Without a buffer: each file is read or written in a few large pieces.
 * \param[in] mode of std::fopen(); programs that are started do not get the file
 * \throws TilingError */
File openFile(const std::string& path, const std::string& mode);

/** \brief A file that is written beside its place from its beginning to its end, and
 * renamed then. All methods throw a TilingError. */
class WholeFile {
public:
  explicit WholeFile(const std::string& path);
  /** \brief Without commit() nothing is left. */
  ~WholeFile();
  WholeFile(const WholeFile&) = delete;
  WholeFile& operator=(const WholeFile&) = delete;

  void write(const void* data, std::size_t size);

  void commit();

  /** \brief How many bytes were written. */
  std::uint64_t
  size() const
  {
    return size_;
  }

  /** \brief Of all bytes that were written. */
  std::uint32_t
  checksum() const
  {
    return checksum_;
  }

private:
  std::string path_, temporary_;
  File file_;
  std::uint64_t size_ = 0;
  std::uint32_t checksum_ = 0;
};

/** \throws TilingError */
Bytes readWhole(const std::string& path);

/** \brief Remove a file whose bytes are not as they were written. \throws TilingError
 */
[[noreturn]] void failDamaged(const std::string& path);

/** \brief Some bytes of a file. \throws TilingError if they are not there */
void readAt(const std::string& path, std::uint64_t at, void* to, std::size_t size);

/** \brief Bytes at the end of a file. \throws TilingError */
void appendTo(const std::string& path, const void* data, std::size_t size);

/** \brief -1 if there is no such file. */
std::int64_t sizeOfFile(const std::string& path);

} // namespace pcl::tiling
