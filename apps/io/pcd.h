// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// PURPOSE

#pragma once

#include "io/cloud_file.h"

#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace pcl::app {

/** \brief The LZF format of `DATA binary_compressed`: a run of literals is a byte n <
 * 32 and n + 1 bytes; a match is 3 bits of length - 2 (7: a byte more follows, which
 * adds to it) and 13 bits of distance - 1. Nothing is read or written out of bounds. */
std::string lzfCompress(const std::vector<std::uint8_t>& input);

/** \return whether the input is well-formed and gives exactly `size` bytes, in `output`
 */
bool lzfDecompress(const std::uint8_t* input,
                   std::size_t input_size,
                   std::size_t size,
                   std::vector<std::uint8_t>& output);

/** \brief No input of this size decompresses to more. */
constexpr std::uint64_t
lzfMostBytes(std::uint64_t input_size)
{
  constexpr std::uint64_t longest_match = 264;
  constexpr std::uint64_t bytes_of_longest_match = 3;
  return (input_size / bytes_of_longest_match + 1) * longest_match;
}

enum class PCDFormat { ascii, binary, binary_compressed };

/** \brief The name of the fields that only keep others aligned. */
constexpr std::string_view padding_field = "_";

/** \brief The word of the DATA line. */
const char* nameOf(PCDFormat format);

std::optional<PCDFormat> formatOf(std::string_view name);

/** \brief I, U or F. */
char typeLetter(std::uint8_t datatype);

/** \brief The pcl::PCLPointField type of a TYPE and a SIZE, if there is one. */
std::optional<std::uint8_t> datatypeOf(std::string_view type, std::string_view size);

/** \brief What is read of one cloud at most. */
constexpr std::uint64_t most_points = std::uint64_t{1} << 28;
constexpr std::uint64_t most_bytes = std::numeric_limits<std::uint32_t>::max();

/** \brief A PCD header that is consistent in itself. */
struct PCDHeader {
  CloudFile cloud; ///< fields, size, viewpoint; no data yet
  PCDFormat format = PCDFormat::ascii;
  std::size_t body = 0; ///< offset of the data in the file
};

/** \brief Read the header at the begin of a file.
 * \throws InputError that names the path, what is wrong, and what is allowed */
PCDHeader parseHeader(const std::string& path, std::string_view file);

/** \brief Read a PCD file, strictly: everything is checked against the size of the file
 * before memory is taken for it. (pcl::PCDReader crashes on some malformed files, and
 * accepts others.)
 * \throws InputError that names the path, what is wrong, and what is allowed */
CloudFile readCloud(const std::string& path);

/** \brief The same of a file that was read already. */
CloudFile decodePcd(const std::string& path, std::string_view file);

/** \brief Fill a cloud whose fields and size are known: one row of text a point. */
void readAsciiPoints(CloudFile& cloud, std::string_view body);

/** \brief The same from packed bytes, little-endian. */
void readBinaryPoints(CloudFile& cloud, std::string_view body);

/** \brief Whether a number that is out of range is too small rather than too large. */
inline bool
isTiny(std::string_view word)
{
  double value = 0.0;
  const auto result = std::from_chars(word.data(), word.data() + word.size(), value);
  return result.ec == std::errc() && std::abs(value) < 1.0;
}

/** \brief The whole word as a number of this type, if it is one. */
template <typename T>
std::optional<T>
parseInteger(std::string_view word)
{
  T value{};
  const char* const end = word.data() + word.size();
  const auto [stop, error] = std::from_chars(word.data(), end, value);
  if (error != std::errc() || stop != end)
    return std::nullopt;
  return value;
}

/** \brief The same for nan, inf and what is in the range of the type; what is closer to
 * 0 than its smallest number is 0. */
template <typename T>
std::optional<T>
parseFloating(std::string_view word)
{
  T value{};
  const char* const end = word.data() + word.size();
  const auto [stop, error] = std::from_chars(word.data(), end, value);
  if (stop != end || error == std::errc::invalid_argument)
    return std::nullopt;
  if (error == std::errc::result_out_of_range)
    return isTiny(word) ? std::optional<T>(T{0}) : std::nullopt;
  return value;
}

/** \brief Write the shortest text that reads as the same number. */
template <typename T>
void
appendNumber(T value, std::string& text)
{
  constexpr std::size_t longest = 32;
  char digits[longest];
  const auto result = std::to_chars(digits, digits + longest, value);
  text.append(digits, result.ptr);
}

/** \brief A word of a file for a message: printable and short. */
std::string quoted(std::string_view word);

/** \brief The words of a line. */
std::vector<std::string_view> splitWords(std::string_view line);

/** \brief Take the first line, without its end, off the text. */
std::string_view takeLine(std::string_view& text);

/** \brief The bytes of a PCD file. Numbers in text read back as the same numbers. */
std::string encodeCloud(const CloudFile& cloud, PCDFormat format);

} // namespace pcl::app
