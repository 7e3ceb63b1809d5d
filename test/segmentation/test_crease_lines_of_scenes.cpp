/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * Point Cloud Library (PCL) - www.pointclouds.org
 * Copyright (c) 2026, pcl_shape contributors
 *
 * All rights reserved
 */

#include "detection_scenes.h"
#include "scene/creases.h"
#include "scene/random_world.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace {

using namespace pcl;
using namespace pcl::test;
using Lines = std::vector<CreaseLine>;

scene::Vec3
along(const CreaseLine& line, std::size_t part, double fraction)
{
  const auto at = [&](std::size_t i) {
    return scene::Vec3{line.points[i][0], line.points[i][1], line.points[i][2]};
  };
  return at(part) + (at(part + 1) - at(part)) * fraction;
}

/** \brief Visits points of lines 0.5 mm apart, and the length that each stands for. */
template <typename Visit>
void
walk(const Lines& lines, const Visit& visit)
{
  for (const CreaseLine& line : lines) {
    for (std::size_t part = 0; part + 1 < line.points.size(); ++part) {
      const double length = norm(along(line, part, 1) - along(line, part, 0));
      const int steps = 1 + static_cast<int>(length / 0.0005);
      for (int s = 0; s < steps; ++s) {
        visit(along(line, part, (s + 0.5) / steps), length / steps);
      }
    }
  }
}

TEST(CreaseLinesOfScenes, FollowTheCreasesOfScenes)
{
  for (const std::uint64_t seed : {21U, 22U, 23U}) {
    scene::SampleOptions options;
    options.seed = seed;
    options.objects = 3;
    const Lines lines =
        creaseLines(detectedIn(cloudOf(scene::sampleScene(options))).creases);
    scene::SceneOptions same;
    same.seed = seed;
    same.objects = options.objects;
    const scene::World world = scene::randomWorld(same).world;
    const scene::Creases truth(world, scene::Observer{});

    const double near = 2 * options.spacing; // as the truth's edge points
    double length = 0, off = 0;
    std::vector<scene::Vec3> points;
    walk(lines, [&](const scene::Vec3& p, double piece) {
      length += piece;
      off += truth.distance(p, 1.0) > near ? piece : 0;
      points.push_back(p);
    });
    EXPECT_LE(off, 0.03 * length) << "seed " << seed;

    double covered = 0, all = 0;
    for (const scene::Curve& crease : truth.parts()) {
      for (int s = 0; s < 100; ++s) {
        const scene::Vec3 p = crease.point(crease.parameter((s + 0.5) / 100));
        const double piece =
            crease.length() * std::abs(crease.parameter(1) - crease.parameter(0)) / 100;
        all += piece;
        covered += std::any_of(points.begin(),
                               points.end(),
                               [&](const auto& q) { return norm(p - q) < 2 * near; })
                       ? piece
                       : 0;
      }
    }
    EXPECT_GE(covered, 0.85 * all) << "seed " << seed;
    EXPECT_LE(length, 1.1 * all) << "no line twice, seed " << seed;
  }
}

} // namespace
