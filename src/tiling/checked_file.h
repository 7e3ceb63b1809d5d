// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Files that are complete or not there, with a checksum.

#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace pcl::tiling {

using Bytes = std::vector<std::uint8_t>;

std::uint32_t checksumOf(const void* data, std::size_t size);

/** \brief Eight digits. */
std::string toText(std::uint32_t checksum);

/** \brief Write a file beside its place, and rename it. \throws TilingError */
void writeWhole(const std::string& path, const Bytes& bytes);

/** \throws TilingError */
Bytes readWhole(const std::string& path);

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
