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
#include <pcl/segmentation/impl/shape_field_estimation.hpp>

namespace pcl {
namespace detail {

/** \brief What instances are found of. */
struct InstanceRequest {
  const ShapeField& field;
  const pcl::Indices& indices;
  std::string name; ///< of a class, or "object"
  InstanceLimits limits;
  PrimitiveType primitive = PrimitiveType::None;
  Eigen::Vector3f view_point{0.0f, 0.0f, 0.0f};
  unsigned threads = 0;
};

/** \brief What is wrong with the settings; empty if nothing is. */
PCL_SHAPE_EXPORTS std::string
problemOfInstances(const std::vector<std::string>& classes,
                   const std::string& name,
                   const InstanceLimits& limits);

PCL_SHAPE_EXPORTS std::vector<ShapeInstance>
findInstances(const InstanceRequest& request);

} // namespace detail

template <typename PointT>
std::vector<std::string>
ShapeInstanceSegmentation<PointT>::getClasses() const
{
  return this->field_ ? this->field_->classes
                      : detail::classNames(this->estimation_.getSurfaceModel());
}

template <typename PointT>
bool
ShapeInstanceSegmentation<PointT>::segment(std::vector<ShapeInstance>& instances)
{
  instances.clear();
  std::string problem = this->findFieldProblem();
  if (problem.empty())
    problem = detail::problemOfInstances(getClasses(), class_, limits_);
  if (!problem.empty()) {
    PCL_ERROR("[pcl::ShapeInstanceSegmentation::segment] %s.\n", problem.c_str());
    return false;
  }
  const ShapeField::ConstPtr field = this->fieldOfInput();
  const Eigen::Vector3f origin = input_->sensor_origin_.template head<3>();
  instances = detail::findInstances({*field,
                                     *indices_,
                                     class_,
                                     limits_,
                                     primitive_,
                                     view_point_.value_or(origin),
                                     this->getNumberOfThreads()});
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
