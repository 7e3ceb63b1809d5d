// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Suction grasps on generated scenes.

#include "grasp_trials.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace {

using namespace pcl;
using namespace pcl::test;

constexpr double cup_radius = 0.01;

/** \brief Sealing and one-face grasps of the targets that show a face of twice the cup.
 */
struct Counts {
  int targets = 0, sealed = 0, on_one_face = 0, curved = 0;
};

Counts
countsOf(scene::Noise noise, std::uint64_t first_seed, std::uint64_t scenes)
{
  Counts counts;
  for (std::uint64_t seed = first_seed; seed < first_seed + scenes; ++seed) {
    for (const GraspTrial& trial : graspTrials(seed, noise, cup_radius)) {
      if (!trial.shows_twice_the_cup)
        continue;
      ++counts.targets;
      counts.curved += trial.is_curved ? 1 : 0;
      counts.sealed += !trial.grasps.empty() && trial.grasps[0].seals() ? 1 : 0;
      counts.on_one_face += trial.is_on_one_face ? 1 : 0;
    }
  }
  return counts;
}

void
expectEnough(const Counts& counts)
{
  EXPECT_GE(counts.targets, 5);
  EXPECT_GE(counts.curved, 1);
  EXPECT_GE(counts.targets - counts.curved, 1);
  EXPECT_GE(counts.sealed, 0.95 * counts.targets);
  EXPECT_GE(counts.on_one_face, 0.98 * counts.targets);
}

TEST(SuctionGraspsOfScenes, AreFoundOnOneFaceWithADepthCamerasNoise)
{
  expectEnough(countsOf(scene::Noise::Kinect, 501, 4));
}

TEST(SuctionGraspsOfScenes, AreFoundOnOneFaceWithoutNoise)
{
  expectEnough(countsOf(scene::Noise::None, 601, 4));
}

TEST(GraspScene, HasSmallerObjectsOnItsTargetsAndBeforeThem)
{
  std::size_t ridden = 0;
  int hidden = 0;
  for (const std::uint64_t seed : {701U, 702U, 703U, 704U, 705U}) {
    scene::SceneOptions options;
    options.seed = seed;
    options.noise = scene::Noise::None;
    const scene::GraspScene scene = scene::graspScene(options);
    ASSERT_EQ(scene.targets.size(), 2U);
    ridden += scene.world.solids.size() - 4; // a target and what is before it, twice
    for (const std::size_t target : scene.targets) {
      scene::World alone = scene.world;
      alone.solids = {scene.world.solids[target - 1]};
      const auto pixelsOf = [](const scene::World& world, int object) {
        const scene::View view = scene::look(world);
        return std::count_if(view.sights.begin(),
                             view.sights.end(),
                             [&](const auto& sight) { return sight.object == object; });
      };
      hidden += pixelsOf(scene.world, static_cast<int>(target)) < pixelsOf(alone, 1);
    }
  }
  EXPECT_GE(ridden, 4U);
  EXPECT_GE(hidden, 8);
}

TEST(GraspScene, KnowsDiscsOnOneFace)
{
  scene::World world;
  const scene::Vec3 down{0, 0, -1}, top{0, 0, 0.1};
  scene::Solid box{scene::Shape::Box, {0.1, 0.1, 0.1}, {}};
  box.pose.origin = {0, 0, 0.05};
  world.solids.push_back(box);
  EXPECT_TRUE(scene::isOnOneFace(world, 1, top, down, 0.049, 0.02));
  EXPECT_FALSE(scene::isOnOneFace(world, 1, top, down, 0.051, 0.02)) << "off the rim";
  EXPECT_TRUE(scene::isOnOneFace(world, 1, {0.03, 0, 0.1}, down, 0.019, 0.02));
  EXPECT_FALSE(scene::isOnOneFace(world, 1, {0.03, 0, 0.1}, down, 0.021, 0.02));

  scene::Solid rider{scene::Shape::Box, {0.04, 0.04, 0.06}, {}};
  rider.pose.origin = {0.0, 0, 0.13};
  world.solids.push_back(rider);
  EXPECT_FALSE(scene::isOnOneFace(world, 1, top, down, 0.01, 0.02)) << "under it";
  EXPECT_FALSE(scene::isOnOneFace(world, 1, {0.03, 0, 0.1}, down, 0.0105, 0.02));
  EXPECT_TRUE(scene::isOnOneFace(world, 1, {0.03, 0, 0.1}, down, 0.0095, 0.02));
  world.solids[1].pose.origin.z += 0.015;
  EXPECT_FALSE(scene::isOnOneFace(world, 1, top, down, 0.01, 0.02)) << "in the way";
  EXPECT_TRUE(scene::isOnOneFace(world, 1, top, down, 0.01, 0.01));
}

} // namespace
