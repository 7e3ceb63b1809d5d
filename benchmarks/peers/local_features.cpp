// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Surface variation and principal curvatures over several radii.

#include "local_features.h"

#include <pcl/features/normal_3d.h>
#include <pcl/features/principal_curvatures.h>
#include <pcl/search/kdtree.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace peers {
namespace {

Scores
variationOf(const Cloud::ConstPtr& cloud, double radius)
{
  const Normals::ConstPtr normals = normalsOf(cloud, radius);
  Scores scores;
  for (const pcl::Normal& normal : *normals)
    scores.push_back(normal.curvature);
  return scores;
}

/** The same over a radius that grows with the square of the depth from 0.8 m on, as a
 * depth camera's noise does, to four times as much. */
Scores
variationByDepth(const Cloud::ConstPtr& cloud, double radius)
{
  constexpr double near = 0.8;
  pcl::search::KdTree<pcl::PointXYZ> tree(false);
  tree.setInputCloud(cloud);
  Scores scores;
  pcl::Indices neighbors;
  std::vector<float> squares;
  for (const pcl::PointXYZ& point : *cloud) {
    const double scale =
        std::clamp(double{point.z} * double{point.z} / (near * near), 1.0, 4.0);
    tree.radiusSearch(point, scale * radius, neighbors, squares);
    Eigen::Vector4f plane;
    float variation = std::numeric_limits<float>::quiet_NaN();
    pcl::computePointNormal(*cloud, neighbors, plane, variation);
    scores.push_back(variation);
  }
  return scores;
}

Scores
curvatureOf(const Cloud::ConstPtr& cloud, double radius)
{
  pcl::PrincipalCurvaturesEstimation<pcl::PointXYZ, pcl::Normal> estimation;
  estimation.setInputCloud(cloud);
  estimation.setInputNormals(normalsOf(cloud, radius));
  estimation.setSearchMethod(
      pcl::make_shared<pcl::search::KdTree<pcl::PointXYZ>>(false));
  estimation.setRadiusSearch(radius);
  pcl::PointCloud<pcl::PrincipalCurvatures> curvatures;
  estimation.compute(curvatures);
  Scores scores;
  for (const pcl::PrincipalCurvatures& at : curvatures)
    scores.push_back(at.pc1);
  return scores;
}

} // namespace

std::string
millimeters(double radius)
{
  const double tenths = std::round(1e4 * radius);
  const std::string text = std::to_string(static_cast<int>(tenths / 10.0));
  const int rest = static_cast<int>(tenths) % 10;
  return text + (rest != 0 ? "." + std::to_string(rest) : "") + " mm";
}

Peer
surfaceVariation(const std::vector<double>& radii)
{
  Peer peer{"surface variation (Bazazian), radius", {}, {}};
  for (const double radius : radii) {
    peer.settings.push_back({millimeters(radius), [=](const LabeledCloud& cloud) {
                               return variationOf(cloud.points, radius);
                             }});
    peer.settings.push_back(
        {millimeters(radius) + " × (z / 0.8 m)²", [=](const LabeledCloud& cloud) {
           return variationByDepth(cloud.points, radius);
         }});
  }
  return peer;
}

Peer
principalCurvature(const std::vector<double>& radii)
{
  Peer peer{"pcl::PrincipalCurvaturesEstimation", {}, {}};
  for (const double radius : radii) {
    peer.settings.push_back(
        {"normals and curvature " + millimeters(radius),
         [=](const LabeledCloud& cloud) { return curvatureOf(cloud.points, radius); }});
  }
  return peer;
}

} // namespace peers
