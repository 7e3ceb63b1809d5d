// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Reads PCD files strictly, and writes them.

#pragma once

#include "io/cloud_file.h"

#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace pcl::app {

enum class PCDFormat { ascii, binary, binary_compressed };

/** \brief The word of the DATA line. */
const char* nameOf(PCDFormat format);

std::optional<PCDFormat> formatOf(std::string_view name);

/** \brief The name of the fields that only keep others aligned. */
constexpr std::string_view padding_field = "_";

/** \brief The limits of one cloud: an index fits into 32 bits with room to spare, and
 * so does an offset into the data, which PCL keeps there. */
constexpr std::uint64_t max_points = std::uint64_t{1} << 28;
constexpr std::uint64_t max_bytes = std::numeric_limits<std::uint32_t>::max();

/** \brief Read a PCD file, strictly: everything is checked against the size of the file
 * before memory is taken for it. (pcl::PCDReader crashes on some malformed files, and
 * accepts others.)
 * \throws InputError that names the path, what is wrong, and what is expected */
CloudFile readCloud(const std::string& path);

/** \brief The same of a file that was read already. */
CloudFile decodePcd(const std::string& path, std::string_view file);

/** \brief What a header says of a file whose points follow one after the other. */
struct PointRows {
  CloudFile cloud; ///< all but the points
  bool is_text = false;
  std::uint64_t begin = 0; ///< of the points in the file
};

/** \brief The header of a PCD file, of any number of points; nothing if its points are
 * compressed. \param[in] head the first bytes of the file, with all of the header */
std::optional<PointRows> rowsOfPcd(const std::string& path, std::string_view head);

/** \brief After the points of a file are read: leave padding out, and use PCL's names.
 */
void finishPcd(CloudFile& cloud);

/** \brief What is before the points in encodeCloud(), and the points; not compressed.
 */
std::string encodePcdHeader(const CloudFile& cloud, PCDFormat format);
std::string encodePcdPoints(const CloudFile& cloud, PCDFormat format);

/** \brief The bytes of a PCD file. Numbers in text read back as the same numbers. */
std::string encodeCloud(const CloudFile& cloud, PCDFormat format);

/** \brief Fill a cloud whose fields and size are known: one row of text a point. */
void readAsciiPoints(CloudFile& cloud, std::string_view body);

/** \brief The same from packed bytes, little-endian. */
void readBinaryPoints(CloudFile& cloud, std::string_view body);

} // namespace pcl::app
