// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// PURPOSE

#pragma once

#include <pcl/PCLPointCloud2.h>
#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace pcl::app {

/** \brief A PCD file in memory: all its fields, packed, and its viewpoint. */
struct CloudFile {
  std::string path; ///< for messages
  pcl::PCLPointCloud2 blob;
  std::array<float, 7> viewpoint{0, 0, 0, 1, 0, 0, 0}; ///< tx ty tz qw qx qy qz

  std::size_t
  size() const
  {
    return static_cast<std::size_t>(blob.width) * blob.height;
  }
};

/** \brief Bytes of one value of a pcl::PCLPointField type. */
std::size_t valueSize(std::uint8_t datatype);

/** \brief The field, or nullptr. */
const pcl::PCLPointField* findField(const CloudFile& cloud, const std::string& name);

/** \brief The points; is_dense says whether all are finite.
 * \throws InputError unless x, y and z are single float32 values and a point is finite
 */
pcl::PointCloud<pcl::PointXYZ>::Ptr pointsOf(const CloudFile& cloud);

std::size_t countFinite(const pcl::PointCloud<pcl::PointXYZ>& points);

/** \brief The normals in normal_x, normal_y and normal_z.
 * \throws InputError unless they are single float32 values */
pcl::PointCloud<pcl::Normal>::Ptr normalsOf(const CloudFile& cloud);

/** \brief The values of a single-valued float32 field. \throws InputError without it */
std::vector<float> floatsOf(const CloudFile& cloud, const std::string& field);

/** \brief The values of a single-valued field of any type. \throws InputError without
 * it */
std::vector<double> numbersOf(const CloudFile& cloud, const std::string& field);

/** \brief The same as labels.
 * \throws InputError without it, or if a value is not a whole number from 0 to 2^32 - 1
 */
std::vector<std::uint32_t> labelsOf(const CloudFile& cloud, const std::string& field);

/** \brief Append a field, or replace the one of that name, whatever its type. */
void
setField(CloudFile& cloud, const std::string& name, const std::vector<float>& values);

void setField(CloudFile& cloud,
              const std::string& name,
              const std::vector<std::uint32_t>& values);

/** \brief Set normal_x, normal_y, normal_z and curvature. */
void setNormals(CloudFile& cloud, const pcl::PointCloud<pcl::Normal>& normals);

} // namespace pcl::app
