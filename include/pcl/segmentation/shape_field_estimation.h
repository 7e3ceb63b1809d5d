/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * Point Cloud Library (PCL) - www.pointclouds.org
 * Copyright (c) 2026, pcl_shape contributors
 *
 * All rights reserved
 */

#pragma once

#include <pcl/features/cloud_numbers.h>
#include <pcl/features/shape_model.h>
#include <pcl/features/sweep_index.h>
#include <pcl/pcl_base.h>
#include <pcl/search/search.h>
#include <pcl/segmentation/shape_field.h>

#include <optional>
#include <string>

namespace pcl {

namespace detail {
struct FieldRequest;
}

/** \brief Compute once what edges, surfaces, instances, grasps and labels need of a
 * cloud.
 *
 * Neighborhoods follow the density and the noise of the cloud: there is no radius to
 * choose. First creases: points whose INAD speaks for an edge fit two planes to their
 * neighborhood and vote for where these meet. Then the posteriors of the classes
 * ("planar" and "curved", or those of a model), from evidence averaged over the
 * neighborhood without crossing edges. doc/method.md has the steps.
 *
 * Errors (a null or empty cloud or search surface, one without a finite point, an index
 * out of range, normals of another number than the surface's points, a model that does
 * not fit, a resolution that is negative, finer than what a float holds at the largest
 * coordinate, or as large as the cloud) are reported by PCL_ERROR.
 * \ingroup segmentation */
template <typename PointT>
class ShapeFieldEstimation : public PCLBase<PointT>, public SweepIndexUser {
public:
  using Ptr = shared_ptr<ShapeFieldEstimation<PointT>>;
  using ConstPtr = shared_ptr<const ShapeFieldEstimation<PointT>>;
  using PointCloudConstPtr = typename pcl::PointCloud<PointT>::ConstPtr;
  using SearchPtr = typename pcl::search::Search<PointT>::Ptr;

  /** \brief The points to find neighbors among, instead of the input. */
  void
  setSearchSurface(const PointCloudConstPtr& surface)
  {
    surface_ = surface;
  }

  PointCloudConstPtr
  getSearchSurface() const
  {
    return surface_;
  }

  /** \brief Find neighbors with this instead of the much faster pcl::NeighborhoodSweep.
   * It is asked by several threads at once: use setNumberOfThreads(1) with one that is
   * not thread-safe. */
  void
  setSearchMethod(const SearchPtr& search)
  {
    search_ = search;
  }

  SearchPtr
  getSearchMethod() const
  {
    return search_;
  }

  /** \brief Your own normals: of the search surface (the input, if none is set), of
   * any length but 0, instead of those estimated here. \param[in] normals a pointer to
   * a cloud of normals, null for none */
  template <typename NormalsPtr>
  void
  setInputNormals(const NormalsPtr& normals)
  {
    normals_owner_ = normals;
    normals_ = XYZView();
    if (normals && !normals->empty())
      normals_ = {&(*normals)[0].normal_x,
                  sizeof((*normals)[0]) / sizeof(float),
                  normals->size()};
  }

  /** \brief Work as if no points were closer than this: the mean of the points in each
   * voxel of this size stands for them, and each point gets what the nearest mean gets.
   * It is much faster in dense clouds, and tolerates noise larger than the distances
   * between points.
   *
   * Where neighbors share noise that is larger than the distances between points, as
   * where points lie on the steps of a depth camera, a coarser one than this is taken:
   * ShapeField::resolution; where noise grows with the distances between points, a
   * finer one for what is near. Your own normals and setCloudNumbers() keep it as it is
   * set.
   * \param[in] meters between points; 0 (default) for the cloud's own */
  void
  setResolution(double meters)
  {
    resolution_ = meters;
  }

  double
  getResolution() const
  {
    return resolution_;
  }

  /** \brief One resolution for all of the cloud, as tiles have, even where noise grows
   * with the spacing. \param[in] one_resolution false (default) for zones there */
  void
  setOneResolution(bool one_resolution)
  {
    one_resolution_ = one_resolution;
  }

  bool
  getOneResolution() const
  {
    return one_resolution_;
  }

  /** \brief Two classes made in DENSITY mode, an edge and the rest, instead of
   * ShapeModel::defaultEdges(). */
  void
  setEdgeModel(const ShapeModel& model)
  {
    edge_model_ = model;
  }

