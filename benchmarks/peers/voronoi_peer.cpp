// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// CGAL's Voronoi covariance measure, for edges.

#include "local_features.h"

#include <pcl/filters/voxel_grid.h>
#include <pcl/search/kdtree.h>

#include <array>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/vcm_estimate_edges.h>

namespace peers {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Covariance = std::array<double, 6>;

/** The ratio that CGAL::vcm_is_on_feature_edge() compares with its threshold. */
float
ratioOf(const Covariance& covariance)
{
  std::array<double, 3> values{};
  if (!CGAL::Default_diagonalize_traits<double, 3>::
          diagonalize_selfadjoint_covariance_matrix(covariance, values))
    return 0.0f; // no feature edge, as there
  return static_cast<float>(values[1] / (values[0] + values[1] + values[2]));
}

/** A point for each cell. All points would take minutes. */
Cloud::Ptr
thinned(const Cloud::ConstPtr& cloud, double cell)
{
  pcl::VoxelGrid<pcl::PointXYZ> grid;
  const auto side = static_cast<float>(cell);
  grid.setInputCloud(cloud);
  grid.setLeafSize(side, side, side);
  const auto thin = pcl::make_shared<Cloud>();
  grid.filter(*thin);
  return thin;
}

/** Each point has the score of the nearest one of the thinned cloud. */
Scores
voronoiScores(const Cloud::ConstPtr& cloud,
              double offset_radius,
              double convolution_radius)
{
  const Cloud::Ptr thin = thinned(cloud, 0.5 * convolution_radius);
  std::vector<Kernel::Point_3> points;
  for (const pcl::PointXYZ& p : *thin)
    points.emplace_back(p.x, p.y, p.z);
  std::vector<Covariance> covariances;
  CGAL::compute_vcm(points, covariances, offset_radius, convolution_radius);
  pcl::search::KdTree<pcl::PointXYZ> tree;
  tree.setInputCloud(thin);
  Scores scores;
  pcl::Indices nearest;
  std::vector<float> squared_distances;
  for (const pcl::PointXYZ& p : *cloud) {
    tree.nearestKSearch(p, 1, nearest, squared_distances);
    scores.push_back(ratioOf(covariances[static_cast<std::size_t>(nearest[0])]));
  }
  return scores;
}

} // namespace

Peer
voronoiPeer(const std::vector<double>& radii)
{
  Peer peer{"CGAL::vcm_is_on_feature_edge", {}, {}};
  for (const double radius : radii) {
    const double offset = 2.0 * radius; // as in CGAL's example
    peer.settings.push_back({"offset " + millimeters(offset) + ", convolution " +
                                 millimeters(radius) + ", cells " +
                                 millimeters(0.5 * radius),
                             [=](const LabeledCloud& cloud) {
                               return voronoiScores(cloud.points, offset, radius);
                             }});
  }
  return peer;
}

} // namespace peers
