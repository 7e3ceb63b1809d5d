// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Two views brought together by points of creases, and by other keypoints.

#include "common/measure.h"
#include "common/options.h"
#include "keypoints/align.h"
#include "keypoints/keypoints.h"
#include "scene/scene.h"

#include <pcl/console/print.h>

#include <Eigen/Geometry>
#include <nlohmann/json.hpp>

#include <cmath>
#include <iostream>
#include <map>

// Align two views of one generated scene by keypoints: points of creases, as many and
// ten times as many at equal distances, and Intrinsic Shape Signatures.
namespace {

namespace po = boost::program_options;

struct Pose {
  Cloud::Ptr cloud;
  Eigen::Isometry3d camera; ///< to the frame of the scene
};

Pose
viewOf(std::uint64_t seed, double turn)
{
  pcl::scene::SceneOptions options;
  options.seed = seed;
  options.turn = turn;
  const pcl::scene::Scene scene = pcl::scene::generateScene(options);
  Pose view{pcl::make_shared<Cloud>(), Eigen::Isometry3d::Identity()};
  for (std::size_t i = 0; i < scene.surface.size(); ++i) {
    const float* p = &scene.xyz[3 * i];
    if (std::isfinite(p[2]))
      view.cloud->emplace_back(p[0], p[1], p[2]);
  }
  for (std::size_t axis = 0; axis < 3; ++axis) {
    view.camera.linear().col(static_cast<Eigen::Index>(axis)) =
        Eigen::Map<const Eigen::Vector3d>(scene.camera_axes[axis].data());
  }
  view.camera.translation() =
      Eigen::Map<const Eigen::Vector3d>(scene.camera_origin.data());
  return view;
}

struct PoseError {
  double degrees = 0.0;
  double millimeters = 0.0; ///< in the middle of the first view
};

PoseError
errorOf(const Pose& from, const Pose& to, const Eigen::Matrix4f& found)
{
  const Eigen::Isometry3d truth = to.camera.inverse() * from.camera;
  Eigen::Isometry3d estimate;
  estimate.matrix() = found.cast<double>();
  Eigen::Vector3d middle = Eigen::Vector3d::Zero();
  for (const pcl::PointXYZ& point : *from.cloud)
    middle += point.getVector3fMap().cast<double>();
  middle /= static_cast<double>(from.cloud->size());
  const Eigen::AngleAxisd rotation(truth.linear().transpose() * estimate.linear());
  return {rotation.angle() * 180.0 / M_PI,
          1e3 * (truth * middle - estimate * middle).norm()};
}

/** What one kind of keypoints did over all pairs of views. */
struct Score {
  std::vector<double> keypoints, keypoints_ms, align_ms, degrees, millimeters;
  std::size_t aligned = 0;
};

constexpr double most_degrees = 5.0, most_millimeters = 20.0;

void
score(const Pose& from,
      const Pose& to,
      float spacing,
      const KeypointsOf& keypointsOf,
      Score& score)
{
  View views[2] = {{from.cloud, nullptr}, {to.cloud, nullptr}};
  score.keypoints_ms.push_back(millisecondsOf([&] {
    for (View& view : views)
      view.keypoints = keypointsOf(view.cloud);
  }));
  score.keypoints.push_back(static_cast<double>(views[0].keypoints->size()));
  Alignment alignment;
  score.align_ms.push_back(
      millisecondsOf([&] { alignment = align(views[0], views[1], spacing); }));
  const PoseError error = errorOf(from, to, alignment.pose);
  score.degrees.push_back(error.degrees);
  score.millimeters.push_back(error.millimeters);
  if (error.degrees <= most_degrees && error.millimeters <= most_millimeters)
    ++score.aligned;
}

nlohmann::ordered_json
toJson(const std::string& name, double turn, const Score& score)
{
  const auto pairs = score.degrees.size();
  return {{"keypoints", name},
          {"turn", turn},
          {"pairs", pairs},
          {"aligned", static_cast<double>(score.aligned) / static_cast<double>(pairs)},
          {"degrees", median(score.degrees)},
          {"millimeters", median(score.millimeters)},
          {"count", median(score.keypoints)},
          {"keypoints_ms", median(score.keypoints_ms)},
          {"align_ms", median(score.align_ms)}};
}

int
run(int argc, char** argv)
{
  Options options;
  std::uint64_t first = 501;
  unsigned pairs = 10;
  std::vector<double> turns{20.0, 40.0};
  auto description = commonOptions("compare_keypoints", options);
  description.add_options()("seed", po::value(&first), "of the first scene (501)")(
      "pairs", po::value(&pairs), "of views for each angle (10)")(
      "turn", po::value(&turns)->multitoken(), "degrees between the views (20 40)");
  parse(argc, argv, description, options);
  // ISS has a message for each point that it skips.
  pcl::console::setVerbosityLevel(pcl::console::L_ERROR);

  auto rows = nlohmann::ordered_json::array();
  for (const double turn : turns) {
    std::map<std::string, Score> scores;
    for (unsigned p = 0; p < pairs; ++p) {
      const Pose from = viewOf(first + p, 0.0), to = viewOf(first + p, turn);
      const float spacing = spacingOf(*from.cloud);
      std::size_t count = 0;
      const auto creases = [&](const Cloud::ConstPtr& cloud) {
        auto keypoints = creaseKeypoints(cloud, options.threads);
        count = keypoints->size();
        return keypoints;
      };
      score(from, to, spacing, creases, scores["creases"]);
      const auto uniform = [&](const Cloud::ConstPtr& cloud) {
        return uniformKeypoints(cloud, count);
      };
      score(from, to, spacing, uniform, scores["uniform"]);
      const auto many = [&](const Cloud::ConstPtr& cloud) {
        return uniformKeypoints(cloud, 10 * count);
      };
      score(from, to, spacing, many, scores["uniform, ten times as many"]);
      const auto iss = [&](const Cloud::ConstPtr& cloud) {
        return issKeypoints(cloud, spacing, options.threads);
      };
      score(from, to, spacing, iss, scores["ISS"]);
    }
    for (const auto& [name, result] : scores) {
      rows.push_back(toJson(name, turn, result));
      std::cout << rows.back().dump() << '\n';
    }
  }
  std::cout << nlohmann::ordered_json{{"seed", first},
                                      {"threads", options.threads},
                                      {"rows", rows}}
                   .dump()
            << '\n';
  return 0;
}

} // namespace

int
main(int argc, char** argv)
{
  return runProgram("compare_keypoints", run, argc, argv);
}
