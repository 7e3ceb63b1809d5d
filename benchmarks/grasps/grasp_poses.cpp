// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// The grasp at the centroid of a target, and whether a cup is on one face.

#include "grasp_poses.h"

#include <limits>

namespace grasps {

namespace scene = pcl::scene;
using Eigen::Vector3f;

Cloud::Ptr
cloudOf(const scene::GraspScene& scene)
{
  auto cloud = pcl::make_shared<Cloud>();
  for (std::size_t i = 0; i < scene.object.size(); ++i)
    cloud->emplace_back(scene.xyz[3 * i], scene.xyz[3 * i + 1], scene.xyz[3 * i + 2]);
  return cloud;
}

bool
isOnOneFace(const scene::GraspScene& scene,
            std::size_t target,
            const Pose& pose,
            double radius)
{
  const auto vec = [](const Vector3f& v) { return scene::Vec3{v.x(), v.y(), v.z()}; };
  const scene::Pose& camera = scene.world.camera.pose;
  return scene::isOnOneFace(scene.world,
                            target,
                            camera.toWorld(vec(pose.position)),
                            camera.directionToWorld(vec(pose.approach)),
                            radius,
                            2.0 * radius);
}

Pose
centroidGrasp(const Cloud& cloud, const pcl::Indices& target, const pcl::ShapeField& of)
{
  Vector3f mean = Vector3f::Zero();
  for (const pcl::index_t i : target) {
    mean += cloud[static_cast<std::size_t>(i)].getVector3fMap() /
            static_cast<float>(target.size());
  }
  Pose pose{Vector3f::Zero(), Vector3f::Zero()};
  float least = std::numeric_limits<float>::infinity();
  for (const pcl::index_t i : target) {
    const auto at = static_cast<std::size_t>(i);
    const float squared = (cloud[at].getVector3fMap() - mean).squaredNorm();
    if (squared < least && of.normals[at].allFinite()) {
      least = squared;
      pose = {cloud[at].getVector3fMap(), -of.normals[at]};
    }
  }
  return pose;
}

} // namespace grasps
