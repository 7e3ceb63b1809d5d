// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// The flat parts of a cloud that may be supports.

#include "instances/supports/support_parts.h"

#include "common/disjoint_sets.h"
#include "common/statistics.h"
#include "geometry/point_grid.h"
#include "instances/label_cells.h"
#include "instances/label_runs.h"
#include "instances/primitives/primitives.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <numeric>
#include <optional>
#include <utility>

namespace pcl::segmentation {
namespace {

using Eigen::Vector3f;
using Nodes = std::vector<SurfaceNode>;

constexpr std::size_t max_parts = 12; // ten boards of a shelf, its back and a floor
// In clutter a plane may pass through many things and have no large part.
constexpr std::size_t max_planes = 2 * max_parts;
// Of the largest part: a tray of 20 x 30 cm on 3 square meters of table.
constexpr double min_size = 0.02;
constexpr std::size_t min_nodes = 50;    // some 10 x 10 spacings
constexpr std::size_t max_fitted = 2000; // the smallest part has 40 of them
constexpr float max_gap = 0.25f; // of a part's width: that of a large object on it
constexpr double area_per_point = 0.26; // pi / 12: a disc of one spacing has 12 points
// A ripple turns normals by 22 degrees in the median: normals say little of one point.
constexpr float min_cosine = 0.7f;
// A stereo camera makes a table twice as wavy as others do.
constexpr float max_offset = 2.0f * max_ripple;
constexpr float sigmas = 3.0f, sigma_of_median = 1.4826f; // of normal errors
constexpr std::size_t first_step = 4; // every fourth node: two or three of a cell's
constexpr float coarse_cells = 4.0f;  // reaches, so that few boxes are in several
constexpr int fits = 2; // to what is on the plane, and to what is on that of these

double
areaOfPoint(const SurfaceNode& node)
{
  return area_per_point * node.spacing * node.spacing;
}

double
pointsOf(const SurfaceNode& node, float unit)
{
  return areaOf(node, unit) / areaOfPoint(node);
}

template <typename Value>
double
sumOf(const Nodes& nodes, const Value& valueOf)
{
  const auto add = [&](double sum, const auto& node) { return sum + valueOf(node); };
  return std::accumulate(nodes.begin(), nodes.end(), 0.0, add);
}

double
areaOf(const Nodes& nodes, float unit)
{
  return sumOf(nodes, [unit](const auto& node) { return areaOf(node, unit); });
}

double
pointsOf(const Nodes& nodes, float unit)
{
  return sumOf(nodes, [unit](const auto& node) { return pointsOf(node, unit); });
}

Nodes
nodesOn(const Nodes& nodes, const SupportPlane& support)
{
  Nodes on;
  std::copy_if(nodes.begin(), nodes.end(), std::back_inserter(on), [&](const auto& n) {
    return isOn(n, support);
  });
  return on;
}

/** Nodes within reach of each other. Neighbors in the grid, and for some nodes one of
 * each row of cells, are enough to tell most sets: then only nodes and ranges with
 * several of these around are looked at. */
DisjointSets
connected(const Nodes& nodes, float unit)
{
  const PointGrid grid(positionsOf(nodes), linkReach() * unit);
  const std::vector<std::uint32_t>& order = grid.order();
  DisjointSets sets(nodes.size());
  const auto reachOf = [&](std::uint32_t k) { return linkReach() * nodes[k].spacing; };
  const auto uniteNear = [&](std::uint32_t k, std::uint32_t other) {
    const float reach = reachOf(k);
    if ((nodes[other].position - nodes[k].position).squaredNorm() < reach * reach)
      sets.unite(k, other);
  };
  const auto forEachRange = [&](std::uint32_t k, const auto& visit) {
    grid.forEachRangeWithin(nodes[k].position, reachOf(k), visit);
  };
  for (std::size_t at = 0; at < order.size(); ++at) {
    if (at > 0)
      uniteNear(order[at], order[at - 1]);
    if (at % first_step == 0)
      forEachRange(order[at], [&](std::uint32_t begin, std::uint32_t end) {
        uniteNear(order[at], order[begin + (end - begin) / 2]);
      });
  }
  Labels labels(nodes.size());
  for (std::uint32_t k = 0; k < nodes.size(); ++k)
    labels[k] = static_cast<std::int32_t>(sets.find(k));
  const LabelRuns runs(grid, labels);
  const LabelCells cells(positionsOf(nodes), labels, coarse_cells * linkReach() * unit);
  for (const std::uint32_t k : order) {
    if (!cells.mayHaveOther(nodes[k].position, reachOf(k), labels[k]))
      continue;
    forEachRange(k, [&](std::uint32_t begin, std::uint32_t end) {
      if (!runs.hasOther(begin, end, labels[k]))
        return;
      for (std::uint32_t at = begin; at < end; ++at)
        uniteNear(k, order[at]);
    });
  }
  return sets;
}

/** The connected nodes, of some, that stand for the most points. */
Nodes
largestPart(const Nodes& nodes, float unit)
{
  DisjointSets sets = connected(nodes, unit);
  std::vector<double> points(nodes.size(), 0.0); // of the parts, at their first nodes
  for (std::uint32_t k = 0; k < nodes.size(); ++k)
    points[sets.find(k)] += pointsOf(nodes[k], unit);
  const auto largest = static_cast<std::uint32_t>(
      std::max_element(points.begin(), points.end()) - points.begin());
  Nodes part;
  for (std::uint32_t k = 0; k < nodes.size(); ++k)
    if (sets.find(k) == largest)
      part.push_back(nodes[k]);
  return part;
}

/** The plane that most points are on; the normal is that of most of its nodes. */
std::optional<SupportPlane>
largestPlane(const Nodes& nodes, float unit)
{
  PrimitiveSample sample;
  const Vector3f origin = nodes.front().position;
  const double step = pointsOf(nodes, unit) / max_fitted;
  double points = 0.0;
  for (const SurfaceNode& node : nodes) {
    points += pointsOf(node, unit);
    if (points < step)
      continue;
    sample.add((node.position - origin) / unit, node.normal);
    points = std::fmod(points, step);
  }
  sample.tolerance = sample.first_tolerance = max_ripple;
  sample.min_cosine = min_cosine;
  const ShapePrimitive fitted = fitTo(sample, PrimitiveType::Plane);
  if (fitted.type == PrimitiveType::None)
    return std::nullopt;
  SupportPlane support;
  support.offset = max_ripple;
  support.plane.normal = normalOf(fitted, Vector3f::Zero());
  support.plane.center = origin + unit * footOn(fitted, Vector3f::Zero());
  return support;
}

/** Fit the plane, and how far points are off, to the nodes on it. */
void
fitTo(const Nodes& on, float min_offset, SupportPlane& support)
{
  const Vector3f origin = on.front().position;
  support.plane = fitPlane<float>([&](const auto& visit) {
    for (const SurfaceNode& node : on)
      visit(Vector3f(node.position - origin));
  });
  support.plane.center += origin;
  Vector3f facing = Vector3f::Zero();
  std::vector<float> offsets;
  for (const SurfaceNode& node : on) {
    facing += node.normal;
    offsets.push_back(std::abs(heightOf(node, support.plane)));
  }
  if (facing.dot(support.plane.normal) < 0.0f)
    support.plane.normal = -support.plane.normal;
  support.offset = std::clamp(
      sigmas * sigma_of_median * median(std::move(offsets)), min_offset, max_offset);
}

/** A part, and what else is on its plane near it: behind a gap that an object makes. */
Nodes
withNear(const Nodes& part, const Nodes& on, float reach)
{
  const Nodes places = placesOf(part);
  const PointGrid grid(positionsOf(places), reach);
  Nodes result;
  auto next = part.begin();
  for (const SurfaceNode& node : on) {
    const bool is_in = next != part.end() && next->point == node.point;
    next += is_in ? 1 : 0;
    if (is_in || isNear(node.position, grid, reach))
      result.push_back(node);
  }
  return result;
}

/** The largest connected part of a plane, and the plane fitted to it. */
std::optional<SupportPart>
largestPartOn(SupportPlane support, const Nodes& nodes, float min_offset, float unit)
{
  Nodes on;
  for (int round = 0; round < fits; ++round) {
    on = nodesOn(nodes, support);
    if (on.size() < min_nodes)
      return std::nullopt;
    on = largestPart(on, unit);
    fitTo(on, min_offset, support);
  }
  on = nodesOn(on, support);
  if (on.size() < min_nodes)
    return std::nullopt;
  const auto width = static_cast<float>(std::sqrt(areaOf(on, unit)));
  on = withNear(on, nodesOn(nodes, support), max_gap * width);
  const double area = areaOf(on, unit), points = pointsOf(on, unit);
  return SupportPart{support, std::move(on), area, points};
}

/** The nodes without some of them. */
Nodes
without(const Nodes& some, const Nodes& nodes)
{
  std::uint32_t last = 0;
  for (const SurfaceNode& node : nodes)
    last = std::max(last, node.point);
  std::vector<char> is_some(last + 1, 0);
  for (const SurfaceNode& node : some)
    if (node.point <= last)
      is_some[node.point] = 1;
  Nodes others;
  std::copy_if(nodes.begin(),
               nodes.end(),
               std::back_inserter(others),
               [&](const auto& node) { return !is_some[node.point]; });
  return others;
}

} // namespace

float
heightOf(const SurfaceNode& node, const Plane<float>& plane)
{
  return plane.normal.dot(node.position - plane.center) / node.spacing;
}

bool
isOn(const SurfaceNode& node, const SupportPlane& support)
{
  return std::abs(heightOf(node, support.plane)) < support.offset &&
         std::abs(node.normal.dot(support.plane.normal)) > min_cosine;
}

double
areaOf(const SurfaceNode& node, float unit)
{
  const double cell = static_cast<double>(node_spacings) * unit;
  return std::max(cell * cell, areaOfPoint(node));
}

bool
isLarge(const SupportPart& part, const PartSize& largest, double share)
{
  return part.area >= share * largest.area || part.points >= share * largest.points;
}

PartSize
largestOf(const std::vector<SupportPart>& parts)
{
  PartSize largest;
  for (const SupportPart& part : parts) {
    largest.area = std::max(largest.area, part.area);
    largest.points = std::max(largest.points, part.points);
  }
  return largest;
}

Nodes
placesOf(const Nodes& nodes)
{
  // As far apart as a 22nd of the width of what they are on; they are compared with a
  // quarter of it.
  constexpr std::size_t max_places = 500;
  const std::size_t step = (nodes.size() + max_places - 1) / max_places;
  Nodes places;
  for (std::size_t k = 0; k < nodes.size(); k += step)
    places.push_back(nodes[k]);
  return places;
}

std::vector<SupportPart>
supportParts(const Nodes& nodes, float min_offset, float unit)
{
  Nodes left = nodes;     // on no part
  Nodes searched = nodes; // of these, on no plane without a large part
  std::vector<SupportPart> parts;
  for (std::size_t plane = 0; plane < max_planes && parts.size() < max_parts; ++plane) {
    if (searched.size() < min_nodes)
      break;
    const std::optional<SupportPlane> support = largestPlane(searched, unit);
    if (!support)
      break;
    std::optional<SupportPart> part = largestPartOn(*support, left, min_offset, unit);
    if (part && isLarge(*part, largestOf(parts), min_size)) {
      left = without(part->nodes, left);
      searched = without(part->nodes, searched);
      parts.push_back(std::move(*part));
      continue;
    }
    const Nodes on = nodesOn(searched, *support);
    if (on.size() < min_nodes) // and so have all planes that are left
      break;
    searched = without(on, searched);
  }
  return parts;
}

} // namespace pcl::segmentation
