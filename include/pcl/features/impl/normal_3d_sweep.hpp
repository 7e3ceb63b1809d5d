/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * Point Cloud Library (PCL) - www.pointclouds.org
 * Copyright (c) 2026, pcl_shape contributors
 *
 * All rights reserved
 */

#pragma once

#include <pcl/console/print.h>
#include <pcl/features/normal_3d.h>
#include <pcl/features/normal_3d_sweep.h>
#include <pcl/features/impl/feature.hpp>
#include <pcl/features/impl/neighborhoods.hpp>

namespace pcl {

// Feature::initCompute() is not called: it always builds a tree and leaves it set.
template <typename PointInT, typename PointOutT>
bool
NormalEstimationSweep<PointInT, PointOutT>::initCompute()
{
  const auto fail = [this](const std::string& problem) {
    PCL_ERROR(
        "[pcl::%s::compute] %s.\n", this->getClassName().c_str(), problem.c_str());
    this->deinitCompute();
    return false;
  };
  if (!this->input_)
    return fail("no input cloud is set: call setInputCloud() with one");
  if (!this->surface_) {
    this->fake_surface_ = true;
    this->surface_ = this->input_;
  }
  PCLBase<PointInT>::initCompute();
  const std::string problem = detail::problemOf({detail::xyzOf(*this->input_),
                                                 detail::xyzOf(*this->surface_),
                                                 this->indices_.get(),
                                                 this->search_radius_,
                                                 this->k_});
  return problem.empty() || fail(problem);
}

template <typename PointInT, typename PointOutT>
void
NormalEstimationSweep<PointInT, PointOutT>::computeFeature(PointCloudOut& output)
{
  if (output.empty())
    return;
  detail::Neighborhoods neighborhoods(detail::xyzOf(*this->input_),
                                      detail::xyzOf(*this->surface_),
                                      *this->indices_,
                                      threads_);
  neighborhoods.setFinder(
      detail::finderOf<PointInT>(this->tree_, this->input_, this->surface_));
  neighborhoods.setIndex(index_);
  std::vector<float> radii;
  output.is_dense = neighborhoods.computeNormals(
      neighborhoods.sizeOf(this->search_radius_, this->k_, this->radius_mode_, radii),
      &output[0].normal_x,
      &output[0].curvature,
      sizeof(PointOutT) / sizeof(float));

  const Eigen::Vector3f viewpoint = viewPoint();
  const auto flip = [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      auto& normal = output[i];
      const auto point = static_cast<std::size_t>((*this->indices_)[i]);
      pcl::flipNormalTowardsViewpoint((*this->input_)[point],
                                      viewpoint.x(),
                                      viewpoint.y(),
                                      viewpoint.z(),
                                      normal.normal_x,
                                      normal.normal_y,
                                      normal.normal_z);
    }
  };
  detail::forEachPart(output.size(), threads_, flip);
}

} // namespace pcl

#define PCL_INSTANTIATE_NormalEstimationSweep(T, NT)                                   \
  template class PCL_SHAPE_EXPORTS pcl::NormalEstimationSweep<T, NT>;
