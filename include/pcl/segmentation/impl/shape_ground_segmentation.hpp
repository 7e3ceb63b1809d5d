/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * Point Cloud Library (PCL) - www.pointclouds.org
 * Copyright (c) 2026, pcl_shape contributors
 *
 * All rights reserved
 */

#pragma once

#include <pcl/segmentation/shape_ground_segmentation.h>
#include <pcl/common/point_tests.h>
#include <pcl/features/impl/neighborhoods.hpp>

#include <string>

namespace pcl {

template <typename PointT>
std::string
ShapeGroundSegmentation<PointT>::findProblem()
{
  if (!this->input_)
    return "no input cloud is set: call setInputCloud() with one";
  PCLBase<PointT>::initCompute();
  const auto size = static_cast<pcl::index_t>(this->input_->size());
  bool has_point = false;
  for (const pcl::index_t index : *this->indices_) {
    if (index < 0 || index >= size)
      return "index " + std::to_string(index) + ": 0 to " + std::to_string(size - 1) +
             " is allowed, the cloud has " + std::to_string(size) + " points";
    has_point = has_point || pcl::isXYZFinite((*this->input_)[index]);
  }
  if (!has_point)
    return "the cloud has no finite point: at least one is needed";
  if (!(threshold_ >= 0.0f && threshold_ <= 1.0f))
    return "threshold is " + std::to_string(threshold_) + ": 0 to 1 is allowed";
  return detail::problemOf(parameters_);
}

template <typename PointT>
void
ShapeGroundSegmentation<PointT>::compute(std::vector<float>& likelihood)
{
  likelihood.clear();
  const std::string problem = findProblem();
  if (!problem.empty()) {
    PCL_ERROR("[pcl::ShapeGroundSegmentation::compute] %s.\n", problem.c_str());
    return;
  }
  const Eigen::Vector4f& origin = this->input_->sensor_origin_;
  detail::GroundQuery query;
  query.points = detail::xyzOf(*this->input_);
  query.indices = this->indices_->data();
  query.size = this->indices_->size();
  query.origin = {origin.x(), origin.y(), origin.z()};
  query.threads = threads_;
  likelihood = detail::groundLikelihoods(query, parameters_);
}

template <typename PointT>
bool
ShapeGroundSegmentation<PointT>::segment(pcl::PointIndices& ground)
{
  ground = pcl::PointIndices();
  std::vector<float> likelihood;
  compute(likelihood);
  if (likelihood.empty())
    return false;
  ground.header = this->input_->header;
  for (std::size_t i = 0; i < likelihood.size(); ++i)
    if (likelihood[i] >= threshold_)
      ground.indices.push_back((*this->indices_)[i]);
  if (ground.indices.empty())
    PCL_WARN("[pcl::ShapeGroundSegmentation::segment] no ground was found: where is up "
             "in this cloud?\n");
  return true;
}

} // namespace pcl

#define PCL_INSTANTIATE_ShapeGroundSegmentation(T)                                     \
  template class PCL_SHAPE_EXPORTS pcl::ShapeGroundSegmentation<T>;
