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
#include <pcl/segmentation/shape_ground_segmentation.h>
#include <pcl/features/impl/neighborhoods.hpp>
#include <pcl/segmentation/impl/ground_likelihoods.hpp>

#include <string>

namespace pcl {

template <typename PointT>
void
ShapeGroundSegmentation<PointT>::compute(std::vector<float>& likelihood)
{
  likelihood.clear();
  detail::GroundQuery query;
  std::string problem = "no input cloud is set: call setInputCloud() with one";
  if (this->input_) {
    PCLBase<PointT>::initCompute();
    query = {detail::xyzOf(*this->input_),
             this->indices_->data(),
             this->indices_->size(),
             this->input_->sensor_origin_.data(),
             threads_};
    problem = detail::problemOf(query, parameters_);
  }
  if (problem.empty())
    likelihood = detail::groundLikelihoods(query, parameters_);
  else
    PCL_ERROR("[pcl::ShapeGroundSegmentation::compute] %s.\n", problem.c_str());
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
    if (likelihood[i] >= parameters_.threshold)
      ground.indices.push_back((*this->indices_)[i]);
  if (ground.indices.empty())
    PCL_WARN("[pcl::ShapeGroundSegmentation::segment] no ground was found: where is up "
             "in this cloud?\n");
  return true;
}

} // namespace pcl

#define PCL_INSTANTIATE_ShapeGroundSegmentation(T)                                     \
  template class PCL_SHAPE_EXPORTS pcl::ShapeGroundSegmentation<T>;
