/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * Point Cloud Library (PCL) - www.pointclouds.org
 * Copyright (c) 2026, pcl_shape contributors
 *
 * All rights reserved
 */

#include "coarse_ground.h"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>

namespace pcl::segmentation {
namespace {

constexpr std::uint32_t bins_an_octave = 16; // see groundCells()
constexpr std::size_t least_patches = 12;    // of a plane
constexpr int rounds = 3;
constexpr double bend = 0.03; // of the ground from the plane, per metre of the range

} // namespace

CoarseGround::CoarseGround(const GroundCells& cells,
                           const GroundPatches& all,
                           const std::vector<char>& is_level,
                           float max_step)
: cells_(cells)
, all_(all)
, max_step_(max_step)
{
  std::vector<std::vector<std::size_t>> patches;
  for (std::size_t i = 0; i < is_level.size(); ++i) {
    const std::size_t octave = octaveOf(i);
    patches.resize(std::max(patches.size(), octave + 1));
    if (is_level[i])
      patches[octave].push_back(i);
  }
  const auto size = [](const auto& one, const auto& other) {
    return one.size() < other.size();
  };
  // Ground surrounds what is nearer than most of it; there may be more of cars there.
  const auto surest = std::max_element(patches.begin(), patches.end(), size);
  Plane plane; // what heights are measured from
  for (auto of_octave = surest; of_octave != patches.end(); ++of_octave) {
    for (int round = 0; round < rounds; ++round)
      refit(*of_octave, plane);
    planes_.resize(static_cast<std::size_t>(of_octave - patches.begin()) + 1, plane);
  }
}

bool
CoarseGround::isNear(std::size_t patch) const
{
  return isNear(planes_[octaveOf(patch)], patch);
}

double
CoarseGround::above(const Plane& plane, std::size_t patch) const
{
  const GroundPatch& p = all_.patches[patch];
  return p.low - (plane.z + plane.slope_x * p.x + plane.slope_y * p.y);
}

bool
CoarseGround::isNear(const Plane& plane, std::size_t patch) const
{
  const GroundPatch& p = all_.patches[patch];
  const double range = std::sqrt(double{p.x} * p.x + double{p.y} * p.y);
  return std::abs(above(plane, patch)) <= max_step_ + bend * range;
}

void
CoarseGround::refit(const std::vector<std::size_t>& patches, Plane& plane) const
{
  Eigen::Matrix3d squares = Eigen::Matrix3d::Zero();
  Eigen::Vector3d products = Eigen::Vector3d::Zero();
  std::size_t count = 0;
  for (const std::size_t i : patches) {
    if (!isNear(plane, i))
      continue;
    const GroundPatch& p = all_.patches[i];
    const Eigen::Vector3d row(1.0, p.x, p.y);
    squares += row * row.transpose();
    products += row * double{p.low};
    ++count;
  }
  if (count < least_patches)
    return;
  const Eigen::Vector3d solution = squares.ldlt().solve(products);
  if (solution.allFinite())
    plane = {solution[0], solution[1], solution[2]};
}

std::size_t
CoarseGround::octaveOf(std::size_t patch) const
{
  return cells_.bins[patch] / bins_an_octave;
}

} // namespace pcl::segmentation
