// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// PCL's region growing, and its planes and cylinders by RANSAC.

#include "pcl_regions.h"

#include <pcl/features/normal_3d_omp.h>
#include <pcl/search/kdtree.h>
#include <pcl/segmentation/region_growing.h>
#include <pcl/segmentation/sac_segmentation.h>

#include <algorithm>
#include <iterator>
#include <numeric>
#include <sstream>

namespace pcl_regions {
namespace {

using Tree = pcl::search::KdTree<pcl::PointXYZ>;

constexpr double normal_radius = 0.015;
constexpr int ransac_iterations = 1000;

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
setUp(pcl::SACSegmentation<pcl::PointXYZ>& segmentation,
      const Cloud::ConstPtr& cloud,
      pcl::SacModel model,
      double distance)
{
  segmentation.setInputCloud(cloud);
  segmentation.setModelType(model);
  segmentation.setMethodType(pcl::SAC_RANSAC);
  segmentation.setMaxIterations(ransac_iterations);
  segmentation.setDistanceThreshold(distance);
}

} // namespace

Normals::Ptr
normalsOf(const Cloud::ConstPtr& cloud, double radius)
{
  pcl::NormalEstimationOMP<pcl::PointXYZ, pcl::Normal> estimation(1);
  estimation.setInputCloud(cloud);
  estimation.setSearchMethod(pcl::make_shared<Tree>(false));
  estimation.setRadiusSearch(radius);
  const auto normals = pcl::make_shared<Normals>();
  estimation.compute(*normals);
  return normals;
}

std::vector<pcl::PointIndices>
grownRegions(const Cloud::ConstPtr& cloud, double degrees)
{
  constexpr unsigned neighbors = 30;
  constexpr int least_region = 100;
  constexpr float no_limit = 1.0f; // of curvature: creases are left to the angle
  pcl::RegionGrowing<pcl::PointXYZ, pcl::Normal> growing;
  growing.setInputCloud(cloud);
  growing.setInputNormals(normalsOf(cloud, normal_radius));
  growing.setSearchMethod(pcl::make_shared<Tree>(false));
  growing.setNumberOfNeighbours(neighbors);
  growing.setSmoothnessThreshold(static_cast<float>(degrees * M_PI / 180.0));
  growing.setCurvatureThreshold(no_limit);
  growing.setMinClusterSize(least_region);
  std::vector<pcl::PointIndices> regions;
  growing.extract(regions);
  return regions;
}

std::vector<pcl::Indices>
planes(const Cloud::ConstPtr& cloud,
       double distance,
       std::size_t most_planes,
       std::size_t least_points)
{
  pcl::SACSegmentation<pcl::PointXYZ> segmentation;
  setUp(segmentation, cloud, pcl::SACMODEL_PLANE, distance);
  std::vector<pcl::Indices> found;
  pcl::Indices left = allOf(*cloud);
  while (found.size() < most_planes && left.size() > least_points) {
    const pcl::Indices plane = takeInliers(segmentation, left);
    if (plane.size() < least_points)
      break;
    found.push_back(plane);
  }
  return found;
}

pcl::Indices
withoutLargestPlane(const Cloud::ConstPtr& cloud)
{
  constexpr double distance = 0.010;
  pcl::SACSegmentation<pcl::PointXYZ> segmentation;
  setUp(segmentation, cloud, pcl::SACMODEL_PLANE, distance);
  pcl::Indices left = allOf(*cloud);
  takeInliers(segmentation, left);
  return left;
}

std::vector<pcl::Indices>
cylinders(const Cloud::ConstPtr& cloud, const CylinderFit& fit, std::size_t count)
{
  constexpr double least_radius = 0.01, largest_radius = 0.15;
  pcl::Indices left = withoutLargestPlane(cloud);
  pcl::SACSegmentationFromNormals<pcl::PointXYZ, pcl::Normal> segmentation;
  setUp(segmentation, cloud, pcl::SACMODEL_CYLINDER, fit.distance);
  segmentation.setInputNormals(normalsOf(cloud, normal_radius));
  segmentation.setNormalDistanceWeight(fit.normal_weight);
  segmentation.setRadiusLimits(least_radius, largest_radius);
  std::vector<pcl::Indices> found;
  while (found.size() < count && left.size() > 2) {
    found.push_back(takeInliers(segmentation, left));
    if (found.back().empty())
      break;
  }
  return found;
}

std::string
describe(const CylinderFit& fit)
{
  std::ostringstream text;
  text << 1000.0 * fit.distance << " mm";
  if (fit.normal_weight > 0.0)
    text << ", normals weigh " << fit.normal_weight;
  return text.str();
}

std::vector<CylinderFit>
cylinderFits()
{
  return {{0.005, 0.0}, {0.010, 0.0}, {0.010, 0.1}};
}

} // namespace pcl_regions
