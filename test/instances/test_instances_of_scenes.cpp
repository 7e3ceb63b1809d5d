// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Cylinders, boxes and faces are found in generated scenes.

#include "instance_scenes.h"

#include <gtest/gtest.h>

#include <cmath>

// How many instances are found in scenes with truth: 95 % of those with 300 points or
// more, with an IoU of 0.7.
namespace {

using namespace pcl;
using namespace pcl::test;
using scene::Shape;

constexpr double least_share = 0.95;

scene::Scene
sceneOf(std::uint64_t seed, unsigned objects, const std::vector<Shape>& shapes)
{
  scene::SceneOptions options;
  options.seed = seed;
  options.objects = objects;
  options.shapes = shapes;
  return scene::generateScene(options);
}

Found
curvedSides(const scene::Scene& scene)
{
  Labels truth = scene.instance;
  std::vector<bool> evaluated;
  for (std::size_t i = 0; i < truth.size(); ++i) {
    const std::uint32_t surface = scene.surface[i];
    truth[i] = surface == scene::SurfaceCurved ? truth[i] : 0;
    evaluated.push_back(surface == scene::SurfaceCurved ||
                        surface == scene::SurfacePlanar);
  }
  return compare(truth, instancesOf(cloudOf(scene), "curved"), evaluated);
}

Found
objects(const scene::Scene& scene)
{
  std::vector<bool> evaluated;
  for (const std::uint32_t surface : scene.surface)
    evaluated.push_back(surface != scene::SurfaceVoid);
  return compare(scene.instance, instancesOf(cloudOf(scene), "object"), evaluated);
}

/** \brief Flat faces, the table among them. */
Found
faces(const scene::Scene& scene)
{
  constexpr std::uint32_t faces_of_a_box = 6;
  Labels truth;
  std::vector<bool> evaluated;
  for (std::size_t i = 0; i < scene.surface.size(); ++i) {
    const std::uint32_t instance = scene.instance[i];
    truth.push_back(1 + (instance > 0 ? faces_of_a_box * instance + scene.face[i] : 0));
    evaluated.push_back(scene.surface[i] == scene::SurfacePlanar);
  }
  return compare(truth, instancesOf(cloudOf(scene), "planar"), evaluated);
}

TEST(InstancesOfScenes, CylindersAreFound)
{
  Found sum;
  for (const unsigned objects : {1U, 4U, 8U, 12U})
    sum += curvedSides(sceneOf(700 + objects, objects, {Shape::Cylinder}));
  EXPECT_GE(sum.share(), least_share) << sum.found << " of " << sum.instances;
}

TEST(InstancesOfScenes, BoxesAreFoundAsWholeObjects)
{
  Found sum;
  for (const unsigned count : {1U, 4U, 8U, 12U})
    sum += objects(sceneOf(800 + count, count, {Shape::Box}));
  EXPECT_GE(sum.share(), least_share) << sum.found << " of " << sum.instances;
}

TEST(InstancesOfScenes, BinsAreNoObjects)
{
  constexpr double most =
      0.05; // the rims of the walls are .03 of what is seen of a bin
  Found sum;
  for (const std::uint64_t seed : {901U, 902U, 903U, 904U}) {
    scene::SceneOptions options;
    options.seed = seed;
    options.objects = 6;
    options.in_bin = true;
    options.noise = seed % 2 == 0 ? scene::Noise::Structured : scene::Noise::Stereo;
    const scene::Scene scene = scene::generateScene(options);
    const Labels found = instancesOf(cloudOf(scene), "object");
    std::size_t of_supports = 0, taken = 0;
    for (std::size_t i = 0; i < found.size(); ++i)
      if (scene.instance[i] == 0 && !std::isnan(scene.xyz[3 * i])) {
        ++of_supports;
        taken += found[i] > 0;
      }
    EXPECT_LT(static_cast<double>(taken), most * static_cast<double>(of_supports))
        << seed;
    sum += compare(scene.instance, found, std::vector<bool>(found.size(), true));
  }
  EXPECT_GE(sum.share(), 0.75) << "from above less is seen of objects that touch";
}

TEST(InstancesOfScenes, FacesOfBoxesAreFound)
{
  Found sum;
  for (const unsigned count : {2U, 6U, 10U})
    sum += faces(sceneOf(600 + count, count, {Shape::Box}));
  EXPECT_GE(sum.share(), least_share) << sum.found << " of " << sum.instances;
}

} // namespace
