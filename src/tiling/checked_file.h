// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Files that are complete or absent, with a checksum.

#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace pcl::tiling {

using Bytes = std::vector<std::uint8_t>;

std::uint32_t checksumOf(const void* data, std::size_t size);

/** \brief Of some bytes and those before them. \param[in] before their checksum */
std::uint32_t checksumOf(std::uint32_t before, const void* data, std::size_t size);

/** \brief Eight digits. */
std::string toText(std::uint32_t checksum);

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
  std::uint64_t size() const;

  /** \brief Of all bytes that were written. */
  std::uint32_t checksum() const;

private:
  struct State;
  std::unique_ptr<State> state_;
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

/** \brief The data as bytes at the end. */
template <typename T>
void
put(const T& value, Bytes& bytes)
{
  const auto* const from = reinterpret_cast<const std::uint8_t*>(&value);
  bytes.insert(bytes.end(), from, from + sizeof(T));
}

} // namespace pcl::tiling
