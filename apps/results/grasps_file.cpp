// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// PURPOSE

#include "results/grasps_file.h"

#include <nlohmann/json.hpp>

namespace pcl::app {
namespace {

using Json = nlohmann::ordered_json;

Json
toJson(const Eigen::Vector3f& v)
{
  return {v.x(), v.y(), v.z()};
}

Json
toJson(const SuctionGrasp& grasp)
{
  Json problems = Json::array();
  for (const SealProblem problem : grasp.problems)
    problems.push_back(nameOf(problem));
  return {{"position", toJson(grasp.position)},
          {"approach", toJson(grasp.approach)},
          {"score", grasp.score},
          {"seals", grasp.seals()},
          {"problems", problems},
          {"surface", grasp.surface == 1 ? "planar" : "curved"},
          {"likelihood", grasp.likelihood},
          {"covered", grasp.covered},
          {"border_distance", grasp.border_distance},
          {"edge_distance", grasp.edge_distance},
          {"obstacle_distance", grasp.obstacle_distance},
          {"margin", grasp.margin},
          {"sag", grasp.sag},
          {"sag_allowed", grasp.sag_allowed},
          {"residual", grasp.residual},
          {"residual_allowed", grasp.residual_allowed},
          {"convergence",
           {{"converged", grasp.converged},
            {"iterations", grasp.iterations},
            {"starts", grasp.starts},
            {"bandwidth", grasp.bandwidth},
            {"moved", grasp.moved}}}};
}

} // namespace

std::string
graspsToJson(const std::string& app,
             const Report& report,
             const std::vector<SuctionGrasp>& grasps)
{
  Json json = Json::parse(toJson(app, report));
  json["grasps"] = Json::array();
  for (const SuctionGrasp& grasp : grasps)
    json["grasps"].push_back(toJson(grasp));
  constexpr int indent = 2;
  return json.dump(indent, ' ', false, Json::error_handler_t::replace) + '\n';
}

} // namespace pcl::app
