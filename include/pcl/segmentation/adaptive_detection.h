/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * Point Cloud Library (PCL) - www.pointclouds.org
 * Copyright (c) 2026, pcl_shape contributors
 *
 * All rights reserved
 */

#pragma once

#include <pcl/features/adaptive_radius.h>
#include <pcl/features/shape_model.h>

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace pcl {

/** \brief What is at a point. */
enum class EdgeType : std::uint8_t {
  None = 0,
  Crease = 1,      ///< two faces meet
  Corner = 2,      ///< creases of different directions meet
  OpenBoundary = 3 ///< the surface ends; no crease, and no edge
};

/** \brief A point of a crease. \ingroup segmentation */
struct CreasePoint {
  std::array<float, 3> position{};  ///< metres
  std::array<float, 3> direction{}; ///< of the crease, unit, of either sign
  float angle = 0.0f;               ///< by which the surface turns, radians, 0 to pi
  float spacing = 0.0f;             ///< the local spacing there, metres
};

/** \brief A crease from one end to the other. \ingroup segmentation */
struct CreaseLine {
  std::vector<std::array<float, 3>> points; ///< metres, at least two, in order
  float length = 0.0f;                      ///< of the line through the points, metres
  float angle = 0.0f;   ///< by which the surface turns, radians, 0 to pi: the median
  float spacing = 0.0f; ///< of the points of the cloud there, metres: the median
  bool closed = false;  ///< the last point is the first
};

/** \brief Join crease points to lines, the longest first. Lines shorter than five
 * spacings are left out. See doc/method.md for the steps.
 *
 * The order of the points does not matter.
 * \throws std::invalid_argument that names the point, the value and what is allowed */
PCL_SHAPE_EXPORTS std::vector<CreaseLine>
creaseLines(const std::vector<CreasePoint>& creases);

namespace detail {

/** \brief A cloud, and how its neighborhoods are found. */
struct AdaptiveInput {
  const NeighborhoodStatistics& neighborhoods; ///< of all points of the cloud
  XYZView points;
  std::size_t finite = 0; ///< points
  unsigned threads = 0;
};

/** \brief What both detectors need of a cloud: its edges, and what they were found
 * with. */
struct AdaptiveEdges {
  std::vector<float> likelihood; ///< of an edge; NaN unknown
  std::vector<float> normals;    ///< three each, NaN unknown
  std::vector<float> spacings;   ///< metres
  double noise = 0.0;            ///< in spacings
  std::vector<CreasePoint> creases;
};

/** \brief Find the creases of a cloud. See doc/method.md for the steps.
 * \param[in] model two classes, the first of which is the edge */
PCL_SHAPE_EXPORTS AdaptiveEdges findEdges(const AdaptiveInput& input,
                                          const ShapeModel& model);

/** \brief What kind of edge each point is. \param[in] threshold as
 * ShapeDetection::setThreshold() */
PCL_SHAPE_EXPORTS std::vector<EdgeType>
edgeTypes(const AdaptiveInput& input, const AdaptiveEdges& edges, double threshold);

/** \brief The posterior of each class at each point, point by point.
 * \param[in] edges of the same cloud: they are not crossed */
PCL_SHAPE_EXPORTS std::vector<float> classifySurfaces(const AdaptiveInput& input,
                                                      const AdaptiveEdges& edges,
                                                      const ShapeModel& model);

/** \brief For each query the surface point it stands for: the nearest one within its
 * spacing, or -1. */
PCL_SHAPE_EXPORTS std::vector<std::int32_t>
representatives(const XYZView& queries,
                const XYZView& surface,
                const std::vector<float>& spacings,
                unsigned threads);

/** \brief What is wrong with a resolution, metres; empty if nothing is. */
PCL_SHAPE_EXPORTS std::string problemOfResolution(double resolution,
                                                  const XYZView& points);

/** \brief The mean of the finite points in each cell, three coordinates each, in an
 * order, and with values, that do not depend on the order of the points.
 * \param[in] size of a cell; problemOfResolution() knows which are allowed */
PCL_SHAPE_EXPORTS std::vector<float> thinned(const XYZView& points, double size);

} // namespace detail
} // namespace pcl
