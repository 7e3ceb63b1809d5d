// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// The floor of a hollow body that stands in another one.

#include "instances/objects/hollow_bodies.h"
#include "small_surfaces.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace {

using namespace pcl::test;
using Bodies = pcl::segmentation::Labels;

constexpr int rim_points = 100;

Surface
rim(double radius)
{
  Surface surface;
  for (int k = 0; k < rim_points; ++k) {
    const double turn = 2.0 * M_PI * k / rim_points;
    const Eigen::Vector3d out(std::cos(turn), std::sin(turn), 0.0);
    surface.add({radius * out + Eigen::Vector3d::UnitZ(), out});
  }
  return surface;
}

TEST(HollowBodies, AFloorBelongsToTheInnermostBodyAroundIt)
{
  const Surface floor = floorPatch(-2.0, -2.0, 0.0, 9, 9);
  const Surface surface = together(together(rim(10.0), rim(5.0)), floor);
  pcl::detail::InstanceInput input = inputOf(surface);
  input.view_point = {0.0f, 0.0f, 60.0f};
  Bodies patch_of(surface.size(), -1);
  std::fill(patch_of.begin() + 2 * rim_points, patch_of.end(), 0);
  for (const std::int32_t cup : {0, 1}) {
    Bodies bodies(surface.size(), -1);
    std::fill_n(bodies.begin(), rim_points, 1 - cup); // a tray around the cup
    std::fill_n(bodies.begin() + rim_points, rim_points, cup);
    pcl::segmentation::joinFloors(input, Eigen::Vector3f::UnitZ(), patch_of, bodies);
    EXPECT_EQ(std::count(bodies.begin() + 2 * rim_points, bodies.end(), cup), 81);
    EXPECT_EQ(std::count(bodies.begin(), bodies.end(), 1 - cup), rim_points);
  }
}

} // namespace
