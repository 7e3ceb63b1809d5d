// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Instances that were found, as a field and counts.

#include "detection/instances.h"

#include "cli/pcl_errors.h"

#include <nlohmann/json.hpp>

namespace pcl::app {
namespace {

using Json = nlohmann::ordered_json;

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

/** Note the instances, as doc/files.md describes them, their number from 1 on.
 * \param[in] of_class what they are instances of
 * \param[in] classes the names of their shares */
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

} // namespace

void
addInstances(CloudFile& file, InstanceSegmentation& segmentation, Report& report)
{
  std::vector<pcl::ShapeInstance> instances;
  withPclErrors(file.path, [&] {
    return report.time("instances", [&] { return segmentation.segment(instances); });
  });
  std::vector<std::uint32_t> labels(file.size(), 0);
  std::uint64_t labeled = 0;
  for (std::size_t k = 0; k < instances.size(); ++k) {
    for (const pcl::index_t index : instances[k].indices)
      labels[static_cast<std::size_t>(index)] = static_cast<std::uint32_t>(k + 1);
    labeled += instances[k].indices.size();
  }
  report.setCount("counts", "instances", instances.size());
  report.setCount("counts", "points in them", labeled);
  reportInstances(
      instances, segmentation.getClass(), segmentation.getClasses(), report);
  setField(file, "instance", labels);
}

} // namespace pcl::app
