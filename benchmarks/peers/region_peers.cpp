// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Curved and planar points by region growing and by RANSAC.

#include "../common/pcl_regions.h"
#include "local_features.h"

#include <pcl/common/centroid.h>

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>

namespace peers {
namespace {

constexpr float is_member = 0.5f;

/** How far, in meters, the points of a region are from its plane. */
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

void
setScores(const pcl::Indices& indices, float score, Scores& scores)
{
  for (const pcl::index_t i : indices)
    scores[static_cast<std::size_t>(i)] = score;
}

/** A region's points are as curved as it is not flat; points of no region are curved.
 */
Scores
flatnessOfRegions(const Cloud::ConstPtr& cloud, double degrees)
{
  constexpr float very_curved = 1.0f;
  Scores scores(cloud->size(), very_curved);
  for (const pcl::PointIndices& region : pcl_regions::grownRegions(cloud, degrees))
    setScores(region.indices, flatnessOf(*cloud, region.indices), scores);
  return scores;
}

/** Planes, the largest first, until one has less than a hundredth of the points. */
Scores
awayFromPlanes(const Cloud::ConstPtr& cloud, double distance)
{
  constexpr std::size_t share = 100;
  Scores scores(cloud->size(), 1.0f);
  for (const pcl::Indices& plane :
       pcl_regions::planes(cloud, distance, cloud->size(), cloud->size() / share))
    setScores(plane, 0.0f, scores);
  return scores;
}

/** As many cylinders as the truth has curved parts, after the largest plane. */
Scores
onCylinders(const LabeledCloud& labeled, const pcl_regions::CylinderFit& fit)
{
  Scores scores(labeled.points->size(), 0.0f);
  for (const pcl::Indices& cylinder :
       pcl_regions::cylinders(labeled.points, fit, countCurvedParts(labeled)))
    setScores(cylinder, 1.0f, scores);
  return scores;
}

} // namespace

std::vector<Peer>
regionPeers()
{
  Peer growing{"pcl::RegionGrowing, flatness of regions", {}, {}};
  for (const int degrees : {2, 4}) {
    growing.settings.push_back({"30 neighbors, " + std::to_string(degrees) + "°",
                                [=](const LabeledCloud& cloud) {
                                  return flatnessOfRegions(cloud.points, degrees);
                                }});
  }
  Peer planes{"RANSAC planes, iterated", {}, is_member};
  for (const double distance : {0.005, 0.010}) {
    planes.settings.push_back({millimeters(distance), [=](const LabeledCloud& cloud) {
                                 return awayFromPlanes(cloud.points, distance);
                               }});
  }
  Peer cylinders{"RANSAC cylinders, true count", {}, is_member};
  for (const pcl_regions::CylinderFit& fit : pcl_regions::cylinderFits()) {
    cylinders.settings.push_back(
        {pcl_regions::describe(fit),
         [=](const LabeledCloud& cloud) { return onCylinders(cloud, fit); }});
  }
  return {growing, planes, cylinders};
}

} // namespace peers
