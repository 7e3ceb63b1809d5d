// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Instances of a field: what they are made of, and what each is like.

#include "common/gathered.h"
#include "common/number_text.h"
#include "geometry/point_grid.h"
#include "instances/instance_detection.h"
#include "instances/instance_points.h"
#include "segmentation/compiled_estimations.h"
#include "segmentation/field_places.h"

#include <pcl/segmentation/impl/shape_instance_segmentation.hpp>

#include <algorithm>
#include <limits>
#include <numeric>
#include <utility>

namespace pcl::detail {
namespace {

const char* const object = "object";
const char* const planar = "planar";

std::size_t
positionOf(const std::string& name, const std::vector<std::string>& names)
{
  return static_cast<std::size_t>(std::find(names.begin(), names.end(), name) -
                                  names.begin());
}

/** The points that instances are made of, of a field or of its base. */
struct InstanceMembers {
  const ShapeField& field;
  std::vector<std::int32_t> points;     ///< of the field, each once
  std::vector<std::int32_t> of_indices; ///< the one of them for each index; -1 none
  float median_spacing = 0.0f;
};

/** Those of the indices, or the means that stand for them. */
InstanceMembers
membersOf(const InstanceRequest& request)
{
  const ShapeField& field = request.field;
  std::vector<std::int32_t> points(request.indices.begin(), request.indices.end());
  if (field.resolution == 0.0 || !field.base) {
    std::vector<std::int32_t> themselves(points.size());
    std::iota(themselves.begin(), themselves.end(), 0);
    return {field, std::move(points), std::move(themselves)};
  }
  const std::vector<std::int32_t> means = gathered(field.base_points, points);
  std::vector<std::int32_t> numbers(field.base->points.size, -1);
  for (const std::int32_t mean : means)
    if (mean >= 0)
      numbers[static_cast<std::size_t>(mean)] = 0;
  points.clear();
  for (std::size_t mean = 0; mean < numbers.size(); ++mean)
    if (numbers[mean] == 0) {
      numbers[mean] = static_cast<std::int32_t>(points.size());
      points.push_back(static_cast<std::int32_t>(mean));
    }
  return {*field.base, std::move(points), gathered(numbers, means, -1)};
}

/** Leaves out what is not finite, and sorts the others cell by cell: what is near in
 * space is near in memory, too, where nearly all steps look for it.
 * \return the grid of what is left */
segmentation::PointGrid
sortByCells(unsigned threads, InstanceMembers& members)
{
  const std::vector<float> positions =
      positionsAt(members.field.points, members.points);
  segmentation::PointGrid grid(
      viewOfPositions(positions), gridCell(members.median_spacing), threads);
  std::vector<std::int32_t> places(members.points.size(), -1);
  for (std::size_t at = 0; at < grid.order().size(); ++at)
    places[grid.order()[at]] = static_cast<std::int32_t>(at);
  members.points = gathered(members.points, grid.order());
  members.of_indices = gathered(places, members.of_indices, -1);
  return std::move(grid).renumbered();
}

struct InstanceValues {
  InstanceInput input;
  std::vector<std::vector<float>> likelihoods; ///< of every class
};

/** \param[in] positions of the members */
InstanceValues
valuesOf(const InstanceRequest& request,
         const InstanceMembers& members,
         const std::vector<float>& positions)
{
  const ShapeField& field = members.field;
  InstanceValues values;
  InstanceInput& input = values.input;
  input.points = viewOfPositions(positions);
  input.spacings = gathered(field.spacings, members.points);
  input.edge = gathered(field.edge_likelihood, members.points);
  for (const std::vector<float>& likelihood : field.likelihoods)
    values.likelihoods.push_back(gathered(likelihood, members.points));
  input.normals.reserve(positions.size());
  for (std::size_t i = 0; i < members.points.size(); ++i) {
    const Eigen::Vector3f normal = segmentation::turnedNormal(
        field.normals[static_cast<std::size_t>(members.points[i])],
        Eigen::Map<const Eigen::Vector3f>(&positions[3 * i]),
        request.view_point);
    input.normals.insert(input.normals.end(), normal.data(), normal.data() + 3);
  }
  const std::string& name = request.name == object ? planar : request.name;
  input.likelihood = values.likelihoods[positionOf(name, field.classes)];
  input.noise = field.noise;
  input.view_point = request.view_point;
  input.threads = request.threads;
  input.median_spacing = members.median_spacing;
  return values;
}

/** The share of each class among the points of an instance; those on edges count only
 * if there are no others. */
std::vector<float>
sharesOf(const std::vector<std::uint32_t>& members, const InstanceValues& values)
{
  const std::size_t classes = values.likelihoods.size();
  std::vector<std::size_t> inner(classes), all(classes);
  for (const std::uint32_t i : members) {
    std::size_t likeliest = 0;
    for (std::size_t c = 1; c < classes; ++c)
      if (values.likelihoods[c][i] > values.likelihoods[likeliest][i])
        likeliest = c;
    ++all[likeliest];
    inner[likeliest] += values.input.edge[i] > 0.5f ? 0 : 1;
  }
  const bool has_inner =
      std::count(inner.begin(), inner.end(), 0U) < static_cast<std::ptrdiff_t>(classes);
  const std::vector<std::size_t>& counts = has_inner ? inner : all;
  const auto total = std::accumulate(counts.begin(), counts.end(), std::size_t{0});
  std::vector<float> shares;
  for (const std::size_t count : counts)
    shares.push_back(static_cast<float>(count) / static_cast<float>(total));
  return shares;
}

void
setPoints(const InstanceRequest& request,
          const InstanceLabels& labels,
          std::vector<ShapeInstance>& instances)
{
  std::vector<Eigen::Vector3d> sums(instances.size(), Eigen::Vector3d::Zero());
  for (std::size_t i = 0; i < labels.size(); ++i) {
    if (labels[i] < 0)
      continue;
    const auto label = static_cast<std::size_t>(labels[i]);
    const index_t index = request.indices[i];
    instances[label].indices.push_back(index);
    const float* p = request.field.points[static_cast<std::size_t>(index)];
    sums[label] += Eigen::Vector3f(p).cast<double>();
  }
  for (std::size_t k = 0; k < instances.size(); ++k) {
    const auto points = static_cast<double>(instances[k].indices.size());
    instances[k].centroid = (sums[k] / points).cast<float>();
    std::sort(instances[k].indices.begin(), instances[k].indices.end());
  }
}

std::vector<ShapeInstance>
instancesOf(const InstanceRequest& request)
{
  InstanceMembers chosen = membersOf(request);
  chosen.median_spacing =
      segmentation::medianSpacing(gathered(chosen.field.spacings, chosen.points));
  const segmentation::PointGrid grid = sortByCells(request.threads, chosen);
  const std::vector<float> positions = positionsAt(chosen.field.points, chosen.points);
  InstanceValues values = valuesOf(request, chosen, positions);
  if (request.name == object)
    values.input.order =
        segmentation::pointsInOrder(values.input, [](std::uint32_t) { return true; });
  const InstanceLabels labels =
      request.name == object ? findObjects(values.input, grid, request.limits)
                             : findComponents(values.input, grid, request.limits);
  std::vector<std::vector<std::uint32_t>> members;
  for (std::size_t i = 0; i < labels.size(); ++i) {
    if (labels[i] < 0)
      continue;
    const auto label = static_cast<std::size_t>(labels[i]);
    members.resize(std::max(members.size(), label + 1));
    members[label].push_back(static_cast<std::uint32_t>(i));
  }
  std::vector<ShapeInstance> instances;
  for (const auto& points : members) {
    ShapeInstance& instance = instances.emplace_back();
    instance.shares = sharesOf(points, values);
    instance.primitive = fitPrimitive(values.input, points, request.primitive);
  }
  setPoints(request, gathered(labels, chosen.of_indices, -1), instances);
  return instances;
}

/** Instances of places, with all of the points that are there. */
void
setPointsAt(const FieldPlaces& places,
            const pcl::Indices& indices,
            std::vector<ShapeInstance>& instances)
{
  std::vector<std::int32_t> labels(places.field().points.size, -1);
  for (std::size_t k = 0; k < instances.size(); ++k) {
    for (const index_t place : instances[k].indices)
      labels[static_cast<std::size_t>(place)] = static_cast<std::int32_t>(k);
    instances[k].indices.clear();
  }
  for (const index_t index : indices) {
    const std::int32_t label = labels[places.placeOf(static_cast<std::size_t>(index))];
    if (label >= 0)
      instances[static_cast<std::size_t>(label)].indices.push_back(index);
  }
  for (ShapeInstance& instance : instances)
    std::sort(instance.indices.begin(), instance.indices.end());
}

} // namespace

std::string
problemOfInstances(const std::vector<std::string>& classes,
                   const std::string& name,
                   const InstanceLimits& limits)
{
  if (classes.empty())
    return "the field has no classes: it was made for edges only";
  if (positionOf(name == object ? planar : name, classes) == classes.size()) {
    std::string problem = "class '" + name + "': it must be one of ";
    for (const std::string& known : classes)
      problem += known + ", ";
    return problem + "or object if one of them is planar";
  }
  if (!(limits.low >= 0.0 && limits.low <= limits.high && limits.high <= 1.0))
    return "thresholds are " + numberText(limits.high) + " and " +
           numberText(limits.low) + ": 0 <= low <= high <= 1 must hold";
  return limits.min_points >= 1 ? std::string()
                                : "the minimum number of points is 0: it must be 1 or "
                                  "more";
}

std::vector<ShapeInstance>
findInstances(const InstanceRequest& request)
{
  const FieldPlaces places(request.field);
  if (!places.hasRepeats())
    return instancesOf(request);
  const pcl::Indices indices = places.placesOf(request.indices);
  std::vector<ShapeInstance> instances = instancesOf({places.field(),
                                                      indices,
                                                      request.name,
                                                      request.limits,
                                                      request.primitive,
                                                      request.view_point,
                                                      request.threads});
  setPointsAt(places, request.indices, instances);
  return instances;
}

} // namespace pcl::detail

PCL_INSTANTIATE(ShapeInstanceSegmentation, PCL_SHAPE_POINT_TYPES)
