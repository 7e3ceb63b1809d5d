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
#include <pcl/segmentation/shape_field_estimation.h>
#include <pcl/features/impl/neighborhoods.hpp>

namespace pcl {
namespace detail {

/** \brief A finder among points that stand for those of the search surface, three
 * coordinates each; among the surface's own if there are none. */
using FinderMaker = std::function<NeighborFinder(const std::vector<float>& points)>;

/** \brief What a field is made of. */
struct FieldRequest {
  XYZView input;
  shared_ptr<const void> input_owner;
  const pcl::Indices* indices = nullptr; ///< points whose values are wanted
  XYZView surface;                       ///< the points to find neighbors among
  shared_ptr<const void> surface_owner;
  FinderMaker makeFinder; ///< empty for the sweep
  SweepIndex::Ptr index;
  XYZView normals;             ///< of the surface
  bool has_normals = false;    ///< else they are estimated
  double resolution = 0.0;     ///< meters, 0 for the surface's own
  bool one_resolution = false; ///< for all of the surface, whatever its noise
  ShapeModel edge_model;       ///< an edge, the rest
  ShapeModel surface_model;    ///< several classes
  bool edges_only = false;
  std::optional<CloudNumbers> of_cloud; ///< of which the surface is a part
  unsigned threads = 0;
};

/** \brief What is wrong with a request; empty if nothing is. */
PCL_SHAPE_EXPORTS std::string problemOf(const FieldRequest& request);

PCL_SHAPE_EXPORTS ShapeField estimateField(const FieldRequest& request);

/** \brief What is wrong with a field that was given for a cloud; empty if nothing is.
 */
PCL_SHAPE_EXPORTS std::string
problemOfField(const ShapeField& field, const void* cloud, std::size_t size);

PCL_SHAPE_EXPORTS std::vector<std::string> classNames(const ShapeModel& model);

} // namespace detail

template <typename PointT>
detail::FieldRequest
ShapeFieldEstimation<PointT>::request() const
{
  detail::FieldRequest request;
  request.input = detail::xyzOf(*this->input_);
  request.input_owner = this->input_;
  request.indices = this->indices_.get();
  request.surface = surface_ ? detail::xyzOf(*surface_) : request.input;
  request.surface_owner = surface_ ? surface_ : this->input_;
  request.index = index_;
  request.normals = normals_;
  request.has_normals = normals_owner_ != nullptr;
  request.resolution = resolution_;
  request.one_resolution = one_resolution_;
  request.edge_model = getEdgeModel();
  request.surface_model = getSurfaceModel();
  request.edges_only = edges_only_;
  request.of_cloud = numbers_;
  request.threads = threads_;
  return request;
}

template <typename PointT>
std::string
ShapeFieldEstimation<PointT>::findProblem()
{
  if (!this->input_)
    return "no input cloud is set: call setInputCloud() with one";
  PCLBase<PointT>::initCompute();
  return detail::problemOf(request());
}

template <typename PointT>
bool
ShapeFieldEstimation<PointT>::compute(ShapeField& field)
{
  field = ShapeField();
  const std::string problem = findProblem();
  if (!problem.empty()) {
    PCL_ERROR("[pcl::ShapeFieldEstimation::compute] %s.\n", problem.c_str());
    return false;
  }
  detail::FieldRequest request = this->request();
  if (search_)
    request.makeFinder = [this](const std::vector<float>& points) {
      PointCloudConstPtr among = surface_ ? surface_ : this->input_;
      if (!points.empty()) {
        const auto cloud = pcl::make_shared<pcl::PointCloud<PointT>>();
        cloud->resize(points.size() / 3);
        for (std::size_t i = 0; i < cloud->size(); ++i)
          (*cloud)[i].getVector3fMap() = Eigen::Vector3f(&points[3 * i]);
        among = cloud;
      }
      return detail::finderOf<PointT>(search_, among, among);
    };
  field = detail::estimateField(request);
  return true;
}

template <typename PointT>
std::string
ShapeFieldUser<PointT>::findFieldProblem()
{
  if (!this->input_)
    return "no input cloud is set: call setInputCloud() with one";
  PCLBase<PointT>::initCompute();
  if (!field_) {
    estimation_.setInputCloud(this->input_);
    estimation_.setIndices(this->indices_);
    return estimation_.findProblem();
  }
  constexpr double any_radius = 1.0;
  const XYZView points = detail::xyzOf(*this->input_);
  const std::string problem =
      detail::problemOf({points, points, this->indices_.get(), any_radius, 0});
  return problem.empty()
             ? detail::problemOfField(*field_, this->input_.get(), points.size)
             : problem;
}

template <typename PointT>
ShapeField::ConstPtr
ShapeFieldUser<PointT>::fieldOfInput()
{
  if (field_)
    return field_;
  const auto field = pcl::make_shared<ShapeField>();
  estimation_.setInputCloud(this->input_);
  estimation_.setIndices(IndicesPtr());
  estimation_.compute(*field);
  return field;
}

} // namespace pcl

#define PCL_INSTANTIATE_ShapeFieldEstimation(T)                                        \
  template class PCL_SHAPE_EXPORTS pcl::ShapeFieldEstimation<T>;                       \
  template class PCL_SHAPE_EXPORTS pcl::ShapeFieldUser<T>;
