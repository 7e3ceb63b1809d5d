// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Where a cloud is seen from.

#pragma once

#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

#include <string>

namespace pcl::app {

/** \brief Where the scene is seen from. */
struct Camera {
  Eigen::Vector3f position; ///< meters
  Eigen::Vector3f focus;    ///< the point in the middle of the picture
  Eigen::Vector3f up;
  float angle; ///< of view from bottom to top, degrees
};

/** \brief The box around the finite points. */
Eigen::AlignedBox3f boxOf(const pcl::PointCloud<pcl::PointXYZ>& points);

/** \brief The sensor's view, if the points are in front of it, else from above the
 * cloud's corner with z up; the angle of view takes in all points.
 * \param[in] points at least one is finite
 * \param[in] aspect width of the picture over its height */
Camera defaultCamera(const pcl::PointCloud<pcl::PointXYZ>& points, float aspect);

/** \brief Makes points NaN that are ten times as far from the middle as 95 % of the
 * points: beside them the rest would shrink to a dot. \param[in,out] points at least
 * one is finite \return how many they are */
std::size_t hideStrays(pcl::PointCloud<pcl::PointXYZ>& points);

/** \brief The value of -camera: nine numbers, position, focus, up, and optionally the
 * angle of view. \throws UsageError */
Camera parseCamera(const std::string& text);

/** \brief As parseCamera() reads it. */
std::string toText(const Camera& camera);

} // namespace pcl::app
