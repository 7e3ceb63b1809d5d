/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * Point Cloud Library (PCL) - www.pointclouds.org
 * Copyright (c) 2026, pcl_shape contributors
 *
 * All rights reserved
 */

#pragma once

#include <pcl/segmentation/shape_back_projection.h>
#include <pcl/segmentation/impl/shape_detection.hpp>

#include <algorithm>

namespace pcl {

template <typename PointT, typename PointNT>
std::vector<std::string>
ShapeBackProjection<PointT, PointNT>::getClasses() const
{
  if (!this->model_) {
    return {"planar", "curved"};
  }
  std::vector<std::string> names;
  for (const ShapeModel::Class& c : this->model_->classes()) {
    names.push_back(c.name);
  }
  if (names.size() == 1) {
    const bool is_plane = names[0] == "plane" || names[0] == "planar";
    names.emplace_back(is_plane ? "curved" : "other");
  }
  return names;
}

template <typename PointT, typename PointNT>
std::string
ShapeBackProjection<PointT, PointNT>::problemOfClasses(const ShapeModel&) const
{
  if (!edge_model_) {
    return {};
  }
  if (!this->isAdaptive()) {
    return "an edge model is set: it is allowed in DEFAULT mode without radii, k, "
           "outlier rate, normals or INAD of your own";
  }
  const std::size_t classes = edge_model_->classes().size();
  if (classes != 2) {
    return "the edge model has " + std::to_string(classes) +
           " classes: edges are found with two, an edge and the rest";
  }
  return edge_model_->parameters().radius_mode == AdaptiveRadius::DENSITY
             ? std::string()
             : "the edge model was not made in DENSITY mode: one that was is allowed";
}

template <typename PointT, typename PointNT>
void
ShapeBackProjection<PointT, PointNT>::toClasses(const std::vector<float>& values,
                                                float* likelihoods) const
{
  std::copy(values.begin(), values.end(), likelihoods);
  if (values.size() == 1) {
    likelihoods[1] = 1.0f - values[0];
  }
}

template <typename PointT, typename PointNT>
std::size_t
ShapeBackProjection<PointT, PointNT>::classOf(const float* likelihoods) const
{
  const std::size_t classes = this->isAdaptive() ? getClasses().size()
                              : this->model_     ? this->model_->classes().size()
                                                 : 1;
  if (classes == 1) {
    return likelihoods[0] >= this->threshold_ ? 0 : 1;
  }
  const float* most = std::max_element(likelihoods, likelihoods + classes);
  return static_cast<std::size_t>(most - likelihoods);
}

template <typename PointT, typename PointNT>
std::vector<float>
ShapeBackProjection<PointT, PointNT>::adaptiveLikelihoods(
    const detail::AdaptiveInput& input, std::vector<float>& spacings) const
{
  const detail::AdaptiveEdges edges =
      detail::findEdges(input, edge_model_.value_or(ShapeModel::defaultEdges()));
  spacings = edges.spacings;
  return detail::classifySurfaces(input, edges, this->getModel());
}

} // namespace pcl

#define PCL_INSTANTIATE_ShapeBackProjection(T, NT)                                     \
  template class PCL_SHAPE_EXPORTS pcl::ShapeBackProjection<T, NT>;
