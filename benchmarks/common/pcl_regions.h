// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// What PCL offers to find whole surfaces, as its users set it up.

#pragma once

#include <pcl/PointIndices.h>
#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

#include <cstddef>
#include <string>
#include <vector>

/** \brief What PCL offers to find whole surfaces, as its users set it up: one thread,
 * the faster, unsorted search. Lengths are in meters. */
namespace pcl_regions {

using Cloud = pcl::PointCloud<pcl::PointXYZ>;
using Normals = pcl::PointCloud<pcl::Normal>;

/** \brief pcl::NormalEstimationOMP over a radius. */
Normals::Ptr normalsOf(const Cloud::ConstPtr& cloud, double radius);

/** \brief pcl::RegionGrowing over 30 neighbors, regions of 100 points or more. */
std::vector<pcl::PointIndices> grownRegions(const Cloud::ConstPtr& cloud,
                                            double degrees);

/** \brief RANSAC planes, each of what the ones before have left, as many as given or
 * until one has fewer points than the least. */
std::vector<pcl::Indices> planes(const Cloud::ConstPtr& cloud,
                                 double distance,
                                 std::size_t most_planes,
                                 std::size_t least_points);

/** \brief How RANSAC judges a cylinder. */
struct CylinderFit {
  double distance;
  /** PCL adds it times an angle in radians to distances in meters: 0 leaves normals to
   * the choice of samples, 0.1 is of PCL's tutorial. */
  double normal_weight;
};

/** \brief RANSAC cylinders of what the largest plane has left. */
std::vector<pcl::Indices>
cylinders(const Cloud::ConstPtr& cloud, const CylinderFit& fit, std::size_t count);

/** \brief For reports: "10 mm, normals weigh 0.1". */
std::string describe(const CylinderFit& fit);

/** \brief The settings of cylinders() that peers choose from. */
std::vector<CylinderFit> cylinderFits();

/** \brief The points that are not of the largest plane. */
pcl::Indices withoutLargestPlane(const Cloud::ConstPtr& cloud);

} // namespace pcl_regions
