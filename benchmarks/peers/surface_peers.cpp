// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// What others offer to tell curved from planar points.

#include "local_features.h"

#include <pcl/features/rsd.h>
#include <pcl/search/kdtree.h>

namespace peers {
namespace {

/** 1 / the smaller principal radius: 0 where the surface is as good as planar. */
Scores
curvatureByRadii(const Cloud::ConstPtr& cloud, double radius)
{
  pcl::RSDEstimation<pcl::PointXYZ, pcl::Normal, pcl::PrincipalRadiiRSD> estimation;
  estimation.setInputCloud(cloud);
  estimation.setInputNormals(normalsOf(cloud, radius));
  estimation.setSearchMethod(
      pcl::make_shared<pcl::search::KdTree<pcl::PointXYZ>>(false));
  estimation.setRadiusSearch(radius);
  pcl::PointCloud<pcl::PrincipalRadiiRSD> found;
  estimation.compute(found);
  Scores scores;
  for (const pcl::PrincipalRadiiRSD& radii : found)
    scores.push_back(1.0f / radii.r_min);
  return scores;
}

Peer
radiiPeer(const std::string& name, const std::vector<double>& radii)
{
  Peer peer{name, {}, {}};
  for (const double radius : radii) {
    peer.settings.push_back(
        {"normals and RSD " + millimeters(radius), [=](const LabeledCloud& cloud) {
           return curvatureByRadii(cloud.points, radius);
         }});
  }
  return peer;
}

} // namespace

std::vector<Peer>
surfacePeers(const std::vector<double>& radii)
{
  constexpr float grsd_least_plane_radius = 0.1f; // of GRSDEstimation::getSimpleType()
  Peer simple_types = radiiPeer("pcl::RSDEstimation, GRSD's simple types", radii);
  simple_types.threshold = 1.0f / grsd_least_plane_radius;
  std::vector<Peer> peers{surfaceVariation(radii),
                          principalCurvature(radii),
                          simple_types,
                          radiiPeer("pcl::RSDEstimation, best threshold", radii)};
  for (const Peer& peer : regionPeers())
    peers.push_back(peer);
  return peers;
}

} // namespace peers
