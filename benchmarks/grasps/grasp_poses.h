// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Poses of suction cups, and their check against the true scene.

#pragma once

#include "scene/grasp_scene.h"

#include <pcl/point_types.h>
#include <pcl/segmentation/suction_grasp_estimation.h>

namespace grasps {

using Cloud = pcl::PointCloud<pcl::PointXYZ>;

struct Pose {
  Eigen::Vector3f position, approach;
};

/** The measured points of a scene. */
Cloud::Ptr cloudOf(const pcl::scene::GraspScene& scene);

/** Whether the whole cup is on one face of the target, with nothing near above it. */
bool isOnOneFace(const pcl::scene::GraspScene& scene,
                 std::size_t target,
                 const Pose& pose,
                 double radius);

/** The centroid method: the point of the target nearest to the mean of its points,
 * along the normal there. Normals are those of the default mode. */
Pose centroidGrasp(const Cloud& cloud,
                   const pcl::Indices& target,
                   const pcl::ShapeField& of);

} // namespace grasps
