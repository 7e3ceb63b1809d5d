/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * Point Cloud Library (PCL) - www.pointclouds.org
 * Copyright (c) 2026, pcl_shape contributors
 *
 * All rights reserved
 */

#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace pcl::app {

using Vector = std::array<float, 3>;

/** \brief A crease of pcl_shape_edge_detection -lines. */
struct Line {
  std::vector<Vector> points; ///< metres, at least two
  float spacing;              ///< metres
};

/** \brief An object of pcl_shape_instances -json. */
struct Instance {
  std::uint32_t id; ///< its value in the field instance
  std::string name; ///< its class, and its primitive if it has one
  Vector centroid;  ///< metres
};

/** \brief A grasp of pcl_shape_grasp -json. */
struct Grasp {
  Vector position; ///< metres, on the surface
  Vector approach; ///< unit, into the surface
  bool seals;
};

struct Grasps {
  std::vector<Grasp> grasps; ///< the best first
  float cup_radius;          ///< metres; of the file, or 20 mm
};

/** \brief Read one of these files.
 * \throws InputError that names the file, the member and what is allowed */
std::vector<Line> readLines(const std::string& path);

std::vector<Instance> readInstances(const std::string& path);

Grasps readGrasps(const std::string& path);

} // namespace pcl::app
