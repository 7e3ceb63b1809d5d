/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * Point Cloud Library (PCL) - www.pointclouds.org
 * Copyright (c) 2026, pcl_shape contributors
 *
 * All rights reserved
 */

#pragma once

#include <pcl/segmentation/shape_detection.h>
#include <pcl/segmentation/shape_field_estimation.h>
#include <pcl/features/impl/inad.hpp>
#include <pcl/features/impl/normal_3d_sweep.hpp>
#include <pcl/segmentation/impl/shape_field_estimation.hpp>

#include <algorithm>
#include <cmath>

namespace pcl {
namespace detail {

/** \brief Parameters for the noise of this cloud: the growth with noise is added to the
 * radii. */
PCL_SHAPE_EXPORTS INADParameters withNoiseOfCloud(const INADParameters& parameters,
                                                  const XYZView& cloud,
                                                  unsigned threads);

} // namespace detail

template <typename PointT, typename PointNT>
void
ShapeDetection<PointT, PointNT>::computeINAD(pcl::PointCloud<INAD>& inad) const
{
  if (inad_) {
    // Not copyPointCloud(): of as many indices as points it does not look at the order.
    inad.clear();
    inad.reserve(this->indices_->size());
    for (const index_t index : *this->indices_)
      inad.push_back((*inad_)[static_cast<std::size_t>(index)]);
    return;
  }
  const unsigned threads = this->getNumberOfThreads();
  const PointCloudConstPtr surface = surface_ ? surface_ : this->input_;
  const INADParameters parameters =
      detail::withNoiseOfCloud(getParameters(), detail::xyzOf(*surface), threads);
  const auto index = index_ ? index_ : std::make_shared<SweepIndex>();
  PointCloudNConstPtr normals = normals_;
  if (!normals) {
    NormalEstimationSweep<PointT, PointNT> estimation(threads);
    estimation.setInputCloud(surface);
    estimation.setRadiusMode(parameters.radius_mode);
    estimation.setSearchMethod(this->getSearchMethod());
    estimation.setSweepIndex(index);
    estimation.setRadiusSearch(parameters.normal_radius);
    estimation.setKSearch(parameters.k);
    const auto estimated = pcl::make_shared<pcl::PointCloud<PointNT>>();
    estimation.compute(*estimated);
    normals = estimated;
  }
  INADEstimation<PointT, PointNT> estimation(threads);
  estimation.setInputCloud(this->input_);
  estimation.setIndices(this->indices_);
  if (surface_)
    estimation.setSearchSurface(surface_);
  estimation.setSearchMethod(this->getSearchMethod());
  estimation.setInputNormals(normals);
  estimation.setSweepIndex(index);
  estimation.setRadiusSearch(parameters.radius);
  estimation.setKSearch(parameters.k);
  estimation.setOutlierRate(parameters.outlier_rate);
  estimation.setRadiusMode(parameters.radius_mode);
  estimation.compute(inad);
}

template <typename PointT, typename PointNT>
std::vector<std::vector<float>>
ShapeDetection<PointT, PointNT>::paperLikelihoods() const
{
  pcl::PointCloud<INAD> inad;
  computeINAD(inad);
  const ShapeModel model = getModel();
  std::vector<float> values(model.classes().size());
  std::vector<float> of_point(getClasses().size());
  std::vector<std::vector<float>> likelihoods(of_point.size(),
                                              std::vector<float>(inad.size()));
  for (std::size_t i = 0; i < inad.size(); ++i) {
    model.evaluate(inad[i], values.data());
    toClasses(values, of_point.data());
    for (std::size_t c = 0; c < of_point.size(); ++c)
      likelihoods[c][i] = of_point[c];
  }
  return likelihoods;
}

template <typename PointT, typename PointNT>
std::string
ShapeDetection<PointT, PointNT>::findPaperProblem() const
{
  const INADParameters parameters = getParameters();
  const PointCloudConstPtr surface = surface_ ? surface_ : this->input_;
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
  if (problem.empty() && inad_ && inad_->size() != this->input_->size())
    problem = std::to_string(inad_->size()) + " INAD are given for an input of " +
              std::to_string(this->input_->size()) + " points: one for each is needed";
  return problem;
}

template <typename PointT, typename PointNT>
std::string
ShapeDetection<PointT, PointNT>::findDefaultProblem()
{
  ShapeFieldEstimation<PointT>& estimation = this->estimation_;
  estimation.setSearchSurface(surface_);
  estimation.setSweepIndex(index_);
  estimation.setInputNormals(normals_);
  estimation.setEdgesOnly(edgesOnly());
  if (model_ && edgesOnly())
    estimation.setEdgeModel(*model_);
  else if (model_)
    estimation.setSurfaceModel(*model_);
  return this->findFieldProblem();
}

template <typename PointT, typename PointNT>
std::string
ShapeDetection<PointT, PointNT>::findProblem()
{
  if (!this->input_)
    return "no input cloud is set: call setInputCloud() with one";
  PCLBase<PointT>::initCompute();
  std::string problem = problemOfMode(inad_ ? "INAD" : nullptr,
                                      this->field_                   ? "a shape field"
                                      : this->getResolution() != 0.0 ? "a resolution"
                                                                     : nullptr);
  if (problem.empty())
    problem = mode_ == PAPER ? findPaperProblem() : findDefaultProblem();
  return problem.empty() ? problemOfModel() : problem;
}

template <typename PointT, typename PointNT>
void
ShapeDetection<PointT, PointNT>::reportProblem(const std::string& problem) const
{
  PCL_ERROR("[pcl::%s::compute] %s.\n", name_.c_str(), problem.c_str());
}

template <typename PointT, typename PointNT>
bool
ShapeDetection<PointT, PointNT>::initCompute()
{
  const std::string problem = findProblem();
  if (!problem.empty())
    reportProblem(problem);
  return problem.empty();
}

template <typename PointT, typename PointNT>
void
ShapeDetection<PointT, PointNT>::compute(std::vector<std::vector<float>>& likelihoods)
{
  likelihoods.clear();
  if (!initCompute())
    return;
  if (mode_ == PAPER) {
    likelihoods = paperLikelihoods();
    return;
  }
  const ShapeField::ConstPtr field = this->fieldOfInput();
  for (const std::vector<float>& of_cloud : likelihoodsOf(*field)) {
    std::vector<float>& of_indices = likelihoods.emplace_back();
    of_indices.reserve(this->indices_->size());
    for (const index_t index : *this->indices_)
      of_indices.push_back(of_cloud[static_cast<std::size_t>(index)]);
  }
}

template <typename PointT, typename PointNT>
void
ShapeDetection<PointT, PointNT>::compute(pcl::PointCloud<pcl::Intensity>& likelihood)
{
  likelihood.clear();
  std::vector<std::vector<float>> likelihoods;
  compute(likelihoods);
  if (likelihoods.empty())
    return;
  likelihood.header = this->input_->header;
  likelihood.resize(this->indices_->size());
  if (likelihood.size() == this->input_->size()) {
    likelihood.width = this->input_->width;
    likelihood.height = this->input_->height;
  }
  likelihood.is_dense = true;
  for (std::size_t i = 0; i < likelihood.size(); ++i) {
    likelihood[i].intensity = likelihoods[0][i];
    likelihood.is_dense = likelihood.is_dense && !std::isnan(likelihoods[0][i]);
  }
}

template <typename PointT, typename PointNT>
void
ShapeDetection<PointT, PointNT>::segment(std::vector<pcl::PointIndices>& classes)
{
  std::vector<std::vector<float>> likelihoods;
  compute(likelihoods);
  classes = classesOf(likelihoods);
}

template <typename PointT, typename PointNT>
std::vector<pcl::PointIndices>
ShapeDetection<PointT, PointNT>::classesOf(
    const std::vector<std::vector<float>>& likelihoods) const
{
  std::vector<pcl::PointIndices> classes(likelihoods.size());
  for (auto& points : classes)
    points.header = this->input_->header;
  std::vector<float> values(likelihoods.size());
  for (std::size_t i = 0; !values.empty() && i < likelihoods[0].size(); ++i) {
    for (std::size_t c = 0; c < values.size(); ++c)
      values[c] = likelihoods[c][i];
    if (!std::isnan(values[0]))
      classes[classOf(values.data(), values.size())].indices.push_back(
          (*this->indices_)[i]);
  }
  return classes;
}

} // namespace pcl

#define PCL_INSTANTIATE_ShapeDetection(T, NT)                                          \
  template class PCL_SHAPE_EXPORTS pcl::ShapeDetection<T, NT>;
