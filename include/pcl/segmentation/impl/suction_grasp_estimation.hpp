/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * Point Cloud Library (PCL) - www.pointclouds.org
 * Copyright (c) 2026, pcl_shape contributors
 *
 * All rights reserved
 */

#pragma once

#include <pcl/segmentation/suction_grasp_estimation.h>
#include <pcl/segmentation/impl/shape_field_estimation.hpp>

namespace pcl {
namespace detail {

/** \brief What grasps are found of. */
struct GraspRequest {
  const ShapeField& field;
  const pcl::Indices& indices; ///< the target
  SuctionCup cup;
  bool planar = true; ///< surfaces to look for
  bool curved = true;
  Eigen::Vector3f view_point{0.0f, 0.0f, 0.0f};
  unsigned threads = 0;
};

/** \brief What is wrong with a cup; empty if nothing is. */
PCL_SHAPE_EXPORTS std::string problemOfCup(const SuctionCup& cup);

/** \brief What is wrong with the field, or with the cup for it; empty if nothing is. */
PCL_SHAPE_EXPORTS std::string problemOf(const GraspRequest& request);

/** \brief Places for a cup, the best first. */
PCL_SHAPE_EXPORTS std::vector<SuctionGrasp> findGrasps(const GraspRequest& request);

} // namespace detail

template <typename PointT>
bool
SuctionGraspEstimation<PointT>::compute(std::vector<SuctionGrasp>& grasps)
{
  grasps.clear();
  const auto fail = [](const std::string& problem) {
    PCL_ERROR("[pcl::SuctionGraspEstimation::compute] %s.\n", problem.c_str());
    return false;
  };
  std::string problem = this->input_ ? detail::problemOfCup(cup_) : std::string();
  if (problem.empty())
    problem = this->findFieldProblem();
  if (!problem.empty())
    return fail(problem);
  const ShapeField::ConstPtr field = this->fieldOfInput();
  const Eigen::Vector3f origin = this->input_->sensor_origin_.template head<3>();
  const detail::GraspRequest request{*field,
                                     *this->indices_,
                                     cup_,
                                     surface_ != CURVED,
                                     surface_ != PLANAR,
                                     view_point_.value_or(origin),
                                     this->getNumberOfThreads()};
  problem = detail::problemOf(request);
  if (!problem.empty())
    return fail(problem);
  grasps = detail::findGrasps(request);
  if (max_grasps_ > 0 && grasps.size() > max_grasps_)
    grasps.resize(max_grasps_);
  return true;
}

} // namespace pcl

#define PCL_INSTANTIATE_SuctionGraspEstimation(T)                                      \
  template class PCL_SHAPE_EXPORTS pcl::SuctionGraspEstimation<T>;
