/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * Point Cloud Library (PCL) - www.pointclouds.org
 * Copyright (c) 2026, pcl_shape contributors
 *
 * All rights reserved
 */

#pragma once

#include <pcl/segmentation/adaptive_detection.h>

#include <Eigen/Core>

#include <vector>

namespace pcl::segmentation {

/** \brief A place on a crease that stands for the crease points around it. */
struct CreaseNode {
  Eigen::Vector3f position;
  Eigen::Vector3f direction; ///< unit, of either sign
  float angle = 0.0f;        ///< median of the points it stands for, radians
  float spacing = 0.0f;      ///< metres
  float before = 0.0f;       ///< how far its points reach along -direction, metres
  float beyond = 0.0f;       ///< and along direction
};

/** \brief Thin crease points to nodes about one spacing apart along each crease.
 *
 * Each point moves across its crease to the middle of the points around it that have
 * its direction; then points are chosen, those in the thick of it first, that keep
 * their distance from each other. The result does not depend on the order of points. */
std::vector<CreaseNode> creaseNodes(std::vector<CreasePoint> points);

} // namespace pcl::segmentation
