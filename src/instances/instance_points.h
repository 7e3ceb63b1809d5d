// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// What all steps of instance detection share: labels, normals, and limits by the noise.

#pragma once

#include "common/statistics.h"
#include "geometry/point_choice.h"
#include "instances/instance_detection.h"

#include <Eigen/Core>

#include <algorithm>
#include <cstdint>
#include <iterator>
#include <vector>

namespace pcl::segmentation {

using Labels = std::vector<std::int32_t>; ///< of points; -1 none

constexpr float edge_threshold = 0.5f; // more likely an edge than not

inline Eigen::Vector3f
normalOf(const detail::InstanceInput& input, std::size_t i)
{
  return Eigen::Map<const Eigen::Vector3f>(&input.normals[3 * i]);
}

inline float
medianSpacing(const detail::InstanceInput& input)
{
  return input.median_spacing ? *input.median_spacing : medianSpacing(input.spacings);
}

/** \brief The points that are asked for, by their positions. */
template <typename Is>
std::vector<std::uint32_t>
pointsInOrder(const detail::InstanceInput& input, const Is& is)
{
  std::vector<std::uint32_t> points;
  if (!input.order.empty()) {
    std::copy_if(
        input.order.begin(), input.order.end(), std::back_inserter(points), is);
    return points;
  }
  for (std::uint32_t i = 0; i < input.points.size; ++i)
    if (is(i))
      points.push_back(i);
  sortByPosition(input.points, points);
  return points;
}

/** \brief The points of each label, by their positions. \param[in] count of labels
 * \param[in] is which points count */
template <typename Is>
std::vector<std::vector<std::uint32_t>>
membersInOrder(const detail::InstanceInput& input,
               const Labels& labels,
               std::size_t count,
               const Is& is)
{
  std::vector<std::vector<std::uint32_t>> members(count);
  for (const std::uint32_t i :
       pointsInOrder(input, [&](std::uint32_t k) { return labels[k] >= 0 && is(k); }))
    members[static_cast<std::size_t>(labels[i])].push_back(i);
  return members;
}

/** \brief The same normal, or its opposite: the one towards where a point was seen
 * from. */
inline Eigen::Vector3f
turnedNormal(const Eigen::Vector3f& normal,
             const Eigen::Vector3f& position,
             const Eigen::Vector3f& view_point)
{
  if (normal.dot(view_point - position) < 0.0f)
    return -normal;
  return normal;
}

/** \brief How far a point may be off a surface, in spacings: two and a half times the
 * noise, and a little where the surface is not quite what it is taken for. */
inline float
offsetLimit(const detail::InstanceInput& input)
{
  return 0.3f + 2.5f * static_cast<float>(input.noise);
}

/** \brief How far two pieces of one surface may be apart where they meet, in spacings:
 * with a Kinect's noise of 0.2 it is 0.4, about 1.5 mm at 0.8 m. */
inline float
stepLimit(float noise)
{
  return 0.15f + 1.25f * noise;
}

inline float
stepLimit(const detail::InstanceInput& input)
{
  return stepLimit(static_cast<float>(input.noise));
}

} // namespace pcl::segmentation
