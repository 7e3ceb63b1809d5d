// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// PURPOSE

#pragma once

#include "sweep/sweep_block.h"

#include <cstddef>
#include <cstdint>

namespace pcl::kernels {

/** Offsets are counted in 2^-20 of a power of two that is at least the radius; products
 * of two take up to 44 bits, and are added up as two halves. */
constexpr int offset_bits = 20;
constexpr int half_bits = 22;

/** \brief What is added up over neighbors: three offsets, and six products in halves.
 */
enum Moment : std::size_t {
  sum_x,
  sum_y,
  sum_z,
  low_xx,
  low_xy,
  low_xz,
  low_yy,
  low_yz,
  low_zz,
  high_xx,
  high_xy,
  high_xz,
  high_yy,
  high_yz,
  high_zz,
  moment_count
};

/** \brief Moments of the neighbors of a block's queries, about one origin. */
struct alignas(64) BlockMoments {
  std::uint64_t count[block_size];
  std::uint64_t values[moment_count][block_size];
  double own[3][block_size]; ///< the queries, in units from the origin
  double origin[3];          ///< in units, below all neighbors
};

/** \brief Covariances of a block's neighborhoods, in units^2 that are the same for all.
 */
struct alignas(64) BlockCovariances {
  double xx[block_size], xy[block_size], xz[block_size];
  double yy[block_size], yz[block_size], zz[block_size];
};

} // namespace pcl::kernels
