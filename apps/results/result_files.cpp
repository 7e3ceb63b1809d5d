// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Writes crease lines, instances and grasps as JSON.

#include "results/result_files.h"

#include <nlohmann/json.hpp>

namespace pcl::app {
namespace {

using Json = nlohmann::ordered_json;

Json
vectorToJson(const float* v)
{
  return {v[0], v[1], v[2]};
}

Json
primitiveToJson(const ShapePrimitive& primitive)
{
  const float* const c = primitive.coefficients.data();
  Json json;
  if (primitive.type == PrimitiveType::Plane)
    json = {{"type", "plane"}, {"normal", vectorToJson(c)}, {"offset", c[3]}};
  else if (primitive.type == PrimitiveType::Cylinder)
    json = {{"type", "cylinder"},
            {"point", vectorToJson(c)},
            {"axis", vectorToJson(c + 3)},
            {"radius", c[6]}};
  else
    json = {{"type", "sphere"}, {"center", vectorToJson(c)}, {"radius", c[3]}};
  json["residual"] = primitive.residual;
  return json;
}

Json
graspToJson(const SuctionGrasp& grasp, const std::optional<std::uint32_t>& object)
{
  Json problems = Json::array();
  for (const SealProblem problem : grasp.problems)
    problems.push_back(nameOf(problem));
  Json json = object ? Json{{"object", *object}} : Json::object();
  json.update({{"position", vectorToJson(grasp.position.data())},
               {"approach", vectorToJson(grasp.approach.data())},
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
                 {"moved", grasp.moved}}}});
  return json;
}

} // namespace

std::string
linesToJson(const CloudFile& input, const std::vector<CreaseLine>& lines)
{
  constexpr double degrees_per_radian = 180.0 / 3.14159265358979323846;
  Json json = {{"format", "pcl_shape lines"}, {"version", 1}, {"input", input.path}};
  if (input.offset != std::array<double, 3>{})
    json["offset"] = input.offset;
  json["lines"] = Json::array();
  for (const CreaseLine& line : lines)
    json["lines"].push_back({{"length", line.length},
                             {"angle_degrees", line.angle * degrees_per_radian},
                             {"spacing", line.spacing},
                             {"closed", line.closed},
                             {"points", line.points}});
  return dumpJson(json, -1);
}

void
reportInstances(const std::vector<ShapeInstance>& instances,
                const std::string& of_class,
                const std::vector<std::string>& classes,
                Report& report)
{
  Json list = Json::array();
  for (const ShapeInstance& instance : instances) {
    Json one = {{"id", list.size() + 1},
                {"class", of_class},
                {"points", instance.indices.size()},
                {"centroid", vectorToJson(instance.centroid.data())}};
    for (std::size_t k = 0; k < classes.size(); ++k)
      if (!one.contains(classes[k]))
        one[classes[k]] = instance.shares[k];
    if (instance.primitive.type != PrimitiveType::None)
      one["primitive"] = primitiveToJson(instance.primitive);
    list.push_back(one);
  }
  report.setJson("", "instances", list);
}

std::string
graspsToJson(const std::string& app,
             const Report& report,
             const std::vector<TargetGrasps>& targets)
{
  Json json = Json::parse(toJson(app, report));
  json["grasps"] = Json::array();
  for (const TargetGrasps& target : targets)
    for (const SuctionGrasp& grasp : target.grasps)
      json["grasps"].push_back(graspToJson(grasp, target.object));
  return dumpJson(json);
}

} // namespace pcl::app
