/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * Point Cloud Library (PCL) - www.pointclouds.org
 * Copyright (c) 2026, pcl_shape contributors
 *
 * All rights reserved
 */

#pragma once

#include <pcl/console/print.h>
#include <pcl/segmentation/suction_grasp_estimation.h>
#include <pcl/segmentation/impl/shape_back_projection.hpp>

namespace pcl {

template <typename PointT>
std::string
SuctionGraspEstimation<PointT>::findProblem() const
{
  if (!this->input_)
    return "no input cloud is set: call setInputCloud() with one";
  return detail::problemOfCup(cup_);
}

template <typename PointT>
void
SuctionGraspEstimation<PointT>::reportProblem(const std::string& problem) const
{
  PCL_ERROR("[pcl::SuctionGraspEstimation::compute] %s.\n", problem.c_str());
}

template <typename PointT>
detail::GraspTarget
SuctionGraspEstimation<PointT>::targetOf(const Surfaces& surfaces) const
{
  const Eigen::Vector3f viewpoint =
      view_point_.value_or(this->input_->sensor_origin_.template head<3>());
  detail::GraspTarget target;
  target.cloud = detail::xyzOf(*this->input_);
  target.edge_likelihood = surfaces.edge_likelihood;
  target.spacings = surfaces.spacings;
  target.noise = surfaces.noise;
  for (std::size_t k = 0; k < this->indices_->size(); ++k) {
    const auto index = static_cast<std::uint32_t>((*this->indices_)[k]);
    target.points.push_back(index);
    const Eigen::Vector3f normal = surfaces.normals[k].getNormalVector3fMap();
    const Eigen::Vector3f away = (*this->input_)[index].getVector3fMap() - viewpoint;
    const float outwards = normal.dot(away) > 0.0f ? -1.0f : 1.0f;
    for (const float component : normal)
      target.normals.push_back(outwards * component);
  }
  return target;
}

template <typename PointT>
std::vector<detail::GraspSurface>
SuctionGraspEstimation<PointT>::lookedFor(const Surfaces& surfaces) const
{
  std::vector<detail::GraspSurface> classes;
  if (surface_ != CURVED)
    classes.push_back({PLANAR, surfaces.likelihoods[0]});
  if (surface_ != PLANAR)
    classes.push_back({CURVED, surfaces.likelihoods[1]});
  return classes;
}

template <typename PointT>
bool
SuctionGraspEstimation<PointT>::compute(std::vector<SuctionGrasp>& grasps)
{
  grasps.clear();
  std::string problem = findProblem();
  if (!problem.empty()) {
    reportProblem(problem);
    return false;
  }
  PCLBase<PointT>::initCompute();
  ShapeBackProjection<PointT> back_projection;
  back_projection.setInputCloud(this->input_);
  back_projection.setIndices(this->indices_);
  back_projection.setSearchMethod(search_);
  back_projection.setNumberOfThreads(threads_);
  Surfaces surfaces;
  back_projection.classify(surfaces);
  if (surfaces.likelihoods.empty())
    return false; // the reason was reported
  const detail::GraspTarget target = targetOf(surfaces);
  problem = detail::problemOfCup(cup_, target);
  if (!problem.empty()) {
    reportProblem(problem);
    return false;
  }
  grasps = detail::findGrasps(target, lookedFor(surfaces), cup_, threads_);
  if (most_grasps_ > 0 && grasps.size() > most_grasps_)
    grasps.resize(most_grasps_);
  return true;
}

} // namespace pcl

#define PCL_INSTANTIATE_SuctionGraspEstimation(T)                                      \
  template class PCL_SHAPE_EXPORTS pcl::SuctionGraspEstimation<T>;
