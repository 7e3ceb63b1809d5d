// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// The statistics of the sweep over neighbors that a search method lists.

#pragma once

#include <pcl/features/neighborhood_sweep.h>
#include <pcl/types.h>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <utility>

namespace pcl::detail {

/** \brief The statistics of NeighborhoodSweep over neighbors that somebody else finds:
 * what the features use when a search method is set.
 */
class PCL_SHAPE_EXPORTS ListedNeighborhoods {
public:
  /** \brief Writes the indices of the surface points around the query that is at this
   * position of the results. Called from several threads at once, for finite queries
   * only. */
  using Find = std::function<void(std::size_t position, pcl::Indices&)>;

  /** \param[in] surface the points that `find` finds; not copied
   * \param[in] find finds the neighbors */
  ListedNeighborhoods(const XYZView& surface, Find find)
  : surface_(surface)
  , find_(std::move(find))
  {}

  /** \brief Ask about these points instead of the surface's own. */
  void
  setQueries(const XYZView& queries)
  {
    queries_ = queries;
    own_queries_ = true;
  }

  /** \copydoc NeighborhoodSweep::setQueryIndices */
  void
  setQueryIndices(const std::int32_t* indices, std::size_t size)
  {
    indices_ = indices;
    indices_size_ = size;
    has_indices_ = true;
  }

  /** \brief How many queries there are. */
  std::size_t
  size() const
  {
    return has_indices_ ? indices_size_
                        : (own_queries_ ? queries_.size : surface_.size);
  }

  /** \param[in] threads 0 for all cores */
  void
  setNumberOfThreads(unsigned threads)
  {
    threads_ = threads;
  }

  /** \brief As NeighborhoodSweep::computeNormals(). */
  bool computeNormals(float* normals, float* curvature, std::size_t stride) const;

  /** \brief As NeighborhoodSweep::computeINAD(). */
  bool computeINAD(const XYZView& normals, double outlier_rate, float* mu_sigma) const;

private:
  template <typename Visit>
  void forEachQuery(const Visit& visit) const;

  XYZView surface_;
  Find find_;
  XYZView queries_;
  bool own_queries_ = false;
  const std::int32_t* indices_ = nullptr;
  std::size_t indices_size_ = 0;
  bool has_indices_ = false;
  unsigned threads_ = 0;
};

} // namespace pcl::detail
