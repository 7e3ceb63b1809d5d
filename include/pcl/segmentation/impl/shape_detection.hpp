/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * Point Cloud Library (PCL) - www.pointclouds.org
 * Copyright (c) 2026, pcl_shape contributors
 *
 * All rights reserved
 */

#pragma once

#include <pcl/common/io.h>
#include <pcl/console/print.h>
#include <pcl/segmentation/shape_detection.h>
#include <pcl/features/impl/inad.hpp>
#include <pcl/features/impl/normal_3d_sweep.hpp>

#include <cmath>

namespace pcl {

template <typename PointT, typename PointNT>
ShapeModel
ShapeDetection<PointT, PointNT>::getModel() const
{
  return model_ ? *model_ : ShapeModel::idealPlane(defaults_);
}

template <typename PointT, typename PointNT>
INADParameters
ShapeDetection<PointT, PointNT>::getParameters() const
{
  INADParameters parameters = model_ ? model_->parameters() : defaults_;
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
  const auto& surface = surface_ ? surface_ : this->input_;
  for (const double radius : {parameters.normal_radius, parameters.radius}) {
    std::string problem = detail::problemOf({detail::xyzOf(*this->input_),
                                             detail::xyzOf(*surface),
                                             this->indices_.get(),
                                             radius,
                                             parameters.k});
    if (!problem.empty()) {
      return problem;
    }
  }
  std::string problem = detail::problemOfOutlierRate(parameters.outlier_rate);
  if (problem.empty() && normals_) {
    problem = detail::problemOfNormals(normals_->size(), surface->size());
  }
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
  return problem.empty() ? problemOfClasses(getModel()) : problem;
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
  if (!problem.empty()) {
    PCL_ERROR("[pcl::%s::compute] %s.\n", name_.c_str(), problem.c_str());
  }
  return problem.empty();
}

template <typename PointT, typename PointNT>
typename ShapeDetection<PointT, PointNT>::PointCloudNConstPtr
ShapeDetection<PointT, PointNT>::estimateNormals(const INADParameters& parameters) const
{
  NormalEstimationSweep<PointT, PointNT> estimation(threads_);
  estimation.setInputCloud(surface_ ? surface_ : this->input_);
  estimation.setSearchMethod(search_);
  estimation.setRadiusSearch(parameters.normal_radius);
  estimation.setKSearch(parameters.k);
  const auto normals = pcl::make_shared<pcl::PointCloud<PointNT>>();
  estimation.compute(*normals);
  return normals;
}

template <typename PointT, typename PointNT>
void
ShapeDetection<PointT, PointNT>::computeINAD(pcl::PointCloud<INAD>& inad) const
{
  if (inad_) {
    pcl::copyPointCloud(*inad_, *this->indices_, inad);
    return;
  }
  const INADParameters parameters = getParameters();
  INADEstimation<PointT, PointNT> estimation(threads_);
  estimation.setInputCloud(this->input_);
  estimation.setIndices(this->indices_);
  if (surface_) {
    estimation.setSearchSurface(surface_);
  }
  estimation.setSearchMethod(search_);
  estimation.setInputNormals(normals_ ? normals_ : estimateNormals(parameters));
  estimation.setRadiusSearch(parameters.radius);
  estimation.setKSearch(parameters.k);
  estimation.setOutlierRate(parameters.outlier_rate);
  estimation.compute(inad);
}

template <typename PointT, typename PointNT>
bool
ShapeDetection<PointT, PointNT>::computeLikelihoods(std::vector<float>& likelihoods)
{
  likelihoods.clear();
  if (!initCompute()) {
    return false;
  }
  pcl::PointCloud<INAD> inad;
  computeINAD(inad);
  const ShapeModel model = getModel();
  const std::size_t classes = getClasses().size();
  likelihoods.resize(classes * inad.size());
  std::vector<float> values(model.classes().size());
  for (std::size_t i = 0; i < inad.size(); ++i) {
    model.evaluate(inad[i], values.data());
    toClasses(values, &likelihoods[classes * i]);
  }
  return true;
}

template <typename PointT, typename PointNT>
void
ShapeDetection<PointT, PointNT>::compute(pcl::PointCloud<pcl::Intensity>& likelihood)
{
  likelihood.clear();
  std::vector<float> likelihoods;
  if (!computeLikelihoods(likelihoods)) {
    return;
  }
  const std::size_t classes = getClasses().size();
  likelihood.header = this->input_->header;
  likelihood.resize(this->indices_->size());
  if (likelihood.size() == this->input_->size()) {
    likelihood.width = this->input_->width;
    likelihood.height = this->input_->height;
  }
  likelihood.is_dense = true;
  for (std::size_t i = 0; i < likelihood.size(); ++i) {
    likelihood[i].intensity = likelihoods[classes * i];
    likelihood.is_dense = likelihood.is_dense && !std::isnan(likelihoods[classes * i]);
  }
}

template <typename PointT, typename PointNT>
void
ShapeDetection<PointT, PointNT>::compute(std::vector<std::vector<float>>& likelihoods)
{
  likelihoods.clear();
  std::vector<float> all;
  if (!computeLikelihoods(all)) {
    return;
  }
  const std::size_t classes = getClasses().size();
  likelihoods.resize(classes);
  for (std::size_t i = 0; i < all.size(); ++i) {
    likelihoods[i % classes].push_back(all[i]);
  }
}

template <typename PointT, typename PointNT>
void
ShapeDetection<PointT, PointNT>::segment(std::vector<pcl::PointIndices>& classes)
{
  classes.clear();
  std::vector<float> likelihoods;
  if (!computeLikelihoods(likelihoods)) {
    return;
  }
  classes.resize(getClasses().size());
  for (auto& points : classes) {
    points.header = this->input_->header;
  }
  for (std::size_t i = 0; i < this->indices_->size(); ++i) {
    const float* values = &likelihoods[classes.size() * i];
    if (!std::isnan(*values)) {
      classes[classOf(values)].indices.push_back((*this->indices_)[i]);
    }
  }
}

} // namespace pcl

#define PCL_INSTANTIATE_ShapeDetection(T, NT)                                          \
  template class PCL_SHAPE_EXPORTS pcl::ShapeDetection<T, NT>;
