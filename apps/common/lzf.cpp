/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * Point Cloud Library (PCL) - www.pointclouds.org
 * Copyright (c) 2026, pcl_shape contributors
 *
 * All rights reserved
 */

#include "lzf.h"

#include <algorithm>
#include <array>

namespace pcl::app {
namespace {

constexpr std::size_t most_literals = 32;
constexpr std::size_t least_match = 3;
constexpr std::size_t most_match = 264;
constexpr std::size_t most_distance = 8192;
constexpr unsigned length_shift = 5;
constexpr unsigned long_length = 7;
constexpr unsigned hash_bits = 16;

/** Where each three bytes were seen last, plus one. */
using Seen = std::vector<std::size_t>;

std::size_t
hashOf(const std::uint8_t* bytes)
{
  const std::uint32_t three =
      bytes[0] | std::uint32_t{bytes[1]} << 8 | std::uint32_t{bytes[2]} << 16;
  constexpr std::uint32_t golden_ratio = 2654435769u;
  return (three * golden_ratio) >> (32 - hash_bits);
}

std::size_t
matchLength(const std::vector<std::uint8_t>& input, std::size_t from, std::size_t at)
{
  const std::size_t most = std::min(most_match, input.size() - at);
  std::size_t length = 0;
  while (length < most && input[from + length] == input[at + length])
    ++length;
  return length;
}

void
writeLiterals(const std::vector<std::uint8_t>& input,
              std::size_t begin,
              std::size_t end,
              std::string& output)
{
  while (begin < end) {
    const std::size_t count = std::min(end - begin, most_literals);
    output.push_back(static_cast<char>(count - 1));
    output.append(reinterpret_cast<const char*>(input.data() + begin), count);
    begin += count;
  }
}

void
writeMatch(std::size_t length, std::size_t distance, std::string& output)
{
  const std::size_t code = length - 2;
  const std::size_t offset = distance - 1;
  const std::size_t top = std::min<std::size_t>(code, long_length);
  output.push_back(static_cast<char>(top << length_shift | offset >> 8));
  if (code >= long_length)
    output.push_back(static_cast<char>(code - long_length));
  output.push_back(static_cast<char>(offset & 0xff));
}

} // namespace

std::string
lzfCompress(const std::vector<std::uint8_t>& input)
{
  std::string output;
  output.reserve(input.size() / 2);
  Seen seen(std::size_t{1} << hash_bits, 0);
  std::size_t literals = 0;
  std::size_t at = 0;
  while (at + least_match <= input.size()) {
    std::size_t& last = seen[hashOf(input.data() + at)];
    const std::size_t from = last == 0 ? at : last - 1;
    last = at + 1;
    const std::size_t distance = at - from;
    const bool near = distance > 0 && distance <= most_distance;
    const std::size_t length = near ? matchLength(input, from, at) : 0;
    if (length < least_match) {
      ++at;
      continue;
    }
    writeLiterals(input, literals, at, output);
    writeMatch(length, distance, output);
    at += length;
    literals = at;
  }
  writeLiterals(input, literals, input.size(), output);
  return output;
}

bool
lzfDecompress(const std::uint8_t* input,
              std::size_t input_size,
              std::size_t size,
              std::vector<std::uint8_t>& output)
{
  output.clear();
  output.reserve(size);
  const std::uint8_t* const end = input + input_size;
  while (input < end) {
    const unsigned control = *input++;
    if (control < most_literals) {
      const std::size_t count = control + 1;
      if (count > static_cast<std::size_t>(end - input) || count > size - output.size())
        return false;
      output.insert(output.end(), input, input + count);
      input += count;
      continue;
    }
    const unsigned code = control >> length_shift;
    const std::size_t bytes_left = static_cast<std::size_t>(end - input);
    if (bytes_left < (code == long_length ? 2u : 1u))
      return false;
    const std::size_t length = 2 + code + (code == long_length ? *input++ : 0u);
    const std::size_t distance = 1 + ((control & 0x1fu) << 8 | *input++);
    if (distance > output.size() || length > size - output.size())
      return false;
    for (std::size_t i = 0; i < length; ++i)
      output.push_back(output[output.size() - distance]);
  }
  return output.size() == size;
}

} // namespace pcl::app
