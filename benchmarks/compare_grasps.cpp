// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Suction grasps on generated scenes, beside those at the target's centroid.

#include "common/options.h"
#include "grasps/grasp_poses.h"

#include <nlohmann/json.hpp>

#include <chrono>
#include <cstdint>
#include <iostream>

// Suction grasps on generated scenes: large objects with smaller ones on them and
// others before them. Beside them the centroid method: the point of the target nearest
// to the mean of its points, along the normal there.
namespace {

namespace po = boost::program_options;
namespace scene = pcl::scene;
using namespace grasps;
using Json = nlohmann::ordered_json;

constexpr double disc_step = 0.004; // meters: less than half of the smallest cup

struct Arguments {
  std::uint64_t first_seed = 1;
  unsigned scenes = 60;
  double cup_radius = 0.01;
  std::string noise = "kinect";
};

bool
parseArguments(int argc, char** argv, Arguments& a)
{
  po::options_description options("compare_grasps [options]");
  options.add_options()(
      "first_seed", po::value(&a.first_seed), "of the scenes, two targets each (1)")(
      "scenes", po::value(&a.scenes), "how many (60)")(
      "cup_radius", po::value(&a.cup_radius), "meters (0.01)")(
      "noise", po::value(&a.noise), "kinect (default) or none")("help", "this");
  if (!parseCommandLine(argc, argv, options))
    return false;
  if (a.noise != "kinect" && a.noise != "none")
    throw std::invalid_argument("-noise " + a.noise + ": expected kinect, none");
  if (!(a.cup_radius >= 0.004 && a.cup_radius <= 0.1)) {
    throw std::invalid_argument("-cup_radius " + std::to_string(a.cup_radius) +
                                ": expected 0.004 to 0.1 meters");
  }
  return true;
}

/** What became of one target. */
struct Outcome {
  bool has_face = false; ///< of twice the cup
  bool is_curved = false;
  bool seals = false;
  bool is_on_one_face = false;
  bool is_centroid_on_one_face = false;
};

struct Counts {
  std::uint64_t targets = 0, sealed = 0, on_one_face = 0, centroid_on_one_face = 0;
  std::uint64_t sealed_on_one_face = 0;

  void
  add(const Outcome& of)
  {
    ++targets;
    sealed += of.seals ? 1 : 0;
    on_one_face += of.is_on_one_face ? 1 : 0;
    sealed_on_one_face += of.seals && of.is_on_one_face ? 1 : 0;
    centroid_on_one_face += of.is_centroid_on_one_face ? 1 : 0;
  }
};

Json
toJson(const Counts& counts)
{
  return {{"targets", counts.targets},
          {"with_a_sealing_grasp", counts.sealed},
          {"first_ranked_on_one_face", counts.on_one_face},
          {"centroid_on_one_face", counts.centroid_on_one_face}};
}

class Comparison {
public:
  explicit Comparison(const Arguments& arguments) : arguments_(arguments) {}

  void
  addScene(std::uint64_t seed)
  {
    scene::SceneOptions options;
    options.seed = seed;
    options.noise =
        arguments_.noise == "none" ? scene::Noise::None : scene::Noise::Kinect;
    const scene::GraspScene scene = scene::graspScene(options);
    const Cloud::Ptr cloud = cloudOf(scene);
    pcl::ShapeFieldEstimation<pcl::PointXYZ> field_estimation;
    field_estimation.setInputCloud(cloud);
    const auto field = pcl::make_shared<pcl::ShapeField>();
    field_estimation.compute(*field);
    for (const std::size_t target : scene.targets) {
      const auto points = pcl::make_shared<pcl::Indices>();
      for (std::size_t i = 0; i < cloud->size(); ++i)
        if (scene.object[i] == static_cast<int>(target))
          points->push_back(static_cast<pcl::index_t>(i));
      addTarget(scene, cloud, target, points, field);
    }
  }

  Json
  toJson() const
  {
    return {{"noise", arguments_.noise},
            {"cup_radius", arguments_.cup_radius},
            {"first_seed", arguments_.first_seed},
            {"scenes", arguments_.scenes},
            {"targets", all_},
            {"mean_seconds_without_back_projection",
             seconds_ / static_cast<double>(std::max<std::uint64_t>(all_, 1))},
            {"first_ranked_that_seal", sealing_},
            {"of_these_on_one_face", sealing_on_one_face_},
            {"with_a_face_of_twice_the_cup",
             {{"planar", ::toJson(planar_)}, {"curved", ::toJson(curved_)}}}};
  }

private:
  void
  addTarget(const scene::GraspScene& scene,
            const Cloud::Ptr& cloud,
            std::size_t target,
            const pcl::IndicesPtr& points,
            const pcl::ShapeField::ConstPtr& field)
  {
    Outcome outcome;
    outcome.has_face =
        scene::showsDisc(scene, target, 2.0 * arguments_.cup_radius, disc_step);
    outcome.is_curved = scene.world.solids[target - 1].shape != scene::Shape::Box;
    pcl::SuctionGraspEstimation<pcl::PointXYZ> estimation;
    estimation.setInputCloud(cloud);
    estimation.setIndices(points);
    estimation.setShapeField(field);
    estimation.setCupRadius(arguments_.cup_radius);
    std::vector<pcl::SuctionGrasp> grasps;
    const auto start = std::chrono::steady_clock::now();
    estimation.compute(grasps);
    seconds_ +=
        std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    if (!grasps.empty()) {
      outcome.seals = grasps[0].seals();
      outcome.is_on_one_face = isOnOneFace(scene,
                                           target,
                                           {grasps[0].position, grasps[0].approach},
                                           arguments_.cup_radius);
    }
    if (!points->empty()) {
      outcome.is_centroid_on_one_face = isOnOneFace(
          scene, target, centroidGrasp(*cloud, *points, *field), arguments_.cup_radius);
    }
    note(outcome);
  }

  void
  note(const Outcome& outcome)
  {
    ++all_;
    if (outcome.has_face)
      (outcome.is_curved ? curved_ : planar_).add(outcome);
    sealing_ += outcome.seals ? 1 : 0;
    sealing_on_one_face_ += outcome.seals && outcome.is_on_one_face ? 1 : 0;
  }

  Arguments arguments_;
  std::uint64_t all_ = 0, sealing_ = 0, sealing_on_one_face_ = 0;
  double seconds_ = 0.0;
  Counts planar_, curved_;
};

int
runComparison(int argc, char** argv)
{
  Arguments arguments;
  if (!parseArguments(argc, argv, arguments))
    return 0;
  Comparison comparison(arguments);
  for (unsigned s = 0; s < arguments.scenes; ++s)
    comparison.addScene(arguments.first_seed + s);
  std::cout << comparison.toJson().dump() << std::endl;
  return 0;
}

} // namespace

int
main(int argc, char** argv)
{
  return runProgram("compare_grasps", runComparison, argc, argv);
}
