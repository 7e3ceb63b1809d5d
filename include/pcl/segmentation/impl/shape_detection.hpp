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
#include <pcl/features/impl/inad.hpp>
#include <pcl/features/impl/normal_3d_sweep.hpp>
#include <pcl/segmentation/impl/shape_detection_settings.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace pcl {

template <typename PointT, typename PointNT>
typename ShapeDetection<PointT, PointNT>::PointCloudNConstPtr
ShapeDetection<PointT, PointNT>::estimateNormals(const INADParameters& parameters,
                                                 const SweepIndex::Ptr& index) const
{
  NormalEstimationSweep<PointT, PointNT> estimation(threads_);
  estimation.setInputCloud(searchSurface());
  estimation.setRadiusMode(parameters.radius_mode);
  estimation.setSearchMethod(search_);
  estimation.setSweepIndex(index);
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
    // Not copyPointCloud(): of as many indices as points it does not look at the order.
    inad.clear();
    inad.reserve(this->indices_->size());
    for (const index_t index : *this->indices_)
      inad.push_back((*inad_)[index]);
    return;
  }
  const INADParameters parameters =
      detail::withNoiseOfCloud<PointT>(getParameters(), searchSurface(), threads_);
  const auto index = index_ ? index_ : std::make_shared<SweepIndex>();
  INADEstimation<PointT, PointNT> estimation(threads_);
  estimation.setInputCloud(this->input_);
  estimation.setIndices(this->indices_);
  if (surface_)
    estimation.setSearchSurface(surface_);
  estimation.setSearchMethod(search_);
  estimation.setInputNormals(normals_ ? normals_ : estimateNormals(parameters, index));
  estimation.setSweepIndex(index);
  estimation.setRadiusSearch(parameters.radius);
  estimation.setKSearch(parameters.k);
  estimation.setOutlierRate(parameters.outlier_rate);
  estimation.setRadiusMode(parameters.radius_mode);
  estimation.compute(inad);
}

template <typename PointT, typename PointNT>
typename ShapeDetection<PointT, PointNT>::PointCloudConstPtr
ShapeDetection<PointT, PointNT>::searchSurface() const
{
  return surface_ ? surface_ : this->input_;
}

template <typename PointT, typename PointNT>
typename ShapeDetection<PointT, PointNT>::PointCloudConstPtr
ShapeDetection<PointT, PointNT>::adaptiveSurface() const
{
  const PointCloudConstPtr all = searchSurface();
  if (resolution_ == 0.0)
    return all;
  const std::vector<float> xyz = detail::thinned(detail::xyzOf(*all), resolution_);
  const auto surface = pcl::make_shared<PointCloud>();
  surface->resize(xyz.size() / 3);
  for (std::size_t i = 0; i < surface->size(); ++i)
    (*surface)[i].getVector3fMap() = Eigen::Map<const Eigen::Vector3f>(&xyz[3 * i]);
  return surface;
}

template <typename PointT, typename PointNT>
std::vector<std::int32_t>
ShapeDetection<PointT, PointNT>::surfacePoints(const PointCloud& surface,
                                               std::vector<float> spacings) const
{
  std::vector<std::int32_t> points(this->indices_->begin(), this->indices_->end());
  if (&surface == this->input_.get())
    return points;
  const auto cell_diagonal = static_cast<float>(std::sqrt(3.0) * resolution_);
  for (float& spacing : spacings)
    spacing = std::max(spacing, cell_diagonal);
  const auto nearest = detail::representatives(
      detail::xyzOf(*this->input_), detail::xyzOf(surface), spacings, threads_);
  for (std::int32_t& point : points)
    point = nearest[static_cast<std::size_t>(point)];
  return points;
}

template <typename PointT, typename PointNT>
template <typename Find>
std::vector<std::int32_t>
ShapeDetection<PointT, PointNT>::withAdaptiveInput(const Find& find) const
{
  const PointCloudConstPtr surface = adaptiveSurface();
  pcl::Indices all(surface->size());
  std::iota(all.begin(), all.end(), 0);
  detail::CloudNeighborhoods<PointT> neighborhoods(surface, surface, all, threads_);
  neighborhoods.setSearch(search_);
  neighborhoods.setIndex(index_);
  const XYZView points = detail::xyzOf(*surface);
  return surfacePoints(
      *surface,
      find(detail::AdaptiveInput{
          neighborhoods, points, detail::countFinite(points), threads_}));
}

template <typename PointT, typename PointNT>
void
ShapeDetection<PointT, PointNT>::computeAdaptive(std::vector<float>& likelihoods) const
{
  std::vector<float> of_surface;
  const auto points = withAdaptiveInput([&](const detail::AdaptiveInput& input) {
    std::vector<float> spacings;
    of_surface = adaptiveLikelihoods(input, spacings);
    return spacings;
  });
  const std::size_t classes = getClasses().size();
  for (const std::int32_t point : points) {
    for (std::size_t c = 0; c < classes; ++c) {
      likelihoods.push_back(
          point < 0 ? std::numeric_limits<float>::quiet_NaN()
                    : of_surface[classes * static_cast<std::size_t>(point) + c]);
    }
  }
}

template <typename PointT, typename PointNT>
bool
ShapeDetection<PointT, PointNT>::computeLikelihoods(std::vector<float>& likelihoods)
{
  likelihoods.clear();
  if (!initCompute())
    return false;
  if (isAdaptive()) {
    computeAdaptive(likelihoods);
    return true;
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
  if (!computeLikelihoods(likelihoods))
    return;
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
  if (!computeLikelihoods(all))
    return;
  const std::size_t classes = getClasses().size();
  likelihoods.resize(classes);
  for (std::size_t i = 0; i < all.size(); ++i)
    likelihoods[i % classes].push_back(all[i]);
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
      classes[classOf(values.data())].indices.push_back((*this->indices_)[i]);
  }
  return classes;
}

} // namespace pcl

#define PCL_INSTANTIATE_ShapeDetection(T, NT)                                          \
  template class PCL_SHAPE_EXPORTS pcl::ShapeDetection<T, NT>;
