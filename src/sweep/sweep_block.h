// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// A block of queries with the points around them, and the kernels that work on it.

#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>

namespace pcl::kernels {

/** \brief Queries of a block, points of a cluster: the floats of an AVX-512 vector. */
constexpr std::size_t block_size = 16;

constexpr float nan = std::numeric_limits<float>::quiet_NaN();

/** \brief A range of clusters [begin, end) of surface points (row_index.h). */
struct ClusterRun {
  std::uint32_t begin;
  std::uint32_t end;
  std::int32_t layer; ///< the z cell of the row that it is in
};

struct Box {
  float x_min, x_max, y_min, y_max, z_min, z_max;
};

/** \brief Some queries that are close together, and the runs of clusters that
 * hold all their neighbors: what a kernel works on.
 *
 * Surface point j is a neighbor of query i if d2 < r2[i], or if d2 == tie_d2[i] and
 * order[j] <= tie_index[i] (of k nearest points, ties go to the smaller index).
 */
struct SweepBlock {
  const float *x = nullptr, *y = nullptr, *z = nullptr;    ///< surface, sorted
  const float *nx = nullptr, *ny = nullptr, *nz = nullptr; ///< its unit normals, or NaN
  const std::uint32_t* order = nullptr;                    ///< its original indices
  const std::uint32_t* cluster_begin = nullptr; ///< first point of each cluster
  const float* cluster_box[6] = {};             ///< min x, y, z; max x, y, z
  const ClusterRun* runs = nullptr;
  std::size_t run_count = 0;

  std::size_t size = 0; ///< number of queries
  Box box{};            ///< of the queries
  /** Queries, and behind them whatever comes next: its r2 is 0. */
  float qx[block_size] = {}, qy[block_size] = {}, qz[block_size] = {};
  /** Normals of the queries, if queries_on_surface. */
  float qnx[block_size] = {}, qny[block_size] = {}, qnz[block_size] = {};
  float r2[block_size] = {};
  float tie_d2[block_size] = {};
  std::uint32_t tie_index[block_size] = {};
  float kth_d2[block_size] = {};  ///< set by nearest()
  bool queries_on_surface = true; ///< each query is a surface point
  bool rows_by_radius = false;    ///< rows, and so the order of points, follow from r2
};

struct NormalResult {
  float x, y, z, curvature;
};

constexpr NormalResult unknown_normal{nan, nan, nan, nan};

struct INADResult {
  float mu, sigma;
};

constexpr INADResult unknown_inad{nan, nan};

/** \brief The functions that a target (instruction set) provides. */
struct KernelTable {
  void (*normals)(const SweepBlock&, NormalResult*);
  void (*inad)(const SweepBlock&, double outlier_rate, INADResult*);
  void (*count)(const SweepBlock&, std::uint32_t*);
  /** Narrow each query's neighbors, which are given by r2, to the k nearest, and set
   * kth_d2. False if some query has fewer than k: it is left as it is, with kth_d2 NaN.
   */
  bool (*nearest)(SweepBlock&, std::size_t k);
  /** The cells (row_index.h) of finite coordinates, a multiple of block_size of them.
   */
  void (*cells)(const float* coordinates,
                std::size_t count,
                double cells_per_meter,
                std::int32_t* cells);
  /** How many of the first `count` values, at most block_size, are less than the bound.
   * block_size are read. */
  std::uint32_t (*countLess)(const float* values, std::size_t count, float bound);
};

/** \brief Plain C++, for any processor. */
const KernelTable& portableKernels();

/** \brief What a query knows of the surface at its own place. */
struct OwnPoints {
  float nx[block_size], ny[block_size], nz[block_size]; ///< normals, or NaN
  std::uint32_t is_neighbor[block_size]; ///< 1 if the query's own point counts, else 0
};

/** \brief The own points of a block with normals, from its runs where needed. */
OwnPoints ownPointsOf(const SweepBlock& block);

/** \brief Whether the neighbors of a query spread over a surface (neighborhood.h). */
bool spansSurface(const SweepBlock& block, std::size_t query);

/** \brief The normal of one query, by the portable kernel. */
NormalResult normalAt(const SweepBlock& block, std::size_t query);

/** \brief Whether one of its neighbors is at the query's position. */
bool isAtSurfacePoint(const SweepBlock& block, std::size_t query);

} // namespace pcl::kernels
