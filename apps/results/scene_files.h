// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// The JSON files that describe a cloud: what was found in it, and where.

#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace pcl::app {

using Vector = std::array<float, 3>;

/** \brief A crease of pcl_shape_edge_detection -lines. */
struct Line {
  std::vector<Vector> points; ///< meters, at least two
  float spacing;              ///< meters
};

/** \brief An object of pcl_shape_instances -json. */
struct Instance {
  std::uint32_t id; ///< its value in the field instance
  std::string name; ///< its class, and its primitive if it has one
  Vector centroid;  ///< meters
};

/** \brief A grasp of pcl_shape_grasp -json. */
struct Grasp {
  Vector position; ///< meters, on the surface
  Vector approach; ///< unit, into the surface
  bool seals;
  std::uint32_t object = 0;            ///< if readGraspsOfObjects() read it
  std::vector<std::string> problems{}; ///< why it does not seal
};

/** \brief Grasps to be drawn. */
struct Grasps {
  std::vector<Grasp> grasps; ///< the best first
  float cup_radius;          ///< meters; of the file, or pcl_shape_grasp's default
};

/** \brief What pcl_shape_grasp -each wrote, complete. */
struct GraspsOfObjects {
  std::vector<Grasp> grasps; ///< each with its object, the best of each first
  float cup_radius;          ///< meters
  double compliance;         ///< in radii, by which the lip may bend
  std::uint32_t parts;       ///< labels to an object
  std::string field{};       ///< of the labels
};

/** \brief Read one of these files.
 * \throws InputError that names the file, the member and what is expected */
std::vector<Line> readLines(const std::string& path);

std::vector<Instance> readInstances(const std::string& path);

Grasps readGrasps(const std::string& path);

GraspsOfObjects readGraspsOfObjects(const std::string& path);

} // namespace pcl::app
