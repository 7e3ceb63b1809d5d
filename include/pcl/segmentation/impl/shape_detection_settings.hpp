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
#include <pcl/segmentation/shape_detection.h>
#include <pcl/features/impl/inad.hpp>

#include <string>

// Which model and parameters a detection works with, and what it refuses.
namespace pcl {

template <typename PointT, typename PointNT>
ShapeModel
ShapeDetection<PointT, PointNT>::getModel() const
{
  if (model_)
    return *model_;
  return isAdaptive() ? defaultModel() : ShapeModel::idealPlane(defaults_);
}

template <typename PointT, typename PointNT>
bool
ShapeDetection<PointT, PointNT>::isAdaptive() const
{
  const bool is_given = inad_ || normals_ || radius_ || normal_radius_ ||
                        outlier_rate_ || (k_ && *k_ != 0);
  if (mode_ == PAPER || is_given)
    return false;
  if (has_radius_mode_ && radius_mode_ != DENSITY)
    return false;
  return !model_ ||
         (model_->parameters().radius_mode == DENSITY && model_->classes().size() > 1);
}

template <typename PointT, typename PointNT>
INADParameters
ShapeDetection<PointT, PointNT>::getParameters() const
{
  if (isAdaptive())
    return model_ ? model_->parameters() : defaultModel().parameters();
  INADParameters parameters = model_ ? model_->parameters() : defaults_;
  if (has_radius_mode_)
    parameters.radius_mode = radius_mode_;
  parameters.outlier_rate = outlier_rate_.value_or(parameters.outlier_rate);
  const bool is_k = k_ && *k_ != 0;
  const bool is_radius = normal_radius_ || radius_;
  if (is_k) {
    parameters.k = *k_;
    parameters.normal_radius = parameters.radius = 0.0;
  }
  else if (is_radius && parameters.k != 0) {
    parameters.k = 0;
    parameters.normal_radius = parameters.radius = radius_ ? *radius_ : *normal_radius_;
  }
  if (!is_k || is_radius) {
    parameters.normal_radius = normal_radius_.value_or(parameters.normal_radius);
    parameters.radius = radius_.value_or(parameters.radius);
  }
  return parameters;
}

template <typename PointT, typename PointNT>
std::string
ShapeDetection<PointT, PointNT>::findProblem() const
{
  const INADParameters parameters = getParameters();
  const PointCloudConstPtr surface = searchSurface();
  for (const double radius : {parameters.normal_radius, parameters.radius}) {
    std::string problem = detail::problemOf({detail::xyzOf(*this->input_),
                                             detail::xyzOf(*surface),
                                             this->indices_.get(),
                                             radius,
                                             parameters.k});
    if (!problem.empty())
      return problem;
  }
  std::string problem = detail::problemOfOutlierRate(parameters.outlier_rate);
  if (problem.empty() && normals_)
    problem = detail::problemOfNormals(normals_->size(), surface->size());
  if (problem.empty() && inad_ && inad_->size() != this->input_->size()) {
    problem = std::to_string(inad_->size()) + " INAD are given for an input of " +
              std::to_string(this->input_->size()) + " points: one for each is needed";
  }
  if (problem.empty()) {
    problem = detail::problemOfModel(getModel(),
                                     threshold_,
                                     model_ && !ignore_model_parameters_ ? &parameters
                                                                         : nullptr);
  }
  if (problem.empty())
    problem = problemOfResolution();
  return problem.empty() ? problemOfClasses(getModel()) : problem;
}

template <typename PointT, typename PointNT>
std::string
ShapeDetection<PointT, PointNT>::problemOfResolution() const
{
  if (resolution_ == 0.0)
    return {};
  if (!isAdaptive()) {
    return "a resolution is set: it is allowed in DEFAULT mode without radii, k, "
           "outlier rate, normals or INAD of your own";
  }
  return detail::problemOfResolution(resolution_, detail::xyzOf(*searchSurface()));
}

template <typename PointT, typename PointNT>
bool
ShapeDetection<PointT, PointNT>::initCompute()
{
  std::string problem;
  if (!this->input_) {
    problem = "no input cloud is set: call setInputCloud() with one";
  }
  else {
    PCLBase<PointT>::initCompute();
    problem = findProblem();
  }
  if (!problem.empty())
    PCL_ERROR("[pcl::%s::compute] %s.\n", name_.c_str(), problem.c_str());
  return problem.empty();
}

} // namespace pcl
