// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Results of the sweep in vectors.

#pragma once

#include <pcl/features/neighborhood_sweep.h>

#include <vector>

namespace pcl {
namespace test {

/** \brief Results of the sweep in vectors. */
inline std::vector<float>
sweptINAD(const NeighborhoodSweep& sweep,
          const NeighborhoodSize& size,
          const XYZView& normals,
          double outlier_rate = 2.0)
{
  std::vector<float> mu_sigma(2 * sweep.size(), -1.0f);
  sweep.computeINAD(size, normals, outlier_rate, mu_sigma.data());
  return mu_sigma;
}

/** \brief Three floats of normal and one of curvature for each query. */
inline std::vector<float>
sweptNormals(const NeighborhoodSweep& sweep, const NeighborhoodSize& size)
{
  std::vector<float> normals(4 * sweep.size(), -2.0f);
  float* const curvatures = normals.empty() ? nullptr : &normals[3];
  sweep.computeNormals(size, normals.data(), curvatures, 4);
  return normals;
}

inline std::vector<std::uint32_t>
sweptCounts(const NeighborhoodSweep& sweep, const NeighborhoodSize& size)
{
  std::vector<std::uint32_t> counts(sweep.size(), 0xffffffff);
  sweep.countNeighbors(size, counts.data());
  return counts;
}

} // namespace test
} // namespace pcl
