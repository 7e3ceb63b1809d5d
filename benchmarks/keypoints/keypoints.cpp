// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Keypoints at creases, at equal distances, and by ISS.

#include "keypoints.h"

#include "../common/measure.h"

#include <pcl/features/neighborhood_sweep.h>
#include <pcl/filters/uniform_sampling.h>
#include <pcl/keypoints/iss_3d.h>
#include <pcl/segmentation/shape_edge_detection.h>

#include <algorithm>
#include <cmath>

namespace {

Cloud::Ptr
thinned(const Cloud::ConstPtr& cloud, double distance)
{
  const auto result = pcl::make_shared<Cloud>();
  pcl::UniformSampling<pcl::PointXYZ> sampling;
  sampling.setInputCloud(cloud);
  sampling.setRadiusSearch(distance);
  sampling.filter(*result);
  return result;
}

} // namespace

float
spacingOf(const Cloud& cloud)
{
  const pcl::NeighborhoodSweep sweep(
      {&cloud[0].x, sizeof(cloud[0]) / sizeof(float), cloud.size()});
  std::vector<float> distances(cloud.size());
  sweep.computeDistanceToNearest(2, distances.data()); // the first is the point itself
  return static_cast<float>(median({distances.begin(), distances.end()}));
}

Cloud::Ptr
creaseKeypoints(const Cloud::ConstPtr& cloud, unsigned threads)
{
  pcl::ShapeEdgeDetection<pcl::PointXYZ> detection;
  detection.setNumberOfThreads(threads);
  detection.setInputCloud(cloud);
  pcl::Edges edges;
  detection.detect(edges);
  const auto points = pcl::make_shared<Cloud>();
  std::vector<double> spacings;
  for (const pcl::CreasePoint& crease : edges.creases) {
    const auto& [x, y, z] = crease.position;
    points->emplace_back(x, y, z);
    spacings.push_back(crease.spacing);
  }
  return points->empty() ? points : thinned(points, 4.0 * median(spacings));
}

Cloud::Ptr
uniformKeypoints(const Cloud::ConstPtr& cloud, std::size_t count)
{
  // On surfaces the number of points falls with the square of their distance.
  constexpr int rounds = 6;
  double distance = 10.0 * spacingOf(*cloud);
  Cloud::Ptr points;
  for (int round = 0; round < rounds; ++round) {
    points = thinned(cloud, distance);
    distance *= std::sqrt(static_cast<double>(points->size()) /
                          static_cast<double>(std::max<std::size_t>(count, 1)));
  }
  return points;
}

Cloud::Ptr
issKeypoints(const Cloud::ConstPtr& cloud, float spacing, unsigned threads)
{
  pcl::ISSKeypoint3D<pcl::PointXYZ, pcl::PointXYZ> detection;
  detection.setInputCloud(cloud);
  detection.setSalientRadius(6.0 * spacing);
  detection.setNonMaxRadius(4.0 * spacing);
  detection.setNumberOfThreads(threads);
  const auto points = pcl::make_shared<Cloud>();
  detection.compute(*points);
  return points;
}
