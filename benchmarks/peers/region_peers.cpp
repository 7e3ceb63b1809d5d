/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * Point Cloud Library (PCL) - www.pointclouds.org
 * Copyright (c) 2026, pcl_shape contributors
 *
 * All rights reserved
 */

#include "local_features.h"

#include <pcl/common/centroid.h>
#include <pcl/search/kdtree.h>
#include <pcl/segmentation/region_growing.h>
#include <pcl/segmentation/sac_segmentation.h>

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace peers {
namespace {

constexpr double normal_radius = 0.015;
constexpr double table_distance = 0.010;
constexpr float is_member = 0.5f;

/** How far, in metres, the points of a region are from its plane. */
float
flatnessOf(const Cloud& cloud, const pcl::Indices& region)
{
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
  Eigen::Vector4d centroid = Eigen::Vector4d::Zero();
  pcl::computeMeanAndCovarianceMatrix(cloud, region, covariance, centroid);
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(covariance,
                                                              Eigen::EigenvaluesOnly);
  return static_cast<float>(std::sqrt(std::max(0.0, solver.eigenvalues()[0])));
}

/** A region's points are as curved as it is not flat; points of no region are curved.
 */
Scores
flatnessOfRegions(const Cloud::ConstPtr& cloud, double degrees)
{
  constexpr unsigned neighbors = 30;
  constexpr int least_region = 100;
  constexpr float no_limit = 1.0f; // of curvature: creases are left to the angle
  constexpr float very_curved = 1.0f;
  pcl::RegionGrowing<pcl::PointXYZ, pcl::Normal> growing;
  growing.setInputCloud(cloud);
  growing.setInputNormals(normalsOf(cloud, normal_radius));
  growing.setSearchMethod(pcl::make_shared<pcl::search::KdTree<pcl::PointXYZ>>(false));
  growing.setNumberOfNeighbours(neighbors);
  growing.setSmoothnessThreshold(static_cast<float>(degrees * M_PI / 180.0));
  growing.setCurvatureThreshold(no_limit);
  growing.setMinClusterSize(least_region);
  std::vector<pcl::PointIndices> regions;
  growing.extract(regions);
  Scores scores(cloud->size(), very_curved);
  for (const pcl::PointIndices& region : regions) {
    const float flatness = flatnessOf(*cloud, region.indices);
    for (const pcl::index_t i : region.indices) {
      scores[static_cast<std::size_t>(i)] = flatness;
    }
  }
  return scores;
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

pcl::Indices
allOf(const Cloud& cloud)
{
  pcl::Indices all(cloud.size());
  std::iota(all.begin(), all.end(), 0);
  return all;
}

void
setUpPlanes(pcl::SACSegmentation<pcl::PointXYZ>& segmentation,
            const Cloud::ConstPtr& cloud,
            double distance)
{
  constexpr int iterations = 500;
  segmentation.setInputCloud(cloud);
  segmentation.setModelType(pcl::SACMODEL_PLANE);
  segmentation.setMethodType(pcl::SAC_RANSAC);
  segmentation.setMaxIterations(iterations);
  segmentation.setDistanceThreshold(distance);
}

/** Planes, the largest first, until one has less than a hundredth of the points. */
Scores
awayFromPlanes(const Cloud::ConstPtr& cloud, double distance)
{
  constexpr std::size_t share = 100;
  pcl::SACSegmentation<pcl::PointXYZ> segmentation;
  setUpPlanes(segmentation, cloud, distance);
  Scores scores(cloud->size(), 1.0f);
  pcl::Indices left = allOf(*cloud);
  while (left.size() > cloud->size() / share) {
    const pcl::Indices plane = takeInliers(segmentation, left);
    if (plane.size() < cloud->size() / share) {
      break;
    }
    for (const pcl::index_t i : plane) {
      scores[static_cast<std::size_t>(i)] = 0.0f;
    }
  }
  return scores;
}

/** As many cylinders as the truth has curved parts, after the largest plane. */
Scores
onCylinders(const LabelledCloud& labelled, double distance)
{
  constexpr int iterations = 1000;
  constexpr double normal_weight = 0.1, least_radius = 0.01, largest_radius = 0.15;
  const Cloud::ConstPtr cloud = labelled.points;
  pcl::Indices left = allOf(*cloud);
  pcl::SACSegmentation<pcl::PointXYZ> table;
  setUpPlanes(table, cloud, table_distance);
  takeInliers(table, left);
  pcl::SACSegmentationFromNormals<pcl::PointXYZ, pcl::Normal> cylinders;
  cylinders.setInputCloud(cloud);
  cylinders.setInputNormals(normalsOf(cloud, normal_radius));
  cylinders.setModelType(pcl::SACMODEL_CYLINDER);
  cylinders.setMethodType(pcl::SAC_RANSAC);
  cylinders.setMaxIterations(iterations);
  cylinders.setNormalDistanceWeight(normal_weight);
  cylinders.setDistanceThreshold(distance);
  cylinders.setRadiusLimits(least_radius, largest_radius);
  Scores scores(cloud->size(), 0.0f);
  const std::size_t count = countCurvedParts(labelled);
  for (std::size_t c = 0; c < count && !left.empty(); ++c) {
    for (const pcl::index_t i : takeInliers(cylinders, left)) {
      scores[static_cast<std::size_t>(i)] = 1.0f;
    }
  }
  return scores;
}

} // namespace

std::vector<Peer>
regionPeers()
{
  Peer growing{"pcl::RegionGrowing, flatness of regions", {}, {}};
  for (const int degrees : {2, 4}) {
    growing.settings.push_back({"30 neighbours, " + std::to_string(degrees) + "°",
                                [=](const LabelledCloud& cloud) {
                                  return flatnessOfRegions(cloud.points, degrees);
                                }});
  }
  Peer planes{"RANSAC planes, iterated", {}, is_member};
  Peer cylinders{"RANSAC cylinders, true count", {}, is_member};
  for (const double distance : {0.005, 0.010}) {
    planes.settings.push_back({millimetres(distance), [=](const LabelledCloud& cloud) {
                                 return awayFromPlanes(cloud.points, distance);
                               }});
    cylinders.settings.push_back(
        {millimetres(distance),
         [=](const LabelledCloud& cloud) { return onCylinders(cloud, distance); }});
  }
  return {growing, planes, cylinders};
}

} // namespace peers
