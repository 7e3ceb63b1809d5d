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
#include <pcl/features/inad.h>
#include <pcl/features/impl/feature.hpp>
#include <pcl/features/impl/neighborhoods.hpp>

#include <type_traits>
#include <vector>

namespace pcl {

// Feature::initCompute() is not called: it always builds a tree and leaves it set.
template <typename PointInT, typename PointNT, typename PointOutT>
bool
INADEstimation<PointInT, PointNT, PointOutT>::initCompute()
{
  const auto fail = [this](const std::string& problem) {
    PCL_ERROR(
        "[pcl::%s::compute] %s.\n", this->getClassName().c_str(), problem.c_str());
    this->deinitCompute();
    return false;
  };
  if (!this->input_)
    return fail("no input cloud is set: call setInputCloud() with one");
  if (!this->normals_) {
    return fail("no normals are set: call setInputNormals() with those of the search "
                "surface");
  }
  if (!this->surface_) {
    this->fake_surface_ = true;
    this->surface_ = this->input_;
  }
  PCLBase<PointInT>::initCompute();
  std::string problem = detail::problemOf({detail::xyzOf(*this->input_),
                                           detail::xyzOf(*this->surface_),
                                           this->indices_.get(),
                                           this->search_radius_,
                                           this->k_});
  if (problem.empty())
    problem = detail::problemOfNormals(this->normals_->size(), this->surface_->size());
  if (problem.empty())
    problem = detail::problemOfOutlierRate(outlier_rate_);
  return problem.empty() || fail(problem);
}

template <typename PointInT, typename PointNT, typename PointOutT>
void
INADEstimation<PointInT, PointNT, PointOutT>::computeFeature(PointCloudOut& output)
{
  detail::Neighborhoods neighborhoods(detail::xyzOf(*this->input_),
                                      detail::xyzOf(*this->surface_),
                                      *this->indices_,
                                      threads_);
  neighborhoods.setFinder(
      detail::finderOf<PointInT>(this->tree_, this->input_, this->surface_));
  neighborhoods.setIndex(index_);
  const auto computeInto = [&](float* mu_sigma) {
    std::vector<float> radii;
    return neighborhoods.computeINAD(
        neighborhoods.sizeOf(this->search_radius_, this->k_, this->radius_mode_, radii),
        detail::normalsOf(*this->normals_),
        outlier_rate_,
        mu_sigma);
  };
  if constexpr (std::is_same_v<PointOutT, pcl::INAD>) {
    static_assert(sizeof(pcl::INAD) == 2 * sizeof(float), "mu and sigma, nothing else");
    output.is_dense = output.empty() || computeInto(&output[0].mu);
  }
  else {
    std::vector<float> mu_sigma(2 * output.size());
    output.is_dense = computeInto(mu_sigma.data());
    for (std::size_t i = 0; i < output.size(); ++i) {
      output[i].mu = mu_sigma[2 * i];
      output[i].sigma = mu_sigma[2 * i + 1];
    }
  }
}

} // namespace pcl

#define PCL_INSTANTIATE_INADEstimation(T, NT, OutT)                                    \
  template class PCL_SHAPE_EXPORTS pcl::INADEstimation<T, NT, OutT>;
