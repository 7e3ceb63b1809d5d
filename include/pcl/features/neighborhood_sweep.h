/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * Point Cloud Library (PCL) - www.pointclouds.org
 * Copyright (c) 2026, pcl_shape contributors
 *
 * All rights reserved
 */

#pragma once

#include <pcl/features/xyz_view.h>
#include <pcl/pcl_shape_exports.h>

#include <cstddef>
#include <cstdint>
#include <memory>

namespace pcl {

class SweepIndex;

/** \brief The extent of a neighborhood: exactly one of the three is set. */
struct NeighborhoodSize {
  double radius = 0.0;          ///< meters, the same for every query
  const float* radii = nullptr; ///< meters, one for every query
  std::size_t k = 0;            ///< nearest points, the query's own point included

  /** \brief One radius for every query. \param[in] radius meters, above 0 */
  static NeighborhoodSize
  ofRadius(double radius)
  {
    return {radius, nullptr, 0};
  }

  /** \brief A radius for each query. \param[in] radii meters, above 0; not copied */
  static NeighborhoodSize
  ofRadii(const float* radii)
  {
    return {0.0, radii, 0};
  }

  /** \brief So many nearest points. \param[in] k the query's own point included */
  static NeighborhoodSize
  ofNearest(std::size_t k)
  {
    return {0.0, nullptr, k};
  }
};

/** \brief Statistics over the neighborhoods of many points at once, without a search
 * tree.
 *
 * The finite points of a surface are sorted into rows of cells. The neighbors of a
 * query are a few contiguous runs of them, consumed where they are found: no list of
 * neighbors is ever stored. The class works on plain arrays, without PCL's types.
 *
 * A neighbor is a finite surface point with
 * `(dx*dx + dy*dy) + dz*dz < (float)(r*r)`, in float and without fused operations: the
 * rule of pcl::KdTreeFLANN. Of k nearest points, ties go to the smaller index.
 * A query's own point is left out of its INAD: by its index if the queries are points
 * of the surface (setQueryIndices(), or no queries set), otherwise the nearest surface
 * point at distance 0, once.
 *
 * Angles are added up as whole numbers of 2^-23 rad, exactly, and so are products of
 * offsets, in 2^-20 of a power of two above the radius. Only normals with one radius
 * for all points use sums of floats, by cells that follow from the radius, and by x, y
 * and z in them. Either way a result depends on the neighbors of its point only: not on
 * the order of the points (but for ties, see above and computeINAD()), nor on the
 * number of threads, nor on points further away.
 *
 * Fewer than five neighbors besides the point itself, or neighbors on a line through it
 * or at one place, give NaN. Positions are in meters, angles in radians.
 *
 * All methods that compute or count throw std::invalid_argument unless exactly one of
 * radius, radii and k is set, each radius is positive and finite, k is 1 to the number
 * of finite surface points, and there are at most 2^31 - 1 points and queries.
 * computeINAD() also needs one normal for each surface point, and an outlier rate that
 * is 0 or positive and finite. \ingroup features
 */
class PCL_SHAPE_EXPORTS NeighborhoodSweep {
public:
  /** \brief Fewer neighbors than this, besides the point itself, give NaN. */
  static constexpr std::size_t min_neighbors = 5;

  /** \param[in] surface the points to find neighbors among; not copied, points that are
   * not finite are passed over */
  explicit NeighborhoodSweep(const XYZView& surface) : surface_(surface) {}

  /** \brief Ask about these points instead of the surface's own. */
  void
  setQueries(const XYZView& queries)
  {
    queries_ = queries;
    own_queries_ = true;
  }

  /** \brief Ask about some points of the query cloud only (of the surface, if no
   * queries are set).
   * \param[in] indices of the points, in the order of the results; not copied and not
   * checked: the caller sees to it that each is a point's
   * \param[in] size how many there are */
  void
  setQueryIndices(const std::int32_t* indices, std::size_t size)
  {
    indices_ = indices;
    indices_size_ = size;
    has_indices_ = true;
  }

  /** \param[in] threads 0 for all cores */
  void
  setNumberOfThreads(unsigned threads)
  {
    threads_ = threads;
  }

  /** \brief Use the surface as it was sorted before, if it is the same, and keep what
   * is sorted here.
   * \param[in] index null to sort at each call */
  void
  setIndex(const std::shared_ptr<SweepIndex>& index)
  {
    index_ = index;
  }

  /** \brief The number of results. */
  std::size_t
  size() const
  {
    return has_indices_ ? indices_size_
                        : (own_queries_ ? queries_.size : surface_.size);
  }

  /** \brief Normals by principal component analysis of the neighbors and the point
   * itself.
   * \param[in] neighborhood of each query
   * \param[out] normals unit vectors of either sign, three floats every `stride` floats
   * \param[out] curvature surface variation l0 / (l0 + l1 + l2), one every `stride`
   * \param[in] stride floats from one result to the next
   * \return whether all results are finite */
  bool computeNormals(const NeighborhoodSize& neighborhood,
                      float* normals,
                      float* curvature,
                      std::size_t stride) const;

  /** \brief Mean and standard deviation of the angles between a point's normal and its
   * neighbors' (INAD).
   *
   * With a_ij = acos |n_i . n_j| over the neighbors j: mu = mean, sigma = population
   * standard deviation; then, once, over the a_ij with |a_ij - mu| <= c sigma (1 +
   * 1e-5). Neighbors without a finite normal do not count. If the queries are not
   * points of the surface, n_i is the normal of the nearest surface point in the
   * neighborhood.
   * \param[in] neighborhood of each query
   * \param[in] normals one for each surface point, of any length but 0
   * \param[in] outlier_rate c, 0 for no rejection
   * \param[out] mu_sigma two floats for each query
   * \return whether all results are finite */
  bool computeINAD(const NeighborhoodSize& neighborhood,
                   const XYZView& normals,
                   double outlier_rate,
                   float* mu_sigma) const;

  /** \brief The number of neighbors of each query, its own point not counted.
   * \param[in] neighborhood of each query
   * \param[out] counts one for each query, 0 for a query that is not finite */
  void countNeighbors(const NeighborhoodSize& neighborhood,
                      std::uint32_t* counts) const;

  /** \brief The distance from each query to the k-th nearest surface point, its own
   * point counted as the first.
   * \param[in] k 1 or more
   * \param[out] distances one for each query, NaN for a query that is not finite */
  void computeDistanceToNearest(std::size_t k, float* distances) const;

private:
  class Prepared;

  const XYZView&
  queryPoints() const
  {
    return own_queries_ ? queries_ : surface_;
  }

  /** \brief The surface point that is the query at this position of the results. */
  std::size_t
  surfaceIndex(std::size_t position) const
  {
    return has_indices_ ? static_cast<std::size_t>(indices_[position]) : position;
  }

  XYZView surface_;
  XYZView queries_;
  bool own_queries_ = false;
  bool has_indices_ = false;
  const std::int32_t* indices_ = nullptr;
  std::size_t indices_size_ = 0;
  unsigned threads_ = 0;
  std::shared_ptr<SweepIndex> index_;
};

} // namespace pcl
