/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * Point Cloud Library (PCL) - www.pointclouds.org
 * Copyright (c) 2026, pcl_shape contributors
 *
 * All rights reserved
 */

#pragma once

#include <pcl/features/xyz_view.h>
#include <pcl/memory.h>
#include <pcl/pcl_shape_alignment.h>
#include <pcl/pcl_shape_exports.h>

#include <Eigen/Core>

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace pcl {

/** \brief A point of a crease. \ingroup segmentation */
struct CreasePoint {
  std::array<float, 3> position{};  ///< meters
  std::array<float, 3> direction{}; ///< of the crease, unit, of either sign
  float angle = 0.0f;               ///< by which the surface turns, radians, 0 to pi
  float spacing = 0.0f;             ///< the local spacing there, meters
};

/** \brief A crease from one end to the other. \ingroup segmentation */
struct CreaseLine {
  std::vector<std::array<float, 3>> points; ///< meters, at least two, in order
  float length = 0.0f;                      ///< of the line through the points, meters
  float angle = 0.0f;   ///< by which the surface turns, radians, 0 to pi: the median
  float spacing = 0.0f; ///< of the points of the cloud there, meters: the median
  bool closed = false;  ///< the last point is the first
};

/** \brief Join crease points to lines, the longest first. Lines shorter than five
 * spacings are left out. See doc/method.md for the steps.
 *
 * The order of the points does not matter.
 * \throws std::invalid_argument that names the point, the value and what it must be */
PCL_SHAPE_EXPORTS std::vector<CreaseLine>
creaseLines(const std::vector<CreasePoint>& creases);

/** \brief What is at a point. */
enum class EdgeType : std::uint8_t {
  None = 0,
  Crease = 1,      ///< two faces meet
  Corner = 2,      ///< creases of different directions meet
  OpenBoundary = 3 ///< the surface ends; no crease, and no edge
};

/** \brief What the tasks need to know of a cloud, computed once for all of them: see
 * ShapeFieldEstimation.
 *
 * Vectors have one entry for each point of the cloud. The cloud must not change while
 * its field is in use. \ingroup segmentation */
struct ShapeField {
  using Ptr = shared_ptr<ShapeField>;
  using ConstPtr = shared_ptr<const ShapeField>;

  shared_ptr<const void> cloud; ///< the cloud that this is the field of
  XYZView points;               ///< of that cloud

  std::vector<float> spacings; ///< see AdaptiveRadius, meters; NaN unknown
  double noise = 0.0;          ///< of the cloud, in spacings, 0 to 0.3
  double noise_level = 0.0; ///< that radii are chosen for: less where it averages out
  std::vector<Eigen::Vector3f> normals; ///< unit, towards the origin; NaN unknown
  std::vector<float> edge_likelihood;   ///< 0 to 1; NaN unknown
  std::vector<CreasePoint> creases;     ///< of the whole cloud
  std::vector<std::string> classes;     ///< of surfaces; none if only edges were wanted
  std::vector<std::vector<float>> likelihoods; ///< of every class; NaN unknown

  double resolution = 0.0; ///< meters, 0 for the cloud's own; at least the one set
  double finest_resolution = 0.0; ///< of its densest zone; less than the other only if
                                  ///< the noise grows with the distances between points
  /** \brief What the values were computed for, if these are not the cloud's own points:
   * the voxel means at the resolution, the points of another search surface, or, if
   * points are equal, one for each place.
   * Without a base no two points are equal. */
  ConstPtr base;
  std::vector<std::int32_t>
      base_points; ///< the point of it that each stands for, or -1

  /** \brief Whether this is the field of that cloud. */
  bool
  isOf(const void* other, std::size_t size) const
  {
    return cloud.get() == other && points.size == size;
  }
};

/** \brief The largest radius of curvature at which the default model tells surfaces
 * from planes: 300 local spacings, where that is the median; of a face less than 100
 * spacings wide, three times its width. See
 * ShapeFieldEstimation::setResolution(). \return meters, 0 if no spacing is known
 * \ingroup segmentation */
PCL_SHAPE_EXPORTS float largestCurvedRadius(const ShapeField& field);

} // namespace pcl
