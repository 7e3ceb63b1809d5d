/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * Point Cloud Library (PCL) - www.pointclouds.org
 * Copyright (c) 2026, pcl_shape contributors
 *
 * All rights reserved
 */

#pragma once

#include <pcl/features/listed_neighborhoods.h>
#include <pcl/features/neighborhood_sweep.h>
#include <pcl/point_cloud.h>
#include <pcl/search/search.h>

#include <string>

namespace pcl::detail {

/** \brief Where neighbors are looked for, and how. */
struct NeighborhoodRequest {
  XYZView input;
  XYZView surface;
  const pcl::Indices* indices = nullptr; ///< of the input
  double radius = 0.0;                   ///< metres, 0 if k is given
  int k = 0;                             ///< 0 if the radius is given
};

/** \brief What is wrong with a request: names the parameter, its value, and what is
 * allowed. Empty if nothing is. */
PCL_SHAPE_EXPORTS std::string problemOf(const NeighborhoodRequest& request);

/** \brief As above, for one value per surface point. */
PCL_SHAPE_EXPORTS std::string problemOfNormals(std::size_t normals,
                                               std::size_t surface);

PCL_SHAPE_EXPORTS std::string problemOfOutlierRate(double rate);

PCL_SHAPE_EXPORTS bool allFinite(const XYZView& points);

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

/** \brief Neighborhoods of points of one cloud among the points of another, or of the
 * same one: by a search method if there is one, else by the sweep. */
template <typename PointT>
class CloudNeighborhoods {
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

  bool
  computeNormals(
      double radius, int k, float* normals, float* curvature, std::size_t stride) const
  {
    if (search_) {
      return listed(radius, k).computeNormals(normals, curvature, stride);
    }
    return swept().computeNormals(sizeOf(radius, k), normals, curvature, stride);
  }

  bool
  computeINAD(double radius,
              int k,
              const XYZView& normals,
              double outlier_rate,
              float* mu_sigma) const
  {
    if (search_) {
      return listed(radius, k).computeINAD(normals, outlier_rate, mu_sigma);
    }
    return swept().computeINAD(sizeOf(radius, k), normals, outlier_rate, mu_sigma);
  }

private:
  static_assert(sizeof(pcl::index_t) == sizeof(std::int32_t),
                "PCL with 32-bit indices");

  static NeighborhoodSize
  sizeOf(double radius, int k)
  {
    return k > 0 ? NeighborhoodSize::ofNearest(static_cast<std::size_t>(k))
                 : NeighborhoodSize::ofRadius(radius);
  }

  template <typename Neighborhoods>
  void
  setQueries(Neighborhoods& neighborhoods) const
  {
    if (input_ != surface_) {
      neighborhoods.setQueries(xyzOf(*input_));
    }
    if (!isAll()) {
      neighborhoods.setQueryIndices(indices_.data(), indices_.size());
    }
    neighborhoods.setNumberOfThreads(threads_);
  }

  bool
  isAll() const
  {
    bool is_all = indices_.size() == input_->size();
    for (std::size_t i = 0; is_all && i < indices_.size(); ++i) {
      is_all = indices_[i] == static_cast<pcl::index_t>(i);
    }
    return is_all;
  }

  NeighborhoodSweep
  swept() const
  {
    NeighborhoodSweep sweep(xyzOf(*surface_));
    setQueries(sweep);
    return sweep;
  }

  ListedNeighborhoods
  listed(double radius, int k) const
  {
    giveSurfaceToSearch();
    const auto find = [this, radius, k](std::size_t position, pcl::Indices& found) {
      thread_local std::vector<float> squared_distances;
      const pcl::index_t index = indices_[position];
      if (k > 0) {
        search_->nearestKSearch(*input_, index, k, found, squared_distances);
      }
      else {
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
    const bool is_known = search_->getInputCloud() == surface_;
    search_->setInputCloud(honest, is_known ? search_->getIndices() : nullptr);
  }

  CloudConstPtr input_;
  CloudConstPtr surface_;
  const pcl::Indices& indices_;
  unsigned threads_;
  SearchPtr search_;
};

} // namespace pcl::detail
