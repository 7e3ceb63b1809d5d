/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * Point Cloud Library (PCL) - www.pointclouds.org
 * Copyright (c) 2026, pcl_shape contributors
 *
 * All rights reserved
 */

#include "ground_frame.h"

#include "../kernels/parallel.h"

#include <Eigen/Geometry>

#include <cstring>

namespace pcl::segmentation {
namespace {

std::uint32_t
keyOf(float squared_range)
{
  std::uint32_t bits = 0;
  std::memcpy(&bits, &squared_range, sizeof bits);
  return bits >> key_shift;
}

} // namespace

float
leastOf(std::uint32_t key)
{
  const std::uint32_t bits = key << key_shift;
  float squared_range = 0.0f;
  std::memcpy(&squared_range, &bits, sizeof bits);
  return squared_range;
}

Turned
turned(const detail::GroundQuery& input, const std::array<float, 3>& direction)
{
  const Eigen::Vector3f up = Eigen::Map<const Eigen::Vector3f>(direction.data());
  const Eigen::Matrix3f turn =
      Eigen::Quaternionf::FromTwoVectors(up, Eigen::Vector3f::UnitZ())
          .toRotationMatrix();
  const Eigen::Vector3f origin = Eigen::Map<const Eigen::Vector3f>(input.origin.data());
  const auto make = [&](auto& values) { values.resize(input.size); };
  Turned t;
  make(t.x), make(t.y), make(t.z), make(t.cells);
  kernels::parallelForRanges(
      input.size, input.threads, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
          const std::size_t at =
              input.indices ? static_cast<std::size_t>(input.indices[i]) : i;
          const Eigen::Vector3f p =
              turn * (Eigen::Map<const Eigen::Vector3f>(input.points[at]) - origin);
          t.x[i] = p.x();
          t.y[i] = p.y();
          t.z[i] = p.z();
          const float squared = p.x() * p.x() + p.y() * p.y();
          const bool is_finite = (squared - squared) + (p.z() - p.z()) == 0.0f;
          t.cells[i] = is_finite ? keyOf(squared) : no_cell;
        }
      });
  return t;
}

std::vector<std::uint32_t>
countKeys(const Turned& points)
{
  std::vector<std::uint32_t> counts(keys, 0);
  for (const std::uint32_t key : points.cells)
    if (key != no_cell)
      ++counts[key];
  return counts;
}

std::uint32_t
keyAt(const std::vector<std::uint32_t>& counts, std::uint64_t points, double share)
{
  std::uint64_t sum = 0;
  std::uint32_t key = 0;
  while (key + 1 < keys &&
         static_cast<double>(sum += counts[key]) < share * static_cast<double>(points))
    ++key;
  return key;
}

} // namespace pcl::segmentation
