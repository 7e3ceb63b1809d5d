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
#include <numeric>

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
  if (!input_)
    return "no input cloud is set: call setInputCloud() with one";
  if (!back_projection_.isAdaptive()) {
    return "the model was not made in DENSITY mode with several classes: one that was "
           "is allowed";
  }
  const std::vector<std::string> names = getClasses();
  const std::string needed = class_ == "object" ? "planar" : class_;
  if (positionOfClass(needed) == names.size()) {
    std::string problem = "class '" + class_ + "': allowed is ";
    for (const std::string& name : names)
      problem += name + ", ";
    return problem + "or object if one of them is planar";
  }
  const XYZView points = detail::xyzOf(*input_);
  constexpr double any_radius = 1.0;
  std::string problem =
      detail::problemOf({points, points, indices_.get(), any_radius, 0});
  if (problem.empty() && back_projection_.getResolution() != 0.0)
    problem = detail::problemOfResolution(back_projection_.getResolution(), points);
  if (!problem.empty())
    return problem;
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
std::vector<float>
ShapeInstanceSegmentation<PointT>::workedOn() const
{
  std::vector<float> positions;
  positions.reserve(3 * indices_->size());
  for (const index_t index : *indices_) {
    const PointT& point = (*input_)[index];
    positions.insert(positions.end(), {point.x, point.y, point.z});
  }
  const double resolution = back_projection_.getResolution();
  return resolution > 0.0
             ? detail::thinned({positions.data(), 3, indices_->size()}, resolution)
             : positions;
}

template <typename PointT>
void
ShapeInstanceSegmentation<PointT>::setUpBackProjection(
    const std::vector<float>& positions)
{
  if (back_projection_.getResolution() == 0.0) {
    back_projection_.setInputCloud(input_);
    back_projection_.setIndices(indices_);
    back_projection_.setSearchSurface(nullptr);
    return;
  }
  const auto means = pcl::make_shared<pcl::PointCloud<PointT>>();
  means->resize(positions.size() / 3);
  for (std::size_t i = 0; i < means->size(); ++i)
    (*means)[i].getVector3fMap() = Eigen::Map<const Eigen::Vector3f>(&positions[3 * i]);
  back_projection_.setInputCloud(means);
  back_projection_.setIndices(IndicesPtr());
  back_projection_.setSearchSurface(input_);
}

template <typename PointT>
detail::InstanceInput
ShapeInstanceSegmentation<PointT>::inputOf(Surfaces& surfaces,
                                           const std::vector<float>& positions) const
{
  const Eigen::Vector3f view_point =
      view_point_.value_or(Eigen::Vector3f(input_->sensor_origin_.template head<3>()));
  detail::InstanceInput input;
  input.points = {positions.data(), 3, positions.size() / 3};
  for (std::size_t i = 0; i < input.points.size; ++i) {
    const Eigen::Map<const Eigen::Vector3f> position(&positions[3 * i]);
    Eigen::Vector3f normal = surfaces.normals[i].getNormalVector3fMap();
    if (normal.dot(view_point - position) < 0.0f)
      normal = -normal;
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
  ShapeInstance instance;
  for (const std::uint32_t i : members) {
    std::size_t most = 0;
    for (std::size_t c = 1; c < classes; ++c)
      most = surfaces.likelihoods[c][i] > surfaces.likelihoods[most][i] ? c : most;
    ++all[most];
    inner[most] += input.edge[i] > 0.5f ? 0 : 1;
  }
  const bool has_inner =
      std::any_of(inner.begin(), inner.end(), [](auto count) { return count > 0; });
  const std::vector<std::size_t>& counts = has_inner ? inner : all;
  std::size_t total = 0;
  for (const std::size_t count : counts)
    total += count;
  for (const std::size_t count : counts)
    instance.shares.push_back(static_cast<float>(count) / static_cast<float>(total));
  instance.primitive = detail::fitPrimitive(input, members, primitive_);
  return instance;
}

template <typename PointT>
std::vector<std::int32_t>
ShapeInstanceSegmentation<PointT>::representatives(
    const detail::InstanceInput& input) const
{
  std::vector<std::int32_t> points(indices_->size());
  const double resolution = back_projection_.getResolution();
  if (resolution == 0.0) {
    std::iota(points.begin(), points.end(), 0);
    return points;
  }
  const auto cell_diagonal = static_cast<float>(std::sqrt(3.0) * resolution);
  std::vector<float> reach(input.points.size, cell_diagonal);
  const std::vector<std::int32_t> nearest =
      detail::representatives(detail::xyzOf(*input_), input.points, reach, threads_);
  for (std::size_t i = 0; i < points.size(); ++i)
    points[i] = nearest[static_cast<std::size_t>((*indices_)[i])];
  return points;
}

template <typename PointT>
void
ShapeInstanceSegmentation<PointT>::setPoints(
    const std::vector<std::int32_t>& labels,
    std::vector<ShapeInstance>& instances) const
{
  std::vector<Eigen::Vector3d> sums(instances.size(), Eigen::Vector3d::Zero());
  for (std::size_t i = 0; i < labels.size(); ++i) {
    if (labels[i] < 0)
      continue;
    const auto label = static_cast<std::size_t>(labels[i]);
    const index_t index = (*indices_)[i];
    instances[label].indices.push_back(index);
    sums[label] += (*input_)[index].getVector3fMap().template cast<double>();
  }
  for (std::size_t k = 0; k < instances.size(); ++k) {
    const auto points = static_cast<double>(instances[k].indices.size());
    instances[k].centroid = (sums[k] / points).template cast<float>();
    std::sort(instances[k].indices.begin(), instances[k].indices.end());
  }
}

template <typename PointT>
bool
ShapeInstanceSegmentation<PointT>::segment(std::vector<ShapeInstance>& instances)
{
  instances.clear();
  if (input_)
    PCLBase<PointT>::initCompute();
  const std::string problem = findProblem();
  if (!problem.empty()) {
    PCL_ERROR("[pcl::ShapeInstanceSegmentation::segment] %s.\n", problem.c_str());
    return false;
  }
  const std::vector<float> positions = workedOn();
  setUpBackProjection(positions);
  back_projection_.setNumberOfThreads(threads_);
  Surfaces surfaces;
  back_projection_.classify(surfaces);
  if (surfaces.likelihoods.empty())
    return false;
  const detail::InstanceInput input = inputOf(surfaces, positions);
  const detail::InstanceLabels labels = class_ == "object"
                                            ? detail::findObjects(input, limits_)
                                            : detail::findComponents(input, limits_);
  std::vector<std::vector<std::uint32_t>> members;
  for (std::size_t i = 0; i < labels.size(); ++i) {
    if (labels[i] < 0)
      continue;
    const auto label = static_cast<std::size_t>(labels[i]);
    members.resize(std::max(members.size(), label + 1));
    members[label].push_back(static_cast<std::uint32_t>(i));
  }
  for (const auto& points : members)
    instances.push_back(describe(points, input, surfaces));
  std::vector<std::int32_t> points = representatives(input);
  for (std::int32_t& point : points)
    point = point < 0 ? -1 : labels[static_cast<std::size_t>(point)];
  setPoints(points, instances);
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
