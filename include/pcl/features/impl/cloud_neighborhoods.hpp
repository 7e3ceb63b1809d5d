/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * Point Cloud Library (PCL) - www.pointclouds.org
 * Copyright (c) 2026, pcl_shape contributors
 *
 * All rights reserved
 */

#pragma once

#include <pcl/common/point_tests.h>
#include <pcl/features/adaptive_radius.h>
#include <pcl/features/listed_neighborhoods.h>
#include <pcl/features/neighborhood_sweep.h>
#include <pcl/features/sweep_index.h>
#include <pcl/point_cloud.h>
#include <pcl/search/search.h>
#include <pcl/features/impl/neighborhood_request.hpp>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <memory>
#include <numeric>
#include <string>
#include <vector>

namespace pcl::detail {

/** \brief Neighborhoods of points of one cloud among the points of another, or of the
 * same one: by a search method if there is one, else by the sweep. */
template <typename PointT>
class CloudNeighborhoods : public NeighborhoodStatistics {
public:
  using Cloud = pcl::PointCloud<PointT>;
  using CloudConstPtr = typename Cloud::ConstPtr;
  using SearchPtr = typename pcl::search::Search<PointT>::Ptr;

  CloudNeighborhoods(const CloudConstPtr& input,
                     const CloudConstPtr& surface,
                     const pcl::Indices& indices,
                     unsigned threads)
  : input_(input)
  , surface_(surface)
  , indices_(indices)
  , threads_(threads)
  {}

  void
  setSearch(const SearchPtr& search)
  {
    search_ = search;
  }

  /** \brief Of several computations the first sorts the surface, for those of others
   * too. Null for an index of its own. */
  void
  setIndex(const SweepIndex::Ptr& index)
  {
    index_ = index ? index : std::make_shared<SweepIndex>();
  }

  bool
  computeNormals(const NeighborhoodSize& size,
                 float* normals,
                 float* curvature,
                 std::size_t stride) const override
  {
    if (search_)
      return listed(size).computeNormals(normals, curvature, stride);
    return swept().computeNormals(size, normals, curvature, stride);
  }

  bool
  computeINAD(const NeighborhoodSize& size,
              const XYZView& normals,
              double outlier_rate,
              float* mu_sigma) const override
  {
    if (search_)
      return listed(size).computeINAD(normals, outlier_rate, mu_sigma);
    return swept().computeINAD(size, normals, outlier_rate, mu_sigma);
  }

  void
  computeDistanceToNearest(std::size_t k, float* distances) const override
  {
    if (!search_) {
      swept().computeDistanceToNearest(k, distances);
      return;
    }
    giveSurfaceToSearch();
    pcl::Indices found;
    std::vector<float> squared;
    for (std::size_t i = 0; i < indices_.size(); ++i) {
      const PointT& point = (*input_)[static_cast<std::size_t>(indices_[i])];
      distances[i] = std::numeric_limits<float>::quiet_NaN();
      if (pcl::isXYZFinite(point) &&
          search_->nearestKSearch(point, static_cast<int>(k), found, squared) > 0)
        distances[i] = std::sqrt(*std::max_element(squared.begin(), squared.end()));
    }
  }

  std::unique_ptr<NeighborhoodStatistics>
  among(const pcl::Indices& points) const override
  {
    auto some =
        std::make_unique<CloudNeighborhoods>(input_, surface_, points, threads_);
    some->setSearch(search_);
    some->setIndex(index_);
    return some;
  }

  /** \brief The extent of the neighborhoods in metres.
   * \param[out] radii where they differ from point to point, what holds them */
  NeighborhoodSize
  sizeOf(double radius,
         int k,
         AdaptiveRadius::RadiusMode mode,
         std::vector<float>& radii) const
  {
    if (k > 0)
      return NeighborhoodSize::ofNearest(static_cast<std::size_t>(k));
    if (mode == AdaptiveRadius::FIXED)
      return NeighborhoodSize::ofRadius(radius);
    radii = adaptiveRadii(
        mode, radius, *this, xyzOf(*input_), indices_, countFinite(xyzOf(*surface_)));
    return NeighborhoodSize::ofRadii(radii.data());
  }

private:
  static_assert(sizeof(pcl::index_t) == sizeof(std::int32_t),
                "PCL with 32-bit indices");

