/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * Point Cloud Library (PCL) - www.pointclouds.org
 * Copyright (c) 2026, pcl_shape contributors
 *
 * All rights reserved
 */

#pragma once

#include <pcl/segmentation/shape_instance_segmentation.h>
#include <pcl/segmentation/impl/shape_back_projection.hpp>

#include <algorithm>
#include <cmath>

namespace pcl {

template <typename PointT>
std::size_t
ShapeInstanceSegmentation<PointT>::positionOfClass(const std::string& name) const
{
  const std::vector<std::string> names = getClasses();
  return static_cast<std::size_t>(std::find(names.begin(), names.end(), name) -
                                  names.begin());
}

template <typename PointT>
std::string
ShapeInstanceSegmentation<PointT>::findProblem() const
{
  if (!input_) {
    return "no input cloud is set: call setInputCloud() with one";
  }
  if (!back_projection_.isAdaptive()) {
    return "the model was not made in DENSITY mode with several classes: one that was "
           "is allowed";
  }
  const std::vector<std::string> names = getClasses();
  const std::string needed = class_ == "object" ? "planar" : class_;
  if (positionOfClass(needed) == names.size()) {
    std::string problem = "class '" + class_ + "': allowed is ";
    for (const std::string& name : names) {
      problem += name + ", ";
    }
    return problem + "or object if one of them is planar";
  }
  const double low = limits_.low, high = limits_.high;
  if (!(low >= 0.0 && low <= high && high <= 1.0)) {
    return "thresholds are " + std::to_string(high) + " and " + std::to_string(low) +
           ": 0 <= low <= high <= 1 is allowed";
  }
  return limits_.min_points >= 1 ? std::string()
                                 : "the least number of points is 0: 1 or more is "
                                   "allowed";
}

template <typename PointT>
detail::InstanceInput
ShapeInstanceSegmentation<PointT>::inputOf(Surfaces& surfaces,
                                           const std::vector<float>& positions) const
{
  const Eigen::Vector3f view_point =
      view_point_.value_or(Eigen::Vector3f(input_->sensor_origin_.template head<3>()));
  detail::InstanceInput input;
  input.points = {positions.data(), 3, indices_->size()};
  for (std::size_t i = 0; i < indices_->size(); ++i) {
    const Eigen::Map<const Eigen::Vector3f> position(&positions[3 * i]);
    Eigen::Vector3f normal = surfaces.normals[i].getNormalVector3fMap();
    if (normal.dot(view_point - position) < 0.0f) {
      normal = -normal;
    }
    input.normals.insert(input.normals.end(), normal.data(), normal.data() + 3);
  }
  input.spacings = std::move(surfaces.spacings);
  input.edge = std::move(surfaces.edge_likelihood);
  const bool is_object = class_ == "object";
  input.likelihood =
      surfaces.likelihoods[positionOfClass(is_object ? "planar" : class_)];
  input.noise = surfaces.noise;
  input.threads = threads_;
  return input;
}

template <typename PointT>
ShapeInstance
ShapeInstanceSegmentation<PointT>::describe(const std::vector<std::uint32_t>& members,
                                            const detail::InstanceInput& input,
                                            const Surfaces& surfaces) const
{
  const std::size_t classes = surfaces.likelihoods.size();
  std::vector<std::size_t> inner(classes), all(classes);
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  ShapeInstance instance;
  for (const std::uint32_t i : members) {
    instance.indices.push_back((*indices_)[i]);
    sum += Eigen::Map<const Eigen::Vector3f>(input.points[i]).cast<double>();
    std::size_t most = 0;
    for (std::size_t c = 1; c < classes; ++c) {
      most = surfaces.likelihoods[c][i] > surfaces.likelihoods[most][i] ? c : most;
    }
    ++all[most];
    inner[most] += input.edge[i] > 0.5f ? 0 : 1;
  }
  instance.centroid =
      (sum / static_cast<double>(members.size())).template cast<float>();
  const bool has_inner =
      std::any_of(inner.begin(), inner.end(), [](auto count) { return count > 0; });
  const std::vector<std::size_t>& counts = has_inner ? inner : all;
  std::size_t total = 0;
  for (const std::size_t count : counts) {
    total += count;
  }
  for (const std::size_t count : counts) {
    instance.shares.push_back(static_cast<float>(count) / static_cast<float>(total));
  }
  instance.primitive = detail::fitPrimitive(input, members, primitive_);
  std::sort(instance.indices.begin(), instance.indices.end());
  return instance;
}

template <typename PointT>
bool
ShapeInstanceSegmentation<PointT>::segment(std::vector<ShapeInstance>& instances)
{
  instances.clear();
  const std::string problem = findProblem();
  if (!problem.empty()) {
    PCL_ERROR("[pcl::ShapeInstanceSegmentation::segment] %s.\n", problem.c_str());
    return false;
  }
  PCLBase<PointT>::initCompute();
  back_projection_.setInputCloud(input_);
  back_projection_.setIndices(indices_);
  back_projection_.setNumberOfThreads(threads_);
  Surfaces surfaces;
  back_projection_.classify(surfaces);
  if (surfaces.likelihoods.empty()) {
    return false;
  }
  std::vector<float> positions;
  for (const index_t index : *indices_) {
    const PointT& point = (*input_)[index];
    positions.insert(positions.end(), {point.x, point.y, point.z});
  }
  const detail::InstanceInput input = inputOf(surfaces, positions);
  const detail::InstanceLabels labels = class_ == "object"
                                            ? detail::findObjects(input, limits_)
                                            : detail::findComponents(input, limits_);
  std::vector<std::vector<std::uint32_t>> members;
  for (std::size_t i = 0; i < labels.size(); ++i) {
    if (labels[i] < 0) {
      continue;
    }
    const auto label = static_cast<std::size_t>(labels[i]);
    members.resize(std::max(members.size(), label + 1));
    members[label].push_back(static_cast<std::uint32_t>(i));
  }
  for (const auto& points : members) {
    instances.push_back(describe(points, input, surfaces));
  }
  return true;
}

template <typename PointT>
bool
ShapeInstanceSegmentation<PointT>::segment(std::vector<pcl::PointIndices>& instances)
{
  std::vector<ShapeInstance> found;
  const bool is_done = segment(found);
  instances.clear();
  for (ShapeInstance& instance : found) {
    instances.emplace_back();
    instances.back().header = input_->header;
    instances.back().indices = std::move(instance.indices);
  }
  return is_done;
}

} // namespace pcl

#define PCL_INSTANTIATE_ShapeInstanceSegmentation(T)                                   \
  template class PCL_SHAPE_EXPORTS pcl::ShapeInstanceSegmentation<T>;
