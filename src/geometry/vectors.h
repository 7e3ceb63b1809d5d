// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Three coordinates as Eigen's vector, and back.

#pragma once

#include <Eigen/Core>

#include <array>

namespace pcl::segmentation {

inline Eigen::Vector3f
toVector(const std::array<float, 3>& v)
{
  return Eigen::Map<const Eigen::Vector3f>(v.data());
}

inline std::array<float, 3>
toArray(const Eigen::Vector3f& v)
{
  return {v.x(), v.y(), v.z()};
}

} // namespace pcl::segmentation
