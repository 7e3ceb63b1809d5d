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
namespace detail {

/** \brief True if they can be surfaces of as many points, in planar and curved. */
inline bool
areOf(const Surfaces& surfaces, std::size_t points)
{
  return surfaces.likelihoods.size() == 2 && surfaces.likelihoods[0].size() == points &&
         surfaces.likelihoods[1].size() == points &&
         surfaces.edge_likelihood.size() == points &&
         surfaces.normals.size() == points && surfaces.spacings.size() == points;
}

} // namespace detail

template <typename PointT>
std::string
SuctionGraspEstimation<PointT>::findProblem() const
{
  if (!this->input_)
    return "no input cloud is set: call setInputCloud() with one";
  const detail::NeighborhoodRequest request{detail::xyzOf(*this->input_),
                                            detail::xyzOf(*this->input_),
                                            this->indices_.get(),
                                            cup_.radius,
                                            0};
  const std::string problem = detail::problemOfCup(cup_);
  if (!problem.empty())
    return problem;
  if (given_surfaces_ && !detail::areOf(*given_surfaces_, this->input_->size()))
    return "the surfaces are not those of the " + std::to_string(this->input_->size()) +
           " points of the input: those that ShapeBackProjection::classify() gives for "
           "all of them are needed";
  return detail::problemOf(request);
}

template <typename PointT>
void
SuctionGraspEstimation<PointT>::reportProblem(const std::string& problem) const
{
  PCL_ERROR("[pcl::SuctionGraspEstimation::compute] %s.\n", problem.c_str());
}

template <typename PointT>
shared_ptr<const Surfaces>
SuctionGraspEstimation<PointT>::classified() const
{
  const auto surfaces = pcl::make_shared<Surfaces>();
  ShapeBackProjection<PointT> back_projection;
  back_projection.setInputCloud(this->input_);
  back_projection.setSearchMethod(search_);
  back_projection.setResolution(resolution_);
  back_projection.setNumberOfThreads(threads_);
  back_projection.classify(*surfaces);
  return surfaces->likelihoods.empty() ? nullptr : surfaces;
}

template <typename PointT>
detail::GraspTarget
SuctionGraspEstimation<PointT>::targetOf(const Surfaces& surfaces) const
{
  const Eigen::Vector3f viewpoint =
      view_point_.value_or(this->input_->sensor_origin_.template head<3>());
  detail::GraspTarget target;
  target.cloud = detail::xyzOf(*this->input_);
  target.noise = surfaces.noise;
  for (const index_t index : *this->indices_) {
    const auto i = static_cast<std::size_t>(index);
    target.points.push_back(static_cast<std::uint32_t>(index));
    target.edge_likelihood.push_back(surfaces.edge_likelihood[i]);
    target.spacings.push_back(surfaces.spacings[i]);
    const Eigen::Vector3f normal = surfaces.normals[i].getNormalVector3fMap();
    const Eigen::Vector3f away = (*this->input_)[i].getVector3fMap() - viewpoint;
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
  for (const Surface surface : {PLANAR, CURVED})
    if (surface_ == ANY || surface_ == surface) {
      const auto& likelihoods = surfaces.likelihoods[surface == PLANAR ? 0 : 1];
      detail::GraspSurface& of = classes.emplace_back();
      of.surface = surface;
      for (const index_t index : *this->indices_)
        of.likelihood.push_back(likelihoods[static_cast<std::size_t>(index)]);
    }
  return classes;
}

template <typename PointT>
bool
SuctionGraspEstimation<PointT>::compute(std::vector<SuctionGrasp>& grasps)
{
  grasps.clear();
  if (this->input_)
    PCLBase<PointT>::initCompute();
  std::string problem = findProblem();
  if (!problem.empty()) {
    reportProblem(problem);
    return false;
  }
  const shared_ptr<const Surfaces> surfaces =
      given_surfaces_ ? given_surfaces_ : classified();
  if (!surfaces)
    return false; // the reason was reported
  const detail::GraspTarget target = targetOf(*surfaces);
  problem = detail::problemOfCup(cup_, target);
  if (!problem.empty()) {
    reportProblem(problem);
    return false;
  }
  grasps = detail::findGrasps(target, lookedFor(*surfaces), cup_, threads_);
  if (most_grasps_ > 0 && grasps.size() > most_grasps_)
    grasps.resize(most_grasps_);
  return true;
}

} // namespace pcl

#define PCL_INSTANTIATE_SuctionGraspEstimation(T)                                      \
  template class PCL_SHAPE_EXPORTS pcl::SuctionGraspEstimation<T>;
