/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * Point Cloud Library (PCL) - www.pointclouds.org
 * Copyright (c) 2026, pcl_shape contributors
 *
 * All rights reserved
 */

#pragma once

#include <pcl/features/adaptive_radius.h>
#include <pcl/features/sweep_index.h>
#include <pcl/point_cloud.h>
#include <pcl/search/search.h>
#include <pcl/types.h>

#include <cstdint>
#include <cstring>
#include <functional>
#include <string>
#include <vector>

namespace pcl::detail {

/** \brief The coordinates of a cloud, in place. */
template <typename PointT>
XYZView
xyzOf(const pcl::PointCloud<PointT>& cloud)
{
  static_assert(sizeof(PointT) % sizeof(float) == 0, "points must be rows of floats");
  return {cloud.empty() ? nullptr : &cloud[0].x,
          sizeof(PointT) / sizeof(float),
          cloud.size()};
}

/** \brief The normals of a cloud, in place. */
template <typename PointNT>
XYZView
normalsOf(const pcl::PointCloud<PointNT>& cloud)
{
  static_assert(sizeof(PointNT) % sizeof(float) == 0, "points must be rows of floats");
  return {cloud.empty() ? nullptr : &cloud[0].normal_x,
          sizeof(PointNT) / sizeof(float),
          cloud.size()};
}

/** \brief Where neighbors are looked for, and how. */
struct NeighborhoodRequest {
  XYZView input;
  XYZView surface;
  const pcl::Indices* indices = nullptr; ///< of the input
  double radius = 0.0;                   ///< meters, 0 if k is given
  int k = 0;                             ///< 0 if the radius is given
};

/** \brief What is wrong with a request: names the parameter, its value, and what it
 * must be. Empty if nothing is. */
PCL_SHAPE_EXPORTS std::string problemOf(const NeighborhoodRequest& request);

/** \brief As above, for one value per surface point. */
PCL_SHAPE_EXPORTS std::string problemOfNormals(std::size_t normals,
                                               std::size_t surface);

PCL_SHAPE_EXPORTS std::string problemOfOutlierRate(double rate);

PCL_SHAPE_EXPORTS std::size_t countFinite(const XYZView& points);

/** \brief body(begin, end) for consecutive parts of [0, count).
 * \param[in] threads 0 for all cores */
PCL_SHAPE_EXPORTS void
forEachPart(std::size_t count,
            unsigned threads,
            const std::function<void(std::size_t, std::size_t)>& body);

/** \brief Finds the surface points around an input point: the k nearest, or those
 * within the radius if k is 0. Several threads call it at once. */
using NeighborFinder = std::function<void(pcl::index_t point,
                                          double radius,
                                          int k,
                                          pcl::Indices& found,
                                          std::vector<float>& squared_distances)>;

/** \brief A finder that asks a search method, which gets the surface here: it would
 * notice another cloud, but not one that was edited in place. Empty without a method.
 */
template <typename PointT>
NeighborFinder
finderOf(const typename pcl::search::Search<PointT>::Ptr& search,
         const typename pcl::PointCloud<PointT>::ConstPtr& input,
         const typename pcl::PointCloud<PointT>::ConstPtr& surface)
{
  if (!search)
    return {};
  const auto known = search->getInputCloud();
  const bool is_copy = known && !known->is_dense && surface->is_dense &&
                       known->size() == surface->size() &&
                       std::memcmp(known->points.data(),
                                   surface->points.data(),
                                   surface->size() * sizeof(PointT)) == 0;
  auto honest = surface;
  if (surface->is_dense && countFinite(xyzOf(*surface)) != surface->size()) {
    // Some methods abort on a NaN in a cloud that says it has none.
    const auto copy = pcl::make_shared<pcl::PointCloud<PointT>>(*surface);
    copy->is_dense = false;
    honest = copy;
  }
  search->setInputCloud(honest,
                        known == surface || is_copy ? search->getIndices() : nullptr);
  return [search, input](pcl::index_t point,
                         double radius,
                         int k,
                         pcl::Indices& found,
                         std::vector<float>& squared_distances) {
    if (k > 0)
      search->nearestKSearch(*input, point, k, found, squared_distances);
    else
      search->radiusSearch(*input, point, radius, found, squared_distances);
  };
}

/** \brief Statistics over the neighborhoods of points of one cloud among the points of
 * another, or of the same one: of the neighbors that a finder gives, else by the sweep.
 * See pcl::NeighborhoodSweep for what each method does. */
class PCL_SHAPE_EXPORTS Neighborhoods {
public:
  /** \brief Of all points of a cloud among themselves. */
  Neighborhoods(const XYZView& points, unsigned threads)
  : input_(points)
  , surface_(points)
  , threads_(threads)
  {}

  /** \param[in] indices of the input, which must outlive this */
  Neighborhoods(const XYZView& input,
                const XYZView& surface,
                const pcl::Indices& indices,
                unsigned threads);

  void
  setFinder(const NeighborFinder& finder)
  {
    finder_ = finder;
  }

  /** \brief Of several computations the first sorts the surface, for those of others
   * too. Null for an index of its own. */
  void
  setIndex(const SweepIndex::Ptr& index)
  {
    index_ = index ? index : std::make_shared<SweepIndex>();
  }

  const XYZView&
  input() const
  {
    return input_;
  }

  /** \brief How many there are. */
  std::size_t
  size() const
  {
    return indices_ ? indices_->size() : input_.size;
  }

  /** \brief The point of the input that the one at this position is of. */
  pcl::index_t
  pointAt(std::size_t position) const
  {
    return indices_ ? (*indices_)[position] : static_cast<pcl::index_t>(position);
  }

  /** \brief The same for some of the points only, which must outlive the result. */
  Neighborhoods among(const pcl::Indices& points) const;

  bool computeNormals(const NeighborhoodSize& size,
                      float* normals,
                      float* curvature,
                      std::size_t stride) const;

  bool computeINAD(const NeighborhoodSize& size,
                   const XYZView& normals,
                   double outlier_rate,
                   float* mu_sigma) const;

  /** \param[in] k capped at the number of finite surface points */
  void computeDistanceToNearest(std::size_t k, float* distances) const;

  /** \brief The extent of the neighborhoods in meters, within what a float can be.
   * \param[out] radii where they differ from point to point, what holds them */
  NeighborhoodSize sizeOf(double radius,
                          int k,
                          AdaptiveRadius::RadiusMode mode,
                          std::vector<float>& radii) const;

private:
  NeighborhoodSweep sweep() const;
  template <typename Visit>
  void forEachListed(const NeighborhoodSize& size, const Visit& visit) const;
  bool computeListedNormals(const NeighborhoodSize& size,
                            float* normals,
                            float* curvature,
                            std::size_t stride) const;
  bool computeListedINAD(const NeighborhoodSize& size,
                         const XYZView& normals,
                         double outlier_rate,
                         float* mu_sigma) const;

  XYZView input_;
  XYZView surface_;
  const pcl::Indices* indices_ = nullptr;    ///< null for all
  std::vector<std::int32_t> narrow_indices_; ///< where PCL's have another type
  unsigned threads_;
  NeighborFinder finder_;
  SweepIndex::Ptr index_ = std::make_shared<SweepIndex>();
};

} // namespace pcl::detail
