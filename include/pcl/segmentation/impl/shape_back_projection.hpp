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
#include <limits>
#include <utility>

namespace pcl {

template <typename PointT, typename PointNT>
std::vector<std::string>
ShapeBackProjection<PointT, PointNT>::getClasses() const
{
  if (!this->model_)
    return {"planar", "curved"};
  std::vector<std::string> names;
  for (const ShapeModel::Class& c : this->model_->classes())
    names.push_back(c.name);
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
  if (!edge_model_)
    return {};
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
  if (values.size() == 1)
    likelihoods[1] = 1.0f - values[0];
}

template <typename PointT, typename PointNT>
std::size_t
ShapeBackProjection<PointT, PointNT>::classOf(const float* likelihoods) const
{
  const std::size_t classes = this->isAdaptive() ? getClasses().size()
                              : this->model_     ? this->model_->classes().size()
                                                 : 1;
  if (classes == 1)
    return likelihoods[0] >= this->threshold_ ? 0 : 1;
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

template <typename PointT, typename PointNT>
void
ShapeBackProjection<PointT, PointNT>::classify(Surfaces& surfaces)
{
  surfaces = Surfaces();
  if (!this->initCompute())
    return;
  if (!this->isAdaptive()) {
    PCL_ERROR(
        "[pcl::%s::classify] edges are known in DEFAULT mode only, without radii, k, "
        "outlier rate, normals or INAD of your own.\n",
        this->name_.c_str());
    return;
  }
  detail::AdaptiveEdges edges;
  std::vector<float> posteriors;
  const auto points = this->withAdaptiveInput([&](const detail::AdaptiveInput& input) {
    edges = detail::findEdges(input, edge_model_.value_or(ShapeModel::defaultEdges()));
    posteriors = detail::classifySurfaces(input, edges, this->getModel());
    return edges.spacings;
  });
  const std::size_t classes = getClasses().size();
  constexpr float unknown = std::numeric_limits<float>::quiet_NaN();
  surfaces.likelihoods.resize(classes);
  surfaces.noise = edges.noise;
  surfaces.creases = std::move(edges.creases);
  surfaces.normals.header = this->input_->header;
  for (const std::int32_t point : points) {
    const bool known = point >= 0;
    const auto i = static_cast<std::size_t>(known ? point : 0);
    for (std::size_t c = 0; c < classes; ++c)
      surfaces.likelihoods[c].push_back(known ? posteriors[classes * i + c] : unknown);
    surfaces.edge_likelihood.push_back(known ? edges.likelihood[i] : unknown);
    surfaces.spacings.push_back(known ? edges.spacings[i] : unknown);
    const float* n = &edges.normals[3 * i];
    surfaces.normals.push_back(known ? pcl::Normal(n[0], n[1], n[2])
                                     : pcl::Normal(unknown, unknown, unknown));
  }
}

} // namespace pcl

#define PCL_INSTANTIATE_ShapeBackProjection(T, NT)                                     \
  template class PCL_SHAPE_EXPORTS pcl::ShapeBackProjection<T, NT>;
