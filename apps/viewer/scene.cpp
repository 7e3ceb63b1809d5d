// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// The layout of views, the boxes of instances, the size of points.

#include "viewer/scene.h"

#include <pcl/common/point_tests.h>
#include <pcl/search/kdtree.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace pcl::app {
namespace {

/** A box around the points of each instance. */
std::map<std::uint32_t, Eigen::AlignedBox3f>
boxesOf(const CloudFile& cloud)
{
  std::map<std::uint32_t, Eigen::AlignedBox3f> boxes;
  if (!findField(cloud, "instance"))
    return boxes;
  const auto points = pointsOf(cloud);
  const std::vector<std::uint32_t> labels = labelsOf(cloud, "instance");
  for (std::size_t i = 0; i < labels.size(); ++i)
    if (pcl::isXYZFinite((*points)[i]))
      boxes[labels[i]].extend((*points)[i].getVector3fMap());
  return boxes;
}

Vector
toVector(const Eigen::Vector3f& vector)
{
  return {vector.x(), vector.y(), vector.z()};
}

void
move(Vector& place, const Eigen::Vector3f& offset)
{
  for (std::size_t axis = 0; axis < place.size(); ++axis)
    place[axis] += offset[static_cast<Eigen::Index>(axis)];
}

} // namespace

Scene
moved(Scene scene, const Eigen::Vector3f& offset)
{
  for (pcl::PointXYZ& point : *scene.points)
    point.getVector3fMap() += offset;
  scene.camera.position += offset;
  scene.camera.focus += offset;
  for (Line& line : scene.lines)
    for (Vector& point : line.points)
      move(point, offset);
  for (InstanceBox& instance : scene.instances) {
    move(instance.min, offset);
    move(instance.max, offset);
  }
  for (Grasp& grasp : scene.grasps.grasps)
    move(grasp.position, offset);
  return scene;
}

int
columnsOf(std::size_t views)
{
  constexpr int max_in_one_row = 3;
  const auto count = static_cast<int>(views);
  return count <= max_in_one_row ? count
                                 : static_cast<int>(std::ceil(std::sqrt(count)));
}

int
rowsOf(std::size_t views)
{
  const int columns = columnsOf(views);
  return (static_cast<int>(views) + columns - 1) / columns;
}

std::vector<InstanceBox>
boxesOf(const std::vector<Instance>& instances, const CloudFile& cloud)
{
  const auto boxes = boxesOf(cloud);
  std::vector<InstanceBox> result;
  for (const Instance& instance : instances) {
    const std::size_t position = instance.id - std::min(instance.id, 1u);
    InstanceBox box{std::to_string(instance.id) + ' ' + instance.name,
                    distinctColor(position),
                    instance.centroid,
                    instance.centroid};
    if (const auto found = boxes.find(instance.id); found != boxes.end()) {
      box.min = toVector(found->second.min());
      box.max = toVector(found->second.max());
    }
    result.push_back(box);
  }
  return result;
}

int
pointSize(const pcl::PointCloud<pcl::PointXYZ>& points,
          const Camera& camera,
          int height)
{
  constexpr std::size_t samples = 400;
  constexpr int largest = 20; // pixels
  const auto finite = pcl::make_shared<pcl::PointCloud<pcl::PointXYZ>>();
  for (const pcl::PointXYZ& point : points)
    if (pcl::isXYZFinite(point))
      finite->push_back(point);
  if (finite->size() < 2)
    return largest / 2;
  pcl::search::KdTree<pcl::PointXYZ> tree(false);
  tree.setInputCloud(finite);
  std::vector<float> sizes; // of a spacing, at distance 1
  pcl::Indices nearest;
  std::vector<float> squared;
  const std::size_t step = std::max<std::size_t>(1, finite->size() / samples);
  for (std::size_t i = 0; i < finite->size(); i += step) {
    tree.nearestKSearch((*finite)[i], 2, nearest, squared);
    const float distance = ((*finite)[i].getVector3fMap() - camera.position).norm();
    sizes.push_back(std::sqrt(std::max(squared[0], squared[1])) / distance);
  }
  const auto middle = sizes.begin() + static_cast<std::ptrdiff_t>(sizes.size() / 2);
  std::nth_element(sizes.begin(), middle, sizes.end());
  constexpr float radians_per_degree = 0.0174532925f;
  const float picture = 2.0f * std::tan(0.5f * camera.angle * radians_per_degree);
  const float pixels = 1.2f * *middle * static_cast<float>(height) / picture;
  return std::clamp(static_cast<int>(std::ceil(pixels)), 1, largest);
}

} // namespace pcl::app
