/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * Point Cloud Library (PCL) - www.pointclouds.org
 * Copyright (c) 2026, pcl_shape contributors
 *
 * All rights reserved
 */

#pragma once

#include <pcl/segmentation/shape_edge_detection.h>
#include <pcl/segmentation/impl/shape_detection.hpp>

#include <stdexcept>

namespace pcl {

template <typename PointT, typename PointNT>
std::vector<std::string>
ShapeEdgeDetection<PointT, PointNT>::getClasses() const
{
  return {"edge", "planar"};
}

template <typename PointT, typename PointNT>
void
ShapeEdgeDetection<PointT, PointNT>::segment(pcl::PointIndices& edges)
{
  std::vector<pcl::PointIndices> classes;
  segment(classes);
  edges = classes.empty() ? pcl::PointIndices() : classes[0];
}

template <typename PointT, typename PointNT>
std::string
ShapeEdgeDetection<PointT, PointNT>::problemOfClasses(const ShapeModel& model) const
{
  const std::string found =
      "the model has " + std::to_string(model.classes().size()) + " classes: ";
  if (this->isAdaptive()) {
    return model.classes().size() == 2
               ? std::string()
               : found + "edges are found with two, an edge and the rest";
  }
  return model.classes().size() == 1 ? std::string()
                                     : found + "edges are found with one, a plane";
}

template <typename PointT, typename PointNT>
void
ShapeEdgeDetection<PointT, PointNT>::toClasses(const std::vector<float>& values,
                                               float* likelihoods) const
{
  likelihoods[0] = 1.0f - values[0];
  likelihoods[1] = values[0];
}

template <typename PointT, typename PointNT>
std::size_t
ShapeEdgeDetection<PointT, PointNT>::classOf(const float* likelihoods) const
{
  return likelihoods[1] < this->threshold_ ? 0 : 1;
}

template <typename PointT, typename PointNT>
std::vector<float>
ShapeEdgeDetection<PointT, PointNT>::adaptiveLikelihoods(
    const detail::AdaptiveInput& input, std::vector<float>& spacings) const
{
  detail::AdaptiveEdges edges = detail::findEdges(input, this->getModel());
  spacings = std::move(edges.spacings);
  std::vector<float> likelihoods;
  likelihoods.reserve(2 * edges.likelihood.size());
  for (const float likelihood : edges.likelihood) {
    likelihoods.push_back(likelihood);
    likelihoods.push_back(1.0f - likelihood);
  }
  return likelihoods;
}

template <typename PointT, typename PointNT>
void
ShapeEdgeDetection<PointT, PointNT>::detect(Edges& edges)
{
  edges = Edges();
  if (!this->initCompute())
    return;
  if (!this->isAdaptive()) {
    PCL_ERROR(
        "[pcl::%s::detect] kinds of edges are known in DEFAULT mode only, without "
        "radii, k, outlier rate, normals or INAD of your own.\n",
        this->name_.c_str());
    return;
  }
  detail::AdaptiveEdges found;
  std::vector<EdgeType> types;
  const auto points = this->withAdaptiveInput([&](const detail::AdaptiveInput& input) {
    found = detail::findEdges(input, this->getModel());
    types = detail::edgeTypes(input, found, this->threshold_);
    return found.spacings;
  });
  for (const std::int32_t point : points) {
    const auto i = static_cast<std::size_t>(point);
    edges.likelihood.push_back(point < 0 ? std::numeric_limits<float>::quiet_NaN()
                                         : found.likelihood[i]);
    edges.types.push_back(point < 0 ? EdgeType::None : types[i]);
  }
  edges.creases = std::move(found.creases);
}

template <typename PointT, typename PointNT>
std::vector<CreaseLine>
ShapeEdgeDetection<PointT, PointNT>::linesOf(const Edges& edges) const
{
  try {
    return creaseLines(edges.creases);
  }
  catch (const std::invalid_argument& error) {
    PCL_ERROR("[pcl::%s::linesOf] %s.\n", this->name_.c_str(), error.what());
    return {};
  }
}

} // namespace pcl

#define PCL_INSTANTIATE_ShapeEdgeDetection(T, NT)                                      \
  template class PCL_SHAPE_EXPORTS pcl::ShapeEdgeDetection<T, NT>;
