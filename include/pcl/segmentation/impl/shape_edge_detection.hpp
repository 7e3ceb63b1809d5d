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
namespace detail {

/** \brief What kind of edge each point of a field is.
 * \param[in] threshold as ShapeDetection::setThreshold() \param[in] threads 0 for all
 * cores */
PCL_SHAPE_EXPORTS std::vector<EdgeType>
edgeTypesOf(const ShapeField& field, double threshold, unsigned threads);

} // namespace detail

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
  const std::size_t classes = model.classes().size();
  if (this->mode_ == this->DEFAULT || classes == 1)
    return {};
  return "the model has " + std::to_string(classes) +
         " classes: it must have one, a plane, in PAPER mode";
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
ShapeEdgeDetection<PointT, PointNT>::classOf(const float* likelihoods,
                                             std::size_t) const
{
  return likelihoods[1] < this->threshold_ ? 0 : 1;
}

template <typename PointT, typename PointNT>
std::vector<std::vector<float>>
ShapeEdgeDetection<PointT, PointNT>::likelihoodsOf(const ShapeField& field) const
{
  std::vector<std::vector<float>> likelihoods(2, field.edge_likelihood);
  for (float& planar : likelihoods[1])
    planar = 1.0f - planar;
  return likelihoods;
}

template <typename PointT, typename PointNT>
void
ShapeEdgeDetection<PointT, PointNT>::detect(Edges& edges)
{
  edges = Edges();
  if (!this->initCompute())
    return;
  if (this->mode_ == this->PAPER) {
    this->reportProblem("the paper's method knows no kinds of edges: use DEFAULT mode");
    return;
  }
  const ShapeField::ConstPtr field = this->fieldOfInput();
  const std::vector<EdgeType> types =
      detail::edgeTypesOf(*field, this->threshold_, this->getNumberOfThreads());
  for (const index_t index : *this->indices_) {
    edges.likelihood.push_back(field->edge_likelihood[static_cast<std::size_t>(index)]);
    edges.types.push_back(types[static_cast<std::size_t>(index)]);
  }
  edges.creases = field->creases;
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
