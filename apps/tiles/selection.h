// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// One of the sorted values of more floats than fit into memory.

#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <vector>

namespace pcl::app {

/** \brief Floats of 0 and more are in the order of their bits. */
inline std::uint32_t
keyOfFloat(float value)
{
  std::uint32_t key = 0;
  std::memcpy(&key, &value, sizeof key);
  return key;
}

/** \brief The value that as many are below as the rank says. \param[in] forEach calls a
 * function for each value, which is not negative, and how many times it is there; it is
 * called twice */
template <typename ForEach>
float
selected(std::uint64_t rank, const ForEach& forEach)
{
  constexpr int bits = 16;
  constexpr std::uint32_t digit_mask = (1U << bits) - 1;
  std::vector<std::uint64_t> counts(std::size_t{1} << bits, 0);
  const auto find = [&] {
    std::uint32_t digit = 0;
    while (rank >= counts[digit])
      rank -= counts[digit++];
    return digit;
  };
  forEach([&](float value, std::uint64_t count) {
    counts[keyOfFloat(value) >> bits] += count;
  });
  const std::uint32_t high = find();
  counts.assign(counts.size(), 0);
  forEach([&](float value, std::uint64_t count) {
    if (keyOfFloat(value) >> bits == high)
      counts[keyOfFloat(value) & digit_mask] += count;
  });
  const std::uint32_t key = high << bits | find();
  float value = 0.0f;
  std::memcpy(&value, &key, sizeof value);
  return value;
}

} // namespace pcl::app
