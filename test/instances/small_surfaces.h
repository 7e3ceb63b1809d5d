// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Small surfaces for the parts of instance cutting, in units of the spacing.

#pragma once

#include "instances/pieces/surface_piece.h"
#include "support/shapes.h"

#include <vector>

/** Small surfaces for the parts of instance cutting. The unit is the spacing d. */
namespace pcl::test {

constexpr double half = 0.5; // between the points of a cloud whose spacing d is 1

/** \brief Points in rows, `step` apart. \param[in] across unit, as `along`; the normal
 * is along x across */
inline Surface
patch(const Eigen::Vector3d& origin,
      const Eigen::Vector3d& along,
      const Eigen::Vector3d& across,
      int columns,
      int rows,
      double step = half)
{
  Surface surface;
  for (int row = 0; row < rows; ++row)
    for (int column = 0; column < columns; ++column)
      surface.add(
          {origin + step * (column * along + row * across), along.cross(across)});
  return surface;
}

/** \brief Square to z, its normal up. */
inline Surface
floorPatch(double x, double y, double z, int columns, int rows, double step = half)
{
  return patch({x, y, z},
               Eigen::Vector3d::UnitX(),
               Eigen::Vector3d::UnitY(),
               columns,
               rows,
               step);
}

/** \brief Square to x at x = 0, its normal towards -x or +x. */
inline Surface
wallPatch(
    double y, double z, bool faces_forward, int columns, int rows, double step = half)
{
  Surface wall = patch({0.0, y, z},
                       Eigen::Vector3d::UnitY(),
                       Eigen::Vector3d::UnitZ(),
                       columns,
                       rows,
                       step);
  if (!faces_forward)
    for (float& component : wall.normals)
      component = -component;
  return wall;
}

inline Surface
together(Surface first, const Surface& second)
{
  first.append(second);
  return first;
}

/** \brief Of points without noise whose spacing is 1, all of the class and no edges.
 * \param[in] surface is kept, not copied */
inline detail::InstanceInput
inputOf(const Surface& surface)
{
  detail::InstanceInput input;
  input.points = surface.points();
  input.normals = surface.normals;
  input.spacings.assign(surface.size(), 1.0f);
  input.edge.assign(surface.size(), 0.0f);
  input.likelihood.assign(surface.size(), 1.0f);
  return input;
}

/** \brief The points as nodes. */
inline std::vector<segmentation::SurfaceNode>
nodesOf(const Surface& surface)
{
  std::vector<segmentation::SurfaceNode> nodes;
  for (std::size_t i = 0; i < surface.size(); ++i)
    nodes.push_back({surface.position(i).cast<float>(),
                     Eigen::Map<const Eigen::Vector3f>(&surface.normals[3 * i]),
                     1.0f,
                     0.0f});
  return nodes;
}

inline segmentation::NodeIndices
range(std::uint32_t begin, std::uint32_t end)
{
  segmentation::NodeIndices nodes;
  for (std::uint32_t node = begin; node < end; ++node)
    nodes.push_back(node);
  return nodes;
}

} // namespace pcl::test
