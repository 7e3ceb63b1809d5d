/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * Point Cloud Library (PCL) - www.pointclouds.org
 * Copyright (c) 2026, pcl_shape contributors
 *
 * All rights reserved
 */

#pragma once

#include <cstdint>
#include <string>
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

} // namespace pcl::app
