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
  if (this->mode_ == this->DEFAULT && this->field_)
    return this->field_->classes;
  if (!this->model_)
    return {"planar", "curved"};
  std::vector<std::string> names = detail::classNames(*this->model_);
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
  return this->mode_ == this->DEFAULT && this->field_ && this->field_->classes.empty()
             ? "the field has no classes: it was made for edges only"
             : std::string();
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
ShapeBackProjection<PointT, PointNT>::classOf(const float* likelihoods,
                                              std::size_t classes) const
{
  const bool has_one_histogram = this->mode_ == this->PAPER &&
                                 (!this->model_ || this->model_->classes().size() == 1);
  if (has_one_histogram)
    return likelihoods[0] >= this->threshold_ ? 0 : 1;
  const float* likeliest = std::max_element(likelihoods, likelihoods + classes);
  return static_cast<std::size_t>(likeliest - likelihoods);
}

template <typename PointT, typename PointNT>
std::vector<std::vector<float>>
ShapeBackProjection<PointT, PointNT>::likelihoodsOf(const ShapeField& field) const
{
  return field.likelihoods;
}

} // namespace pcl

#define PCL_INSTANTIATE_ShapeBackProjection(T, NT)                                     \
  template class PCL_SHAPE_EXPORTS pcl::ShapeBackProjection<T, NT>;
