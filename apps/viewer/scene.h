// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// What is drawn: points, views, camera, overlays.

#pragma once

#include "results/scene_files.h"
#include "viewer/camera.h"
#include "viewer/field_view.h"

#include <string>
#include <vector>

namespace pcl::app {

/** \brief A box around the points of an instance, and its name. */
struct InstanceBox {
  std::string name;
  Color color;
  Vector min; ///< corner, meters; both corners are the centroid without points
  Vector max;
};

/** \brief All that is drawn: the cloud once for each view, side by side, from one
 * camera; everything else in each of them. */
struct Scene {
  std::string title; ///< of the window
  pcl::PointCloud<pcl::PointXYZ>::Ptr points;
  std::vector<FieldView> views;
  pcl::PointCloud<pcl::Normal>::Ptr normals; ///< null without
  std::vector<Line> lines;
  std::vector<InstanceBox> instances;
  Grasps grasps;
  Camera camera;
  int width = 0; ///< of all views together, pixels
  int height = 0;
  int point_size = 1;          ///< pixels
  bool has_point_size = false; ///< whether the user has chosen it
  bool keys = false;           ///< show what the keys do
};

/** \brief The scene, with all places moved. */
Scene moved(Scene scene, const Eigen::Vector3f& offset);

/** \brief How many views stand side by side. */
int columnsOf(std::size_t views);

int rowsOf(std::size_t views);

/** \brief The boxes of the instances, by the cloud's field "instance" if it has one. */
std::vector<InstanceBox> boxesOf(const std::vector<Instance>& instances,
                                 const CloudFile& cloud);

/** \brief The size in pixels with which the points of a surface just touch in the
 * middle of the picture. \param[in] height of the picture, pixels */
int pointSize(const pcl::PointCloud<pcl::PointXYZ>& points,
              const Camera& camera,
              int height);

} // namespace pcl::app
