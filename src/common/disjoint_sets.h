// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Sets that are united step by step (union-find).

#pragma once

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <vector>

namespace pcl::segmentation {

/** \brief A forest whose trees are sets of points; each root is its smallest index. */
class DisjointSets {
public:
  explicit DisjointSets(std::size_t size) : parent_(size)
  {
    std::iota(parent_.begin(), parent_.end(), 0U);
  }

  std::uint32_t
  find(std::uint32_t i)
  {
    while (parent_[i] != i)
      i = parent_[i] = parent_[parent_[i]];
    return i;
  }

  void
  unite(std::uint32_t i, std::uint32_t j)
  {
    i = find(i);
    j = find(j);
    parent_[std::max(i, j)] = std::min(i, j);
  }

private:
  std::vector<std::uint32_t> parent_;
};

} // namespace pcl::segmentation
