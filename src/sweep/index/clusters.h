// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// PURPOSE

#pragma once

#include "sweep/sweep_block.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace pcl::kernels {

struct RowIndex;

/** \brief Up to block_size consecutive points of a row, not far apart, and the box
 * around them: what distance tests look at first, and what queries are taken by.
 */
struct Clusters {
  std::vector<std::uint32_t> begin; ///< first point of each, and an end mark
  /** least x, y, z, then most x, y, z; padded with block_size more */
  std::array<std::vector<float>, 6> box;

  std::size_t
  size() const
  {
    return begin.empty() ? 0 : begin.size() - 1;
  }
};

/** \brief Split the sorted points of an index into clusters. Sets its rows' clusters.
 */
void makeClusters(RowIndex& index, unsigned threads);

} // namespace pcl::kernels