  /** \brief Several classes made in DENSITY mode, instead of
   * ShapeModel::defaultSurfaces(). */
  void
  setSurfaceModel(const ShapeModel& model)
  {
    surface_model_ = model;
  }

  const ShapeModel&
  getEdgeModel() const
  {
    return edge_model_ ? *edge_model_ : ShapeModel::defaultEdges();
  }

  const ShapeModel&
  getSurfaceModel() const
  {
    return surface_model_ ? *surface_model_ : ShapeModel::defaultSurfaces();
  }

  /** \brief The input is a part of a cloud with these numbers: points that are farther
   * from its border than reachOf() says get the edges that they get in the whole cloud,
   * bit by bit. Only with setEdgesOnly(), without a resolution, and without normals. */
  void
  setCloudNumbers(const std::optional<CloudNumbers>& numbers)
  {
    numbers_ = numbers;
  }

  const std::optional<CloudNumbers>&
  getCloudNumbers() const
  {
    return numbers_;
  }

  /** \brief Leave the classes of surfaces out, which saves half of the time. */
  void
  setEdgesOnly(bool edges_only)
  {
    edges_only_ = edges_only;
  }

  bool
  getEdgesOnly() const
  {
    return edges_only_;
  }

  /** \param[in] threads 0 for all cores */
  void
  setNumberOfThreads(unsigned threads = 0)
  {
    threads_ = threads;
  }

  unsigned
  getNumberOfThreads() const
  {
    return threads_;
  }

  /** \brief What is wrong with the input or the settings; empty if nothing is. */
  std::string findProblem();

  /** \param[out] field with setIndices(), points without an index are unknown in it
   * \return false after an error message */
  bool compute(ShapeField& field);

private:
  /** \brief All but the finder. */
  detail::FieldRequest request() const;

  PointCloudConstPtr surface_;
  SearchPtr search_;
  shared_ptr<const void> normals_owner_;
  XYZView normals_;
  double resolution_ = 0.0;
  bool one_resolution_ = false;
  std::optional<ShapeModel> edge_model_;
  std::optional<ShapeModel> surface_model_;
  std::optional<CloudNumbers> numbers_;
  bool edges_only_ = false;
  unsigned threads_ = 0;
};

/** \brief What the classes share that work on a field: they take one, or make it.
 * \ingroup segmentation */
template <typename PointT>
class ShapeFieldUser : public PCLBase<PointT> {
public:
  using SearchPtr = typename pcl::search::Search<PointT>::Ptr;

  /** \brief What was computed for this cloud before, instead of doing it again. Its
   * settings count then: resolution, models, search and normals of this object are not
   * used. */
  void
  setShapeField(const ShapeField::ConstPtr& field)
  {
    field_ = field;
  }

  ShapeField::ConstPtr
  getShapeField() const
  {
    return field_;
  }

  /** \copydoc ShapeFieldEstimation::setSearchMethod */
  void
  setSearchMethod(const SearchPtr& search)
  {
    estimation_.setSearchMethod(search);
  }

  SearchPtr
  getSearchMethod() const
  {
    return estimation_.getSearchMethod();
  }

  /** \copydoc ShapeFieldEstimation::setResolution */
  void
  setResolution(double meters)
  {
    estimation_.setResolution(meters);
  }

  double
  getResolution() const
  {
    return estimation_.getResolution();
  }

  /** \param[in] threads 0 for all cores */
  void
  setNumberOfThreads(unsigned threads = 0)
  {
    estimation_.setNumberOfThreads(threads);
  }

  unsigned
  getNumberOfThreads() const
  {
    return estimation_.getNumberOfThreads();
  }

protected:
  /** \brief What is wrong with the input, or with the field for it; empty if nothing
   * is. */
  std::string findFieldProblem();

  /** \brief The field that was given, or a new one. */
  ShapeField::ConstPtr fieldOfInput();

  ShapeField::ConstPtr field_;
  ShapeFieldEstimation<PointT> estimation_;
};

} // namespace pcl

#ifdef PCL_NO_PRECOMPILE
#include <pcl/segmentation/impl/shape_field_estimation.hpp>
#endif
