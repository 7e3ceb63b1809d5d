/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * Point Cloud Library (PCL) - www.pointclouds.org
 * Copyright (c) 2026, pcl_shape contributors
 *
 * All rights reserved
 */

#pragma once

#include <pcl/segmentation/shape_labeling.h>
#include <pcl/segmentation/impl/shape_field_estimation.hpp>

namespace pcl {
namespace detail {

/** \brief What is wrong with the settings; empty if nothing is. */
PCL_SHAPE_EXPORTS std::string problemOfLabels(const std::vector<std::string>& classes,
                                              double confidence);

/** \brief The likeliest label of each point of a field with its confidence; those with
 * less than `confidence` are void. */
PCL_SHAPE_EXPORTS PointLabels labelsOf(const ShapeField& field,
                                       double confidence,
                                       unsigned threads);

/** \brief The names of the classes of a model, and that of edges. */
PCL_SHAPE_EXPORTS std::vector<std::string> labelNames(std::vector<std::string> classes);

} // namespace detail

template <typename PointT>
std::vector<std::string>
ShapeLabeling<PointT>::getClasses() const
{
  return detail::labelNames(
      this->field_ ? this->field_->classes
                   : detail::classNames(this->estimation_.getSurfaceModel()));
}

template <typename PointT>
void
ShapeLabeling<PointT>::label(PointLabels& labels)
{
  labels = PointLabels();
  std::string problem =
      this->input_ ? detail::problemOfLabels(getClasses(), confidence_) : std::string();
  if (problem.empty())
    problem = this->findFieldProblem();
  if (!problem.empty()) {
    PCL_ERROR("[pcl::ShapeLabeling::label] %s.\n", problem.c_str());
    return;
  }
  const ShapeField::ConstPtr field = this->fieldOfInput();
  const PointLabels all =
      detail::labelsOf(*field, confidence_, this->getNumberOfThreads());
  for (const index_t index : *this->indices_) {
    labels.labels.push_back(all.labels[static_cast<std::size_t>(index)]);
    labels.confidence.push_back(all.confidence[static_cast<std::size_t>(index)]);
  }
}

} // namespace pcl

#define PCL_INSTANTIATE_ShapeLabeling(T)                                               \
  template class PCL_SHAPE_EXPORTS pcl::ShapeLabeling<T>;