  template <typename Neighborhoods>
  void
  setQueries(Neighborhoods& neighborhoods) const
  {
    if (input_ != surface_)
      neighborhoods.setQueries(xyzOf(*input_));
    if (!isAll())
      neighborhoods.setQueryIndices(indices_.data(), indices_.size());
    neighborhoods.setNumberOfThreads(threads_);
  }

  bool
  isAll() const
  {
    bool is_all = indices_.size() == input_->size();
    for (std::size_t i = 0; is_all && i < indices_.size(); ++i)
      is_all = indices_[i] == static_cast<pcl::index_t>(i);
    return is_all;
  }

  NeighborhoodSweep
  swept() const
  {
    NeighborhoodSweep sweep(xyzOf(*surface_));
    setQueries(sweep);
    sweep.setIndex(index_);
    return sweep;
  }

  ListedNeighborhoods
  listed(const NeighborhoodSize& size) const
  {
    giveSurfaceToSearch();
    const auto find = [this, size](std::size_t position, pcl::Indices& found) {
      thread_local std::vector<float> squared_distances;
      const pcl::index_t index = indices_[position];
      if (size.k > 0) {
        const int k = static_cast<int>(size.k);
        search_->nearestKSearch(*input_, index, k, found, squared_distances);
      }
      else {
        const double radius = size.radii ? size.radii[position] : size.radius;
        search_->radiusSearch(*input_, index, radius, found, squared_distances);
      }
    };
    ListedNeighborhoods neighborhoods(xyzOf(*surface_), find);
    setQueries(neighborhoods);
    return neighborhoods;
  }

  /** A search method notices another cloud, but not one that was edited in place; and
   * some abort on a NaN in a cloud that says it has none. */
  void
  giveSurfaceToSearch() const
  {
    CloudConstPtr honest = surface_;
    if (surface_->is_dense && !allFinite(xyzOf(*surface_))) {
      const auto copy = pcl::make_shared<Cloud>(*surface_);
      copy->is_dense = false;
      honest = copy;
    }
    const bool is_known = isSurface(search_->getInputCloud());
    search_->setInputCloud(honest, is_known ? search_->getIndices() : nullptr);
  }

  /** Whether a cloud is the surface, or the copy of it that an earlier computation gave
   * to the search. */
  bool
  isSurface(const CloudConstPtr& cloud) const
  {
    return cloud == surface_ || (cloud && !cloud->is_dense && surface_->is_dense &&
                                 cloud->size() == surface_->size() &&
                                 std::memcmp(cloud->points.data(),
                                             surface_->points.data(),
                                             surface_->size() * sizeof(PointT)) == 0);
  }

  CloudConstPtr input_;
  CloudConstPtr surface_;
  const pcl::Indices& indices_;
  unsigned threads_;
  SearchPtr search_;
  SweepIndex::Ptr index_ = std::make_shared<SweepIndex>();
};

/** \brief The noise of a cloud, see noiseOf(). */
template <typename PointT>
double
noiseOfCloud(const typename pcl::PointCloud<PointT>::ConstPtr& cloud, unsigned threads)
{
  pcl::Indices all(cloud->size());
  std::iota(all.begin(), all.end(), 0);
  const CloudNeighborhoods<PointT> neighborhoods(cloud, cloud, all, threads);
  const XYZView points = xyzOf(*cloud);
  const std::vector<float> spacings = adaptiveRadii(
      AdaptiveRadius::DENSITY, 1.0, neighborhoods, points, all, countFinite(points));
  return noiseOf(neighborhoods, points, spacings);
}

/** \brief What radii that grow with noise are for this cloud: see withNoise(). */
template <typename PointT, typename Parameters>
Parameters
withNoiseOfCloud(const Parameters& parameters,
                 const typename pcl::PointCloud<PointT>::ConstPtr& cloud,
                 unsigned threads)
{
  if (parameters.normal_radius_noise == 0.0 && parameters.radius_noise == 0.0)
    return parameters;
  return withNoise(parameters, noiseOfCloud<PointT>(cloud, threads));
}

} // namespace pcl::detail
