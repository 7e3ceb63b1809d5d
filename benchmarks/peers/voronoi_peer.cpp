/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * Point Cloud Library (PCL) - www.pointclouds.org
 * Copyright (c) 2026, pcl_shape contributors
 *
 * All rights reserved
 */

#include "local_features.h"

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
          diagonalize_selfadjoint_covariance_matrix(covariance, values)) {
    return 0.0f; // no feature edge, as there
  }
  return static_cast<float>(values[1] / (values[0] + values[1] + values[2]));
}

Scores
voronoiScores(const Cloud& cloud, double offset_radius, double convolution_radius)
{
  std::vector<Kernel::Point_3> points;
  for (const pcl::PointXYZ& p : cloud) {
    points.emplace_back(p.x, p.y, p.z);
  }
  std::vector<Covariance> covariances;
  CGAL::compute_vcm(points, covariances, offset_radius, convolution_radius);
  Scores scores;
  for (const Covariance& covariance : covariances) {
    scores.push_back(ratioOf(covariance));
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
    peer.settings.push_back(
        {"offset " + millimetres(offset) + ", convolution " + millimetres(radius),
         [=](const LabelledCloud& cloud) {
           return voronoiScores(*cloud.points, offset, radius);
         }});
  }
  return peer;
}

} // namespace peers
