// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Kinds of edges of generated scenes beside their exact creases.

#include "crease_truth.h"
#include "scene/sensors/depth_cameras.h"
#include "scene/worlds/random_world.h"
#include "segmentation/detection_scenes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace {

using namespace pcl;
using namespace pcl::test;
using scene::Vec3;

/** \brief How many points of one kind there are, and how many were called so. */
struct Share {
  double all = 0, found = 0;

  void
  add(bool is_found)
  {
    all += 1;
    found += is_found ? 1 : 0;
  }

  double
  value() const
  {
    return found / all;
  }
};

struct Shares {
  Share creases, corners, rim, inside, right_corners;

  /** \brief A point of a scene: a type is a matter of points that were found to be
   * edges. \param[in] spacing mean distance of points, meters */
  void
  addEdge(EdgeType type,
          const Vec3& p,
          double to_crease,
          const CreaseTruth& truth,
          double spacing)
  {
    if (type != EdgeType::Crease && type != EdgeType::Corner)
      return;
    const double to_corner = truth.toCorner(p);
    if (to_crease < 2 * spacing && to_corner > 8 * spacing)
      creases.add(type == EdgeType::Crease);
    if (to_corner < 2 * spacing)
      corners.add(type == EdgeType::Corner);
    if (type == EdgeType::Corner)
      right_corners.add(truth.creasesMeetWithin(p, 5 * spacing));
  }
};

double
toRim(const scene::Table& table, const Vec3& p)
{
  const Vec3 d = p - table.center;
  return std::min(table.half_length - std::abs(dot(d, table.along)),
                  table.half_width - std::abs(dot(d, table.across)));
}

Vec3
positionIn(const scene::Scene& scene, std::size_t i)
{
  return {scene.xyz[3 * i], scene.xyz[3 * i + 1], scene.xyz[3 * i + 2]};
}

void
addSampledScene(std::uint64_t seed, Shares& shares)
{
  scene::SampleOptions options;
  options.seed = seed;
  options.objects = 3;
  const double spacing = options.spacing;
  const scene::Scene scene = scene::sampleScene(options);
  scene::SceneOptions same;
  same.seed = options.seed;
  same.objects = options.objects;
  scene::World world = scene::randomWorld(same).world;
  world.table.half_length *= 0.5; // sampleScene() crops it so
  world.table.half_width *= 0.6;
  const CreaseTruth truth(world, scene::Observer{}, spacing);
  ASSERT_GT(truth.corners(), 0U) << "seed " << seed;
  const auto types = detectedIn(cloudOf(scene)).types;
  for (std::size_t i = 0; i < types.size(); ++i) {
    const Vec3 p = positionIn(scene, i);
    const double to_crease = scene.crease_mm[i] / 1000;
    shares.addEdge(types[i], p, to_crease, truth, spacing);
    const double to_rim = scene.instance[i] == 0 ? toRim(world.table, p) : 1.0;
    if (to_crease > 8 * spacing && to_rim < 0.1 * spacing)
      shares.rim.add(types[i] == EdgeType::OpenBoundary);
    if (scene.edge[i] == scene::EdgeNot && to_rim > 2 * spacing)
      shares.inside.add(types[i] == EdgeType::None);
  }
}

/** \param[in] moved along each axis, meters */
void
addCameraScene(std::uint64_t seed, float moved, Shares& shares)
{
  scene::SceneOptions options;
  options.seed = seed;
  options.objects = 4;
  options.shapes = {scene::Shape::Box, scene::Shape::Box, scene::Shape::Cylinder};
  const scene::Scene scene = scene::generateScene(options);
  const auto cloud = cloudOf(scene);
  for (auto& point : *cloud)
    point.getArray3fMap() += moved;
  const Edges edges = detectedIn(cloud);
  ASSERT_FALSE(edges.creases.empty()) << "seed " << seed;
  const double spacing = edges.creases[edges.creases.size() / 2].spacing / 2;
  const scene::World world = scene::randomWorld(options).world;
  const CreaseTruth truth(
      world, scene::depthObserver(scene::Noise::Kinect, world), spacing);
  for (std::size_t i = 0; i < edges.types.size(); ++i) {
    const Vec3 p = world.camera.pose.toWorld(positionIn(scene, i));
    shares.addEdge(edges.types[i], p, scene.crease_mm[i] / 1000, truth, spacing);
    if (scene.edge[i] == scene::EdgeNot)
      shares.inside.add(edges.types[i] == EdgeType::None);
  }
}

TEST(EdgeTypesOfScenes, CreasesCornersAndTheTablesRim)
{
  Shares shares;
  for (const std::uint64_t seed : {31U, 32U, 33U, 201U, 202U, 203U, 204U, 205U})
    addSampledScene(seed, shares);
  ASSERT_GT(shares.rim.all, 100);
  ASSERT_GT(shares.corners.all, 1000);
  // Almost all of what is far from any doubt; at corners three faces meet, which two
  // planes do not fit, and edges of stacked objects cross at less than 45 degrees.
  EXPECT_GE(shares.creases.value(), 0.98);
  EXPECT_GE(shares.corners.value(), 0.87);
  EXPECT_GE(shares.right_corners.value(), 0.87);
  EXPECT_GE(shares.rim.value(), 0.90);
  EXPECT_GE(shares.inside.value(), 0.98);
}

TEST(EdgeTypesOfScenes, CreasesAndCornersOfADepthCamera)
{
  // Which points a fit takes depends on where cells of space begin, and with it the
  // share of few corners by a tenth: each scene is looked at in four places.
  Shares shares;
  for (const std::uint64_t seed : {201U, 202U, 203U, 204U, 205U, 206U, 207U, 208U})
    for (const float moved : {0.0f, 0.001f, 0.002f, 0.003f})
      addCameraScene(seed, moved, shares);
  ASSERT_GT(shares.corners.all, 4 * 150);
  EXPECT_GE(shares.creases.value(), 0.99);
  EXPECT_GE(shares.corners.value(), 0.67);
  EXPECT_GE(shares.right_corners.value(), 0.80);
  EXPECT_GE(shares.inside.value(), 0.98);
}

} // namespace
