// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Reads and generates clouds with true instances.

#include "instance_cloud.h"

#include "io/cloud_file.h"
#include "io/pcd.h"

#include <pcl/segmentation/extract_clusters.h>

#include <cmath>
#include <filesystem>
#include <set>

namespace instances {
namespace {

using pcl::scene::Scene;

std::uint32_t
truthOf(const Scene& scene, std::size_t pixel, Task task)
{
  constexpr std::uint32_t most_faces = 6, table = 1;
  const std::uint32_t instance = scene.instance[pixel];
  switch (task) {
  case Task::curved:
    return scene.surface[pixel] == pcl::scene::SurfaceCurved ? instance : 0;
  case Task::objects:
    return instance;
  case Task::faces:
    return instance == 0 ? table : most_faces * instance + scene.face[pixel] + table;
  }
  return 0;
}

bool
isEvaluated(std::uint32_t surface, Task task)
{
  switch (task) {
  case Task::curved:
    return surface == pcl::scene::SurfacePlanar || surface == pcl::scene::SurfaceCurved;
  case Task::objects:
    return surface != pcl::scene::SurfaceVoid;
  case Task::faces:
    return surface == pcl::scene::SurfacePlanar;
  }
  return false;
}

/** The curved points of a cloud in connected parts. */
std::vector<pcl::PointIndices>
partsOf(const Cloud::Ptr& points, const Labels& surface)
{
  constexpr double gap = 0.010;
  constexpr int least = 100;
  const auto curved = pcl::make_shared<pcl::Indices>();
  for (std::size_t i = 0; i < surface.size(); ++i)
    if (surface[i] == pcl::scene::SurfaceCurved)
      curved->push_back(static_cast<pcl::index_t>(i));
  std::vector<pcl::PointIndices> parts;
  pcl::EuclideanClusterExtraction<pcl::PointXYZ> clustering;
  clustering.setInputCloud(points);
  clustering.setIndices(curved);
  clustering.setClusterTolerance(gap);
  clustering.setMinClusterSize(least);
  clustering.extract(parts);
  return parts;
}

} // namespace

const char*
name(Task task)
{
  switch (task) {
  case Task::curved:
    return "curved";
  case Task::objects:
    return "objects";
  case Task::faces:
    return "faces";
  }
  return "";
}

std::size_t
InstanceCloud::count() const
{
  std::set<std::uint32_t> labels(truth.begin(), truth.end());
  labels.erase(0);
  return labels.size();
}

InstanceCloud
generatedCloud(const std::string& group,
               Task task,
               const pcl::scene::SceneOptions& options)
{
  const Scene scene = pcl::scene::generateScene(options);
  InstanceCloud cloud;
  cloud.group = group;
  cloud.name = std::to_string(options.objects) + " objects, seed " +
               std::to_string(options.seed);
  cloud.task = task;
  cloud.points = pcl::make_shared<Cloud>();
  for (std::size_t i = 0; i < scene.surface.size(); ++i) {
    const float* p = &scene.xyz[3 * i];
    if (!std::isfinite(p[2]))
      continue;
    cloud.points->push_back({p[0], p[1], p[2]});
    cloud.truth.push_back(truthOf(scene, i, task));
    cloud.evaluated.push_back(isEvaluated(scene.surface[i], task));
  }
  return cloud;
}

InstanceCloud
curvedParts(const std::string& group, const std::string& path)
{
  const pcl::app::CloudFile file = pcl::app::readCloud(path);
  const Labels surface = pcl::app::labelsOf(file, "surface");
  InstanceCloud cloud;
  cloud.group = group;
  cloud.name = std::filesystem::path(path).stem().string();
  cloud.points = pcl::app::pointsOf(file);
  cloud.truth.assign(surface.size(), 0);
  for (const std::uint32_t value : surface)
    cloud.evaluated.push_back(isEvaluated(value, cloud.task));
  std::uint32_t next = 0;
  for (const pcl::PointIndices& part : partsOf(cloud.points, surface)) {
    ++next;
    for (const pcl::index_t i : part.indices)
      cloud.truth[static_cast<std::size_t>(i)] = next;
  }
  return cloud;
}

} // namespace instances
