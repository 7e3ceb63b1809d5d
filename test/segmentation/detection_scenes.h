// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Scenes and scores for the tests of the default mode.

#pragma once

#include "scene/scene.h"
#include "scene/sensors/surface_samples.h"
#include "support/clouds.h"

#include <pcl/segmentation/shape_edge_detection.h>

#include <cstdint>
#include <vector>

/** What the tests of the default mode share. */
namespace pcl::test {

using Cloud = PointCloud<PointXYZ>;
using Labels = std::vector<std::uint32_t>;
using Likelihoods = std::vector<std::vector<float>>;

inline Cloud::Ptr
cloudOf(const scene::Scene& scene)
{
  const auto cloud = make_shared<Cloud>(scene.width, scene.height);
  for (std::size_t i = 0; i < cloud->size(); ++i)
    (*cloud)[i].getVector3fMap() = Eigen::Map<const Eigen::Vector3f>(&scene.xyz[3 * i]);
  cloud->is_dense = false;
  return cloud;
}

inline scene::Scene
cameraScene(std::uint64_t seed, scene::Noise noise = scene::Noise::Kinect)
{
  scene::SceneOptions options;
  options.seed = seed;
  options.noise = noise;
  return scene::generateScene(options);
}

inline scene::Scene
sampledScene(std::uint64_t seed)
{
  scene::SampleOptions options;
  options.seed = seed;
  options.objects = 2;
  return scene::sampleScene(options);
}

template <typename Detection>
Likelihoods
likelihoodsOf(Detection& detection, const Cloud::Ptr& cloud)
{
  detection.setInputCloud(cloud);
  Likelihoods likelihoods;
  detection.compute(likelihoods);
  return likelihoods;
}

inline std::vector<float>
edgesOf(const Cloud::Ptr& cloud, unsigned threads = 0)
{
  ShapeEdgeDetection<PointXYZ> detection;
  detection.setNumberOfThreads(threads);
  return likelihoodsOf(detection, cloud).at(0);
}

/** \brief F1 of one label against those of `others`; unknown counts as negative. */
inline double
f1(const std::vector<float>& likelihood,
   const Labels& truth,
   std::uint32_t label,
   std::uint32_t others)
{
  double hits = 0, misses = 0, false_alarms = 0;
  for (std::size_t i = 0; i < truth.size(); ++i) {
    const bool is_found = likelihood[i] > 0.5f;
    hits += truth[i] == label && is_found ? 1 : 0;
    misses += truth[i] == label && !is_found ? 1 : 0;
    false_alarms += truth[i] == others && is_found ? 1 : 0;
  }
  return 2 * hits / (2 * hits + misses + false_alarms);
}

inline Edges
detectedIn(const Cloud::Ptr& cloud, unsigned threads = 0)
{
  ShapeEdgeDetection<PointXYZ> detection;
  detection.setNumberOfThreads(threads);
  detection.setInputCloud(cloud);
  Edges edges;
  detection.detect(edges);
  return edges;
}

/** \brief A random point on a cube's surface, of side 1. */
inline SurfacePoint
onCube(Random& random)
{
  const std::size_t axis = random.index(3);
  Eigen::Vector3d p(random.uniform(), random.uniform(), random.uniform());
  Eigen::Vector3d n = Eigen::Vector3d::Zero();
  const double side = random.uniform() < 0.5 ? 0.0 : 1.0;
  p[static_cast<Eigen::Index>(axis)] = side;
  n[static_cast<Eigen::Index>(axis)] = 2.0 * side - 1.0;
  return {p, n};
}

} // namespace pcl::test
