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
#include <pcl/segmentation/shape_labeling.h>
#include <pcl/segmentation/impl/shape_back_projection.hpp>

#include <algorithm>

namespace pcl {

template <typename PointT, typename PointNT>
std::vector<std::string>
ShapeLabeling<PointT, PointNT>::getClasses() const
{
  std::vector<std::string> names = detection_.getClasses();
  names.emplace_back(detail::edge_class);
  return names;
}

template <typename PointT, typename PointNT>
std::string
ShapeLabeling<PointT, PointNT>::findProblem() const
{
  if (!this->input_)
    return "no input cloud is set: call setInputCloud() with one";
  if (!(confidence_ >= 0.0 && confidence_ <= 1.0))
    return "confidence is " + std::to_string(confidence_) + ": 0 to 1 is allowed";
  const std::vector<std::string> names = detection_.getClasses();
  if (std::count(names.begin(), names.end(), detail::edge_class) > 0) {
    return "the model has a class 'edge': allowed are other names, edges are a class "
           "of their own";
  }
  if (!detection_.isAdaptive()) {
    return "the model has one class, or was not made in DENSITY mode: one of several "
           "classes that was is allowed";
  }
  const XYZView points = detail::xyzOf(*this->input_);
  constexpr double any_radius = 1.0;
  return detail::problemOf({points, points, this->indices_.get(), any_radius, 0});
}

template <typename PointT, typename PointNT>
void
ShapeLabeling<PointT, PointNT>::label(PointLabels& labels)
{
  labels = PointLabels();
  if (this->input_)
    PCLBase<PointT>::initCompute();
  const std::string problem = findProblem();
  if (!problem.empty()) {
    PCL_ERROR("[pcl::ShapeLabeling::label] %s.\n", problem.c_str());
    return;
  }
  detection_.setInputCloud(this->input_);
  Surfaces surfaces;
  detection_.classify(surfaces);
  if (surfaces.likelihoods.empty())
    return;
  const std::vector<std::string> names = detection_.getClasses();
  const auto planar = std::find(names.begin(), names.end(), detail::planar_class);
  const auto planar_label =
      planar == names.end() ? 0
                            : static_cast<std::uint32_t>(planar - names.begin() + 1);
  const PointLabels all = detail::labelPoints(
      {detail::xyzOf(*this->input_), surfaces, threads_, planar_label}, confidence_);
  for (const index_t index : *this->indices_) {
    labels.labels.push_back(all.labels[static_cast<std::size_t>(index)]);
    labels.confidence.push_back(all.confidence[static_cast<std::size_t>(index)]);
  }
}

} // namespace pcl

#define PCL_INSTANTIATE_ShapeLabeling(T, NT)                                           \
  template class PCL_SHAPE_EXPORTS pcl::ShapeLabeling<T, NT>;
