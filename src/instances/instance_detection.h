// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Instances of a class or whole objects: the data they are found from, and the steps.

#pragma once

#include "geometry/point_grid.h"

#include <pcl/segmentation/shape_instance_segmentation.h>

#include <cstdint>
#include <optional>
#include <vector>

namespace pcl::detail {

/** \brief What instances are found from; one entry for each point. */
struct InstanceInput {
  XYZView points;
  std::vector<float> normals;    ///< three each, towards the viewpoint; NaN unknown
  std::vector<float> spacings;   ///< meters
  std::vector<float> edge;       ///< likelihood of an edge
  std::vector<float> likelihood; ///< of the class, of planar for objects; NaN unknown
  double noise = 0.0;            ///< in spacings
  Eigen::Vector3f view_point = Eigen::Vector3f::Zero();
  unsigned threads = 0;
  std::optional<float> median_spacing; ///< of the cloud that the points are a part of
  /** The finite points by their positions, where many steps want them so; else none. */
  std::vector<std::uint32_t> order;
};

/** \brief The instance of each point, 0 and up, -1 for none; the largest is first. */
using InstanceLabels = std::vector<std::int32_t>;

/** \brief Which points an instance of a class may hold: those whose likelihood is known
 * and at least the low one. \param[in] with_edges whether they may be on edges */
std::vector<char> membersOf(const InstanceInput& input, double low, bool with_edges);

/** \brief Whether enough of a piece's points have the high likelihood. */
bool isLikely(std::size_t points, std::size_t high_points);

/** \brief The size of the cells that points are visited in, meters. */
float gridCell(float median_spacing);

/** \brief Connected components of a class over its likelihood. See doc/instances.md for
 * the steps. \param[in] grid of the points, of such cells */
InstanceLabels findComponents(const InstanceInput& input,
                              const segmentation::PointGrid& grid,
                              const InstanceLimits& limits);

/** \brief Whole objects on a support, likewise. */
InstanceLabels findObjects(const InstanceInput& input,
                           const segmentation::PointGrid& grid,
                           const InstanceLimits& limits);

/** \brief Fit a primitive to some points of a cloud by RANSAC with a fixed seed
 * (pcl::SampleConsensus), and refine it by least squares.
 * \param[in] members the points; those on edges are left out if others are enough
 * \param[in] type Plane, Cylinder, Sphere, or Auto */
ShapePrimitive fitPrimitive(const InstanceInput& input,
                            std::vector<std::uint32_t> members,
                            PrimitiveType type);

} // namespace pcl::detail
