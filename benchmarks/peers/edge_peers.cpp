// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// What others offer for edges.

#include "local_features.h"

#include <pcl/common/io.h>
#include <pcl/features/don.h>
#include <pcl/features/normal_3d_omp.h>
#include <pcl/search/kdtree.h>

#include <algorithm>

namespace peers {
namespace {

/** Surface variation of the k nearest points. */
Scores
variationOfNearest(const LabeledCloud& cloud, int k)
{
  pcl::NormalEstimationOMP<pcl::PointXYZ, pcl::Normal> estimation(1);
  estimation.setInputCloud(cloud.points);
  estimation.setSearchMethod(
      pcl::make_shared<pcl::search::KdTree<pcl::PointXYZ>>(false));
  estimation.setKSearch(k);
  Normals normals;
  estimation.compute(normals);
  Scores scores;
  for (const pcl::Normal& normal : normals)
    scores.push_back(normal.curvature);
  return scores;
}

/** The program of Bazazian et al. as it is: surface variation of the 10 nearest points,
 * from its least (0) to its largest (1) value. */
Scores
variationAsPublished(const LabeledCloud& cloud)
{
  Scores scores = variationOfNearest(cloud, 10);
  const auto [least, most] = std::minmax_element(scores.begin(), scores.end());
  const float from = *least, range = *most - *least;
  for (float& score : scores)
    score = (score - from) / range;
  return scores;
}

Peer
nearestPeer(const std::vector<int>& counts)
{
  Peer peer{"surface variation, k nearest", {}, {}};
  for (const int k : counts) {
    peer.settings.push_back({std::to_string(k), [=](const LabeledCloud& cloud) {
                               return variationOfNearest(cloud, k);
                             }});
  }
  return peer;
}

Scores
differenceOfNormals(const Cloud::ConstPtr& cloud, double small, double large)
{
  pcl::DifferenceOfNormalsEstimation<pcl::PointXYZ, pcl::Normal, pcl::PointNormal>
      estimation;
  estimation.setInputCloud(cloud);
  estimation.setNormalScaleSmall(normalsOf(cloud, small));
  estimation.setNormalScaleLarge(normalsOf(cloud, large));
  pcl::PointCloud<pcl::PointNormal> differences;
  pcl::copyPointCloud(*cloud, differences); // as PCL's tutorial does
  estimation.initCompute();
  estimation.computeFeature(differences);
  Scores scores;
  for (const pcl::PointNormal& difference : differences)
    scores.push_back(difference.curvature); // its length
  return scores;
}

} // namespace

std::vector<Peer>
edgePeers(const std::vector<double>& radii, const std::vector<int>& neighbors)
{
  constexpr float six_of_256_levels = 6.0f / 256.0f;
  Peer normals{"pcl::DifferenceOfNormalsEstimation", {}, {}};
  // Below and above: with noise the normals over a third of a radius are of no use.
  for (const double scale : {1.0 / 3.0, 1.0}) {
    for (const double radius : radii) {
      const double small = scale * radius, large = 3.0 * small;
      normals.settings.push_back({millimeters(small) + " and " + millimeters(large),
                                  [=](const LabeledCloud& cloud) {
                                    return differenceOfNormals(
                                        cloud.points, small, large);
                                  }});
    }
  }
  return {{"surface variation (Bazazian), its defaults",
           {{"10 nearest points", variationAsPublished}},
           six_of_256_levels},
          nearestPeer(neighbors),
          surfaceVariation(radii),
          normals,
          principalCurvature(radii)};
}

} // namespace peers
