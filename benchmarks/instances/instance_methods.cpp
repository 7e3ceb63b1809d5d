/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * Point Cloud Library (PCL) - www.pointclouds.org
 * Copyright (c) 2026, pcl_shape contributors
 *
 * All rights reserved
 */

#include "instance_methods.h"

#include <pcl/features/normal_3d_omp.h>
#include <pcl/search/kdtree.h>
#include <pcl/segmentation/extract_clusters.h>
#include <pcl/segmentation/region_growing.h>
#include <pcl/segmentation/sac_segmentation.h>
#include <pcl/segmentation/shape_instance_segmentation.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

namespace instances {
namespace {

constexpr double normal_radius = 0.015;
constexpr double table_distance = 0.010;
constexpr int least_cluster = 100;

using Normals = pcl::PointCloud<pcl::Normal>;
using Tree = pcl::search::KdTree<pcl::PointXYZ>;

void
setLabel(const pcl::Indices& indices, std::uint32_t label, Labels& labels)
{
  for (const pcl::index_t i : indices)
    labels[static_cast<std::size_t>(i)] = label;
}

Labels
labelsOf(const std::vector<pcl::PointIndices>& instances, std::size_t points)
{
  Labels labels(points, 0);
  std::uint32_t next = 0;
  for (const pcl::PointIndices& instance : instances)
    setLabel(instance.indices, ++next, labels);
  return labels;
}

Normals::Ptr
normalsOf(const Cloud::ConstPtr& cloud)
{
  pcl::NormalEstimationOMP<pcl::PointXYZ, pcl::Normal> estimation(1);
  estimation.setInputCloud(cloud);
  estimation.setSearchMethod(pcl::make_shared<Tree>(false));
  estimation.setRadiusSearch(normal_radius);
  const auto normals = pcl::make_shared<Normals>();
  estimation.compute(*normals);
  return normals;
}

pcl::Indices
allOf(const Cloud& cloud)
{
  pcl::Indices all(cloud.size());
  std::iota(all.begin(), all.end(), 0);
  return all;
}

/** Take the inliers of a model out of the indices that are left. */
pcl::Indices
takeInliers(pcl::SACSegmentation<pcl::PointXYZ>& segmentation, pcl::Indices& left)
{
  segmentation.setIndices(pcl::make_shared<pcl::Indices>(left));
  pcl::PointIndices inliers;
  pcl::ModelCoefficients coefficients;
  segmentation.segment(inliers, coefficients);
  std::sort(inliers.indices.begin(), inliers.indices.end());
  pcl::Indices others;
  std::set_difference(left.begin(),
                      left.end(),
                      inliers.indices.begin(),
                      inliers.indices.end(),
                      std::back_inserter(others));
  left = others;
  return inliers.indices;
}

void
setUpPlanes(pcl::SACSegmentation<pcl::PointXYZ>& segmentation,
            const Cloud::ConstPtr& cloud,
            double distance)
{
  constexpr int iterations = 1000;
  segmentation.setInputCloud(cloud);
  segmentation.setModelType(pcl::SACMODEL_PLANE);
  segmentation.setMethodType(pcl::SAC_RANSAC);
  segmentation.setMaxIterations(iterations);
  segmentation.setDistanceThreshold(distance);
}

pcl::Indices
withoutTable(const Cloud::ConstPtr& cloud)
{
  pcl::Indices left = allOf(*cloud);
  pcl::SACSegmentation<pcl::PointXYZ> table;
  setUpPlanes(table, cloud, table_distance);
  takeInliers(table, left);
  return left;
}

Labels
ransacPlanes(const InstanceCloud& cloud, double distance)
{
  pcl::SACSegmentation<pcl::PointXYZ> planes;
  setUpPlanes(planes, cloud.points, distance);
  pcl::Indices left = allOf(*cloud.points);
  Labels labels(cloud.points->size(), 0);
  const std::size_t count = cloud.count();
  for (std::uint32_t c = 1; c <= count && left.size() > 3; ++c)
    setLabel(takeInliers(planes, left), c, labels);
  return labels;
}

Labels
ransacCylinders(const InstanceCloud& cloud, double distance)
{
  constexpr int iterations = 1000;
  constexpr double normal_weight = 0.1, least_radius = 0.01, largest_radius = 0.15;
  pcl::Indices left = withoutTable(cloud.points);
  pcl::SACSegmentationFromNormals<pcl::PointXYZ, pcl::Normal> cylinders;
  cylinders.setInputCloud(cloud.points);
  cylinders.setInputNormals(normalsOf(cloud.points));
  cylinders.setModelType(pcl::SACMODEL_CYLINDER);
  cylinders.setMethodType(pcl::SAC_RANSAC);
  cylinders.setMaxIterations(iterations);
  cylinders.setNormalDistanceWeight(normal_weight);
  cylinders.setDistanceThreshold(distance);
  cylinders.setRadiusLimits(least_radius, largest_radius);
  Labels labels(cloud.points->size(), 0);
  const std::size_t count = cloud.count();
  for (std::uint32_t c = 1; c <= count && left.size() > 2; ++c)
    setLabel(takeInliers(cylinders, left), c, labels);
  return labels;
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
grownRegions(const InstanceCloud& cloud, double degrees)
{
  constexpr unsigned neighbors = 30;
  constexpr float no_limit = 1.0f; // of curvature: creases are left to the angle
  pcl::RegionGrowing<pcl::PointXYZ, pcl::Normal> growing;
  growing.setInputCloud(cloud.points);
  growing.setInputNormals(normalsOf(cloud.points));
  growing.setSearchMethod(pcl::make_shared<Tree>(false));
  growing.setNumberOfNeighbours(neighbors);
  growing.setSmoothnessThreshold(static_cast<float>(degrees * M_PI / 180.0));
  growing.setCurvatureThreshold(no_limit);
  growing.setMinClusterSize(least_cluster);
  std::vector<pcl::PointIndices> regions;
  growing.extract(regions);
  keepTrueOnes(cloud, regions);
  return labelsOf(regions, cloud.points->size());
}

Labels
clustersOffTable(const InstanceCloud& cloud, double gap)
{
  pcl::EuclideanClusterExtraction<pcl::PointXYZ> clustering;
  clustering.setInputCloud(cloud.points);
  clustering.setIndices(pcl::make_shared<pcl::Indices>(withoutTable(cloud.points)));
  clustering.setSearchMethod(pcl::make_shared<Tree>(false));
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
millimetres(double metres)
{
  return std::to_string(static_cast<int>(std::lround(1000.0 * metres))) + " mm";
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
        {name, millimetres(distance), [run, distance](const InstanceCloud& cloud) {
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
    addWithDistances(
        "RANSAC cylinders, true count", ransacCylinders, {0.005, 0.010}, methods);
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
         [=](const InstanceCloud& cloud) { return grownRegions(cloud, degrees); }});
  return methods;
}

} // namespace instances
