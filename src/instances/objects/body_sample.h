// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// What walls and floors a body has, by some of its points.

#pragma once

#include "instances/instance_points.h"

#include <Eigen/Core>

#include <cstddef>
#include <vector>

namespace pcl::segmentation {

constexpr float max_upright = 0.8f; // of a wall's normal: steeper than 37 degrees

/** \brief Some points of a body, at most 500, in the order of their coordinates. */
struct BodySample {
  std::vector<Eigen::Vector3f> points;
  std::vector<Eigen::Vector3f> normals;
  Eigen::Vector3f middle = Eigen::Vector3f::Zero();
  Eigen::Vector3f facing = Eigen::Vector3f::Zero(); ///< mean normal, short if curved
  float low = 0.0f, high = 0.0f; ///< heights without the lowest and highest points
  float spacing = 0.0f;
  float upright = 0.0f; ///< share of the points on walls
  float level = 0.0f;   ///< share of the points on floors and lids
};

/** \brief A vector without its part along up, which is a unit vector. */
inline Eigen::Vector3f
levelPart(const Eigen::Vector3f& v, const Eigen::Vector3f& up)
{
  return v - v.dot(up) * up;
}

/** \brief Samples of the bodies 0 to count - 1, of points with normals; empty ones of
 * bodies without.
 * \param[in] bodies of each point; -1 none */
std::vector<BodySample> bodySamples(const detail::InstanceInput& input,
                                    const Eigen::Vector3f& up,
                                    const Labels& bodies,
                                    std::size_t count);

} // namespace pcl::segmentation
