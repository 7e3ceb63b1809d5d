// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Trials of suction grasps on generated scenes.

#pragma once

#include "scene/grasp_scene.h"

#include <pcl/segmentation/suction_grasp_estimation.h>

#include <cstdint>
#include <vector>

/** What a test of grasps on generated scenes needs. */
namespace pcl::test {

/** \brief A target of a scene, and what was found on it. */
struct GraspTrial {
  bool shows_twice_the_cup = false;
  bool is_curved = false;
  std::vector<SuctionGrasp> grasps;
  bool is_on_one_face = false; ///< the first grasp
};

inline scene::Vec3
vecOf(const Eigen::Vector3f& v)
{
  return {v.x(), v.y(), v.z()};
}

/** \brief True if the whole cup is on one face of the target, with nothing near above
 * it. */
inline bool
isOnOneFace(const scene::GraspScene& scene,
            std::size_t target,
            const SuctionGrasp& grasp,
            double radius)
{
  const scene::Pose& camera = scene.world.camera.pose;
  return scene::isOnOneFace(scene.world,
                            target,
                            camera.toWorld(vecOf(grasp.position)),
                            camera.directionToWorld(vecOf(grasp.approach)),
                            radius,
                            2 * radius);
}

inline std::vector<GraspTrial>
graspTrials(std::uint64_t seed, scene::Noise noise, double radius)
{
  scene::SceneOptions options;
  options.seed = seed;
  options.noise = noise;
  const scene::GraspScene scene = scene::graspScene(options);
  const auto cloud = make_shared<PointCloud<PointXYZ>>();
  for (std::size_t i = 0; i < scene.object.size(); ++i)
    cloud->emplace_back(scene.xyz[3 * i], scene.xyz[3 * i + 1], scene.xyz[3 * i + 2]);
  ShapeFieldEstimation<PointXYZ> field_estimation;
  field_estimation.setInputCloud(cloud);
  const auto field = make_shared<ShapeField>();
  field_estimation.compute(*field);
  std::vector<GraspTrial> trials;
  for (const std::size_t target : scene.targets) {
    const auto points = make_shared<Indices>();
    for (std::size_t i = 0; i < cloud->size(); ++i)
      if (scene.object[i] == static_cast<int>(target))
        points->push_back(static_cast<index_t>(i));
    GraspTrial& trial = trials.emplace_back();
    trial.shows_twice_the_cup = scene::showsDisc(scene, target, 2 * radius, 0.004);
    trial.is_curved = scene.world.solids[target - 1].shape != scene::Shape::Box;
    SuctionGraspEstimation<PointXYZ> estimation;
    estimation.setInputCloud(cloud);
    estimation.setIndices(points);
    estimation.setShapeField(field);
    estimation.setCupRadius(radius);
    estimation.compute(trial.grasps);
    trial.is_on_one_face = !trial.grasps.empty() &&
                           isOnOneFace(scene, target, trial.grasps.front(), radius);
  }
  return trials;
}

} // namespace pcl::test
