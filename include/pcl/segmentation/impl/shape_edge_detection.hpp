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
  return model.classes().size() == 1
             ? std::string()
             : "the model has " + std::to_string(model.classes().size()) +
                   " classes: edges are found with one, a plane";
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

} // namespace pcl

#define PCL_INSTANTIATE_ShapeEdgeDetection(T, NT)                                      \
  template class PCL_SHAPE_EXPORTS pcl::ShapeEdgeDetection<T, NT>;
