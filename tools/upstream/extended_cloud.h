// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// For tools in PCL's own tree: a PCD file to which they add fields.

#pragma once

#include <pcl/common/io.h>
#include <pcl/conversions.h>
#include <pcl/io/pcd_io.h>
#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

#include <string>
#include <utility>

/** \brief All fields of a PCD file, its points, and fields that are added.
 *
 * Functions that fail print why.
 */
class ExtendedCloud {
public:
  using Points = pcl::PointCloud<pcl::PointXYZ>;

  bool
  load(const std::string& name)
  {
    if (pcl::io::loadPCDFile(name, fields_, origin_, orientation_) < 0)
      return false;
    const auto points = pcl::make_shared<Points>();
    pcl::fromPCLPointCloud2(fields_, *points);
    points->sensor_origin_ = origin_;
    points_ = points;
    return true;
  }

  const Points::ConstPtr&
  points() const
  {
    return points_;
  }

  /** \brief Add the fields of a cloud with as many points. */
  template <typename PointT>
  bool
  add(const pcl::PointCloud<PointT>& cloud)
  {
    pcl::PCLPointCloud2 added, both;
    pcl::toPCLPointCloud2(cloud, added);
    if (!pcl::concatenateFields(fields_, added, both))
      return false;
    fields_ = std::move(both);
    return true;
  }

  bool
  save(const std::string& name) const
  {
    pcl::PCDWriter writer;
    return writer.writeBinaryCompressed(name, fields_, origin_, orientation_) == 0;
  }

private:
  pcl::PCLPointCloud2 fields_;
  Points::ConstPtr points_;
  Eigen::Vector4f origin_;
  Eigen::Quaternionf orientation_;
};
