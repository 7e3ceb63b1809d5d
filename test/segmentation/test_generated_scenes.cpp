// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Generated scenes are as hard as real ones.

#include "scene/scene.h"

#include <pcl/point_types.h>
#include <pcl/segmentation/shape_edge_detection.h>

#include <gtest/gtest.h>

#include <cstdint>
#include <vector>

// A scene that is easier than reality proves nothing: the paper's method must do about
// as well on generated scenes as on real ones (strict edge F1 .74 to .89 there).
namespace {

using Cloud = pcl::PointCloud<pcl::PointXYZ>;

Cloud::Ptr
cloudOf(const pcl::scene::Scene& scene)
{
  const auto cloud = pcl::make_shared<Cloud>(scene.width, scene.height);
  cloud->is_dense = false;
  for (std::size_t i = 0; i < cloud->size(); ++i) {
    const float* p = &scene.xyz[3 * i];
    (*cloud)[i] = pcl::PointXYZ(p[0], p[1], p[2]);
  }
  return cloud;
}

/** \brief F1 of the edge points within 5 mm of a crease; what is not clearly on or off
 * one (255) is left out. */
double
strictEdgeF1(const pcl::scene::Scene& scene)
{
  pcl::ShapeEdgeDetection<pcl::PointXYZ> detection;
  detection.setMode(pcl::ShapeEdgeDetection<pcl::PointXYZ>::PAPER);
  detection.setInputCloud(cloudOf(scene));
  pcl::PointIndices found;
  detection.segment(found);
  std::vector<bool> is_found(scene.edge.size(), false);
  for (const pcl::index_t i : found.indices)
    is_found[static_cast<std::size_t>(i)] = true;
  double hits = 0, misses = 0, false_alarms = 0;
  for (std::size_t i = 0; i < is_found.size(); ++i) {
    hits += scene.edge[i] == 1 && is_found[i] ? 1 : 0;
    misses += scene.edge[i] == 1 && !is_found[i] ? 1 : 0;
    false_alarms += scene.edge[i] == 0 && is_found[i] ? 1 : 0;
  }
  return 2 * hits / (2 * hits + misses + false_alarms);
}

TEST(GeneratedScenes, AreAsHardAsRealOnes)
{
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    pcl::scene::SceneOptions options;
    options.seed = seed;
    const double f1 = strictEdgeF1(pcl::scene::generateScene(options));
    EXPECT_GE(f1, 0.70) << "seed " << seed;
    EXPECT_LE(f1, 0.92) << "seed " << seed;
  }
}

} // namespace
