// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// PURPOSE

#include "results/instances_json.h"

#include <nlohmann/json.hpp>

namespace pcl::app {
namespace {

using Json = nlohmann::ordered_json;

Json
vectorAt(const std::vector<float>& coefficients, std::size_t first)
{
  return {coefficients[first], coefficients[first + 1], coefficients[first + 2]};
}

Json
toJson(const ShapePrimitive& primitive)
{
  const std::vector<float>& c = primitive.coefficients;
  switch (primitive.type) {
  case PrimitiveType::Plane:
    return {{"type", "plane"},
            {"normal", vectorAt(c, 0)},
            {"offset", c[3]},
            {"residual", primitive.residual}};
  case PrimitiveType::Cylinder:
    return {{"type", "cylinder"},
            {"point", vectorAt(c, 0)},
            {"axis", vectorAt(c, 3)},
            {"radius", c[6]},
            {"residual", primitive.residual}};
  case PrimitiveType::Sphere:
    return {{"type", "sphere"},
            {"center", vectorAt(c, 0)},
            {"radius", c[3]},
            {"residual", primitive.residual}};
  default:
    return nullptr;
  }
}

} // namespace

std::string
instancesToJson(const std::vector<ShapeInstance>& instances,
                const std::string& of_class,
                const std::vector<std::string>& classes)
{
  Json list = Json::array();
  for (const ShapeInstance& instance : instances) {
    const Eigen::Vector3f& c = instance.centroid;
    Json one = {{"id", list.size() + 1},
                {"class", of_class},
                {"points", instance.indices.size()},
                {"centroid", {c.x(), c.y(), c.z()}}};
    for (std::size_t k = 0; k < classes.size(); ++k)
      if (!one.contains(classes[k]))
        one[classes[k]] = instance.shares[k];
    if (instance.primitive.type != PrimitiveType::None)
      one["primitive"] = toJson(instance.primitive);
    list.push_back(one);
  }
  return list.dump(-1, ' ', false, Json::error_handler_t::replace);
}

} // namespace pcl::app
