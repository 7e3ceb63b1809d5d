// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// This library's instances, RANSAC's primitives, region growing and clusters.

#include "instance_methods.h"

#include "../common/pcl_regions.h"

#include <pcl/search/kdtree.h>
#include <pcl/segmentation/extract_clusters.h>
#include <pcl/segmentation/shape_instance_segmentation.h>

#include <algorithm>
#include <cmath>

namespace instances {
namespace {

constexpr int least_cluster = 100;

void
setLabel(const pcl::Indices& indices, std::uint32_t label, Labels& labels)
{
  for (const pcl::index_t i : indices)
    labels[static_cast<std::size_t>(i)] = label;
}

Labels
labelsOf(const std::vector<pcl::Indices>& instances, std::size_t points)
{
  Labels labels(points, 0);
  std::uint32_t next = 0;
  for (const pcl::Indices& instance : instances)
    setLabel(instance, ++next, labels);
  return labels;
}

Labels
labelsOf(const std::vector<pcl::PointIndices>& instances, std::size_t points)
{
  std::vector<pcl::Indices> indices;
  for (const pcl::PointIndices& instance : instances)
    indices.push_back(instance.indices);
  return labelsOf(indices, points);
}

/** As many as there truly are. */
Labels
ransacPlanes(const InstanceCloud& cloud, double distance)
{
  constexpr std::size_t least_points = 3;
  return labelsOf(
      pcl_regions::planes(cloud.points, distance, cloud.count(), least_points),
      cloud.points->size());
}

Labels
ransacCylinders(const InstanceCloud& cloud, const pcl_regions::CylinderFit& fit)
{
  return labelsOf(pcl_regions::cylinders(cloud.points, fit, cloud.count()),
                  cloud.points->size());
}

/** Leave out what is, by the truth, mostly on something else. */
void
keepTrueOnes(const InstanceCloud& cloud, std::vector<pcl::PointIndices>& regions)
{
  const auto isElsewhere = [&](const pcl::PointIndices& region) {
    std::size_t counted = 0, right = 0;
    for (const pcl::index_t index : region.indices) {
      const auto i = static_cast<std::size_t>(index);
      counted += cloud.evaluated[i] ? 1 : 0;
      right += cloud.evaluated[i] && cloud.truth[i] != 0 ? 1 : 0;
    }
    return 2 * right < counted;
  };
  regions.erase(std::remove_if(regions.begin(), regions.end(), isElsewhere),
                regions.end());
}

Labels
trueRegions(const InstanceCloud& cloud, double degrees)
{
  std::vector<pcl::PointIndices> regions =
      pcl_regions::grownRegions(cloud.points, degrees);
  keepTrueOnes(cloud, regions);
  return labelsOf(regions, cloud.points->size());
}

Labels
clustersOffTable(const InstanceCloud& cloud, double gap)
{
  pcl::EuclideanClusterExtraction<pcl::PointXYZ> clustering;
  clustering.setInputCloud(cloud.points);
  clustering.setIndices(
      pcl::make_shared<pcl::Indices>(pcl_regions::withoutLargestPlane(cloud.points)));
  clustering.setSearchMethod(
      pcl::make_shared<pcl::search::KdTree<pcl::PointXYZ>>(false));
  clustering.setClusterTolerance(gap);
  clustering.setMinClusterSize(least_cluster);
  std::vector<pcl::PointIndices> clusters;
  clustering.extract(clusters);
  return labelsOf(clusters, cloud.points->size());
}

std::string
classOf(Task task)
{
  switch (task) {
  case Task::curved:
    return "curved";
  case Task::objects:
    return "object";
  case Task::faces:
    return "planar";
  }
  return "";
}

std::string
millimeters(double meters)
{
  return std::to_string(static_cast<int>(std::lround(1000.0 * meters))) + " mm";
}

/** The same with several distances. */
void
addWithDistances(const std::string& name,
                 Labels (*run)(const InstanceCloud&, double),
                 const std::vector<double>& distances,
                 std::vector<Method>& methods)
{
  for (const double distance : distances)
    methods.push_back(
        {name, millimeters(distance), [run, distance](const InstanceCloud& cloud) {
           return run(cloud, distance);
         }});
}

} // namespace

Method
ownMethod(unsigned threads)
{
  return {"this library", "", [threads](const InstanceCloud& cloud) {
            pcl::ShapeInstanceSegmentation<pcl::PointXYZ> segmentation;
            segmentation.setInputCloud(cloud.points);
            segmentation.setClass(classOf(cloud.task));
            segmentation.setNumberOfThreads(threads);
            std::vector<pcl::PointIndices> found;
            segmentation.segment(found);
            return labelsOf(found, cloud.points->size());
          }};
}

std::vector<Method>
peersFor(Task task)
{
  std::vector<Method> methods;
  if (task == Task::curved)
    for (const pcl_regions::CylinderFit& fit : pcl_regions::cylinderFits())
      methods.push_back(
          {"RANSAC cylinders, true count",
           pcl_regions::describe(fit),
           [fit](const InstanceCloud& cloud) { return ransacCylinders(cloud, fit); }});
  if (task == Task::faces)
    addWithDistances(
        "RANSAC planes, true count", ransacPlanes, {0.005, 0.010}, methods);
  if (task == Task::objects)
    addWithDistances("plane removed, pcl::EuclideanClusterExtraction",
                     clustersOffTable,
                     {0.005, 0.010},
                     methods);
  for (const int degrees : {2, 4})
    methods.push_back(
        {"pcl::RegionGrowing, its regions told by the truth",
         std::to_string(degrees) + "°",
         [=](const InstanceCloud& cloud) { return trueRegions(cloud, degrees); }});
  return methods;
}

} // namespace instances
