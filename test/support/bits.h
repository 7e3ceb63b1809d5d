// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Comparing floats bit by bit.

#pragma once

#include <cstring>
#include <vector>

namespace pcl {
namespace test {

inline bool
sameBits(const std::vector<float>& a, const std::vector<float>& b)
{
  return a.size() == b.size() &&
         std::memcmp(a.data(), b.data(), a.size() * sizeof(float)) == 0;
}

} // namespace test
} // namespace pcl
