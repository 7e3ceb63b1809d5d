// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Creases as polylines: crease points thinned to nodes, and nodes joined to chains.

#include "common/statistics.h"
#include "features/adaptive_inad.h"
#include "geometry/point_grid.h"
#include "geometry/polyline.h"
#include "geometry/principal_axes.h"

#include <pcl/segmentation/shape_field.h>

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <stdexcept>
#include <string>
#include <tuple>
#include <vector>

namespace pcl {
namespace {

using namespace segmentation;
using Eigen::Matrix3f;
using Eigen::Vector3f;

constexpr float same_crease = 0.866f;     // cosine of 30 degrees between directions
constexpr float smooth_spacings = 1.5f;   // as wide as a band of crease points
constexpr int smooth_rounds = 2;          // the band is a line then
constexpr float apart_spacings = 1.0f;    // between nodes: the detail of the cloud
constexpr std::size_t min_places = 3;     // that a node stands for: fewer are chance
constexpr float link_spacings = 6.0f;     // the gaps where too few votes agree
constexpr float strip_spacings = 0.7f;    // does not turn into the edges of a corner
constexpr float straight_spacings = 0.5f; // half of what is between nodes
constexpr float min_spacings = 5.0f;      // the fit of one neighborhood is 4 wide
constexpr std::uint32_t none = 0xffffffff;

/** A place on a crease. A node is one that stands for those around it. */
struct Place {
  Vector3f position;
  Vector3f direction;      ///< unit, of either sign
  float angle = 0.0f;      ///< of a node the median of its places, radians
  float spacing = 0.0f;    ///< meters
  std::size_t support = 0; ///< places around it that have its direction
  float before = 0.0f;     ///< how far a node's places reach along -direction, meters
  float beyond = 0.0f;     ///< and along direction
};

void
requireUsable(const std::vector<CreasePoint>& creases)
{
  for (std::size_t i = 0; i < creases.size(); ++i) {
    const CreasePoint& c = creases[i];
    const auto refuse = [i](const std::string& text) {
      throw std::invalid_argument("crease point " + std::to_string(i) + ": the " +
                                  text);
    };
    if (!Eigen::Map<const Vector3f>(c.position.data()).allFinite())
      refuse("position must be finite");
    const float length = Eigen::Map<const Vector3f>(c.direction.data()).norm();
    constexpr float rounding = 1e-3f;
    if (!(std::abs(length - 1.0f) <= rounding))
      refuse("length of the direction must be 1, it is " + std::to_string(length));
    constexpr float half_turn = 3.1415928f;
    if (!(c.angle >= 0.0f && c.angle <= half_turn))
      refuse("angle must be 0 to pi, it is " + std::to_string(c.angle));
    if (!(c.spacing > 0.0f && std::isfinite(c.spacing)))
      refuse("spacing must be a positive number, it is " + std::to_string(c.spacing));
  }
}

std::vector<Place>
sortedPlaces(std::vector<CreasePoint> creases)
{
  std::sort(creases.begin(), creases.end(), [](const auto& a, const auto& b) {
    return std::tie(a.position, a.direction, a.angle, a.spacing) <
           std::tie(b.position, b.direction, b.angle, b.spacing);
  });
  std::vector<Place> places;
  places.reserve(creases.size());
  for (const CreasePoint& crease : creases)
    places.push_back({Eigen::Map<const Vector3f>(crease.position.data()),
                      Eigen::Map<const Vector3f>(crease.direction.data()),
                      crease.angle,
                      crease.spacing});
  return places;
}

PointGrid
gridOf(const std::vector<Place>& places, float spacings)
{
  float max_spacing = 0.0f;
  for (const Place& place : places)
    max_spacing = std::max(max_spacing, place.spacing);
  return {positionsOf(places), spacings * max_spacing};
}

/** visit(index) for the places around one that have its direction, itself included. */
template <typename Visit>
void
forEachAlong(const std::vector<Place>& places,
             const PointGrid& grid,
             const Place& center,
             float spacings,
             const Visit& visit)
{
  grid.forEachWithin(
      center.position, spacings * center.spacing, [&](std::uint32_t k, float) {
        if (std::abs(places[k].direction.dot(center.direction)) > same_crease)
          visit(k);
      });
}

/** The place moved to the middle of those around it, across their common direction. */
Place
centered(const std::vector<Place>& places, const PointGrid& grid, Place place)
{
  Vector3f sum = Vector3f::Zero();
  Matrix3f directions = Matrix3f::Zero();
  place.support = 0;
  forEachAlong(places, grid, place, smooth_spacings, [&](std::uint32_t k) {
    sum += places[k].position - place.position;
    directions += places[k].direction * places[k].direction.transpose();
    ++place.support;
  });
  if (place.support == 0)
    return place;
  place.direction = principalAxis(directions, 2);
  sum /= static_cast<float>(place.support);
  place.position += sum - sum.dot(place.direction) * place.direction;
  return place;
}

std::vector<Place>
centered(const std::vector<Place>& places)
{
  const PointGrid grid = gridOf(places, smooth_spacings);
  std::vector<Place> moved;
  moved.reserve(places.size());
  for (const Place& place : places)
    moved.push_back(centered(places, grid, place));
  return moved;
}

/** A node of the places around it. */
Place
nodeOf(const std::vector<Place>& places,
       const std::vector<std::uint32_t>& around,
       Place node)
{
  std::vector<float> angles;
  for (const std::uint32_t k : around) {
    const float along = (places[k].position - node.position).dot(node.direction);
    node.before = std::max(node.before, -along);
    node.beyond = std::max(node.beyond, along);
    angles.push_back(places[k].angle);
  }
  node.angle = median(std::move(angles));
  return node;
}

/** Thin crease points to nodes about one spacing apart along each crease: places move
 * to the middle of their crease, then those in the thick of it are chosen first. */
std::vector<Place>
creaseNodes(const std::vector<CreasePoint>& creases)
{
  std::vector<Place> places = sortedPlaces(creases);
  for (int round = 0; round < smooth_rounds; ++round)
    places = centered(places);
  std::vector<std::size_t> by_support(places.size());
  std::iota(by_support.begin(), by_support.end(), std::size_t{0});
  std::stable_sort(by_support.begin(), by_support.end(), [&](auto a, auto b) {
    return places[a].support > places[b].support;
  });
  const PointGrid grid = gridOf(places, smooth_spacings);
  std::vector<Place> nodes;
  std::vector<char> is_taken(places.size(), 0);
  std::vector<std::uint32_t> around;
  for (const std::size_t i : by_support) {
    if (is_taken[i])
      continue;
    around.clear();
    forEachAlong(places, grid, places[i], apart_spacings, [&](std::uint32_t k) {
      around.push_back(k);
      is_taken[k] = 1;
    });
    if (around.size() >= min_places)
      nodes.push_back(nodeOf(places, around, places[i]));
  }
  return nodes;
}

/** Two nodes that may follow each other, and on which side of each the other is. */
struct Link {
  float cost = 0.0f; ///< in spacings
  std::uint32_t from = 0, to = 0;
  int from_side = 0, to_side = 0;
};

/** The nodes that follow each one: against its direction, and along it. */
using Links = std::vector<std::array<std::uint32_t, 2>>;

/** True if an offset from a node stays in a strip along its direction, ahead of it
 * or behind it rather than beside it. */
bool
isOnCourse(const Place& node, const Vector3f& offset)
{
  const float along = std::abs(offset.dot(node.direction));
  const float across = offset.cross(node.direction).norm();
  return across < std::min(along, strip_spacings * node.spacing);
}

std::vector<Link>
possibleLinks(const std::vector<Place>& nodes)
{
  const PointGrid grid = gridOf(nodes, link_spacings);
  std::vector<Link> links;
  for (std::uint32_t i = 0; i < nodes.size(); ++i) {
    const Place& a = nodes[i];
    grid.forEachWithin(
        a.position, link_spacings * a.spacing, [&](std::uint32_t k, float) {
          const Place& b = nodes[k];
          const Vector3f offset = b.position - a.position;
          if (k > i && std::abs(a.direction.dot(b.direction)) > same_crease &&
              isOnCourse(a, offset) && isOnCourse(b, offset))
            links.push_back({offset.norm() / a.spacing,
                             i,
                             k,
                             offset.dot(a.direction) > 0.0f,
                             offset.dot(b.direction) < 0.0f});
        });
  }
  std::sort(links.begin(), links.end(), [](const Link& a, const Link& b) {
    return std::tie(a.cost, a.from, a.to) < std::tie(b.cost, b.from, b.to);
  });
  return links;
}

/** The shortest links first, one at each side of a node. */
Links
chooseLinks(const std::vector<Place>& nodes)
{
  Links chosen(nodes.size(), {none, none});
  for (const Link& link : possibleLinks(nodes)) {
    std::uint32_t& from = chosen[link.from][static_cast<std::size_t>(link.from_side)];
    std::uint32_t& to = chosen[link.to][static_cast<std::size_t>(link.to_side)];
    if (from == none && to == none) {
      from = link.to;
      to = link.from;
    }
  }
  return chosen;
}

/** The nodes from one that follow each other; closed ones end where they begin. */
std::vector<std::uint32_t>
trace(const Links& links, std::uint32_t first, std::vector<char>& is_used)
{
  std::vector<std::uint32_t> chain{first};
  is_used[first] = 1;
  std::uint32_t previous = none;
  for (std::uint32_t node = first;;) {
    const auto& sides = links[node];
    const std::uint32_t next = sides[0] == previous ? sides[1] : sides[0];
    if (next == none)
      return chain;
    chain.push_back(next);
    if (next == first)
      return chain;
    is_used[next] = 1;
    previous = node;
    node = next;
  }
}

std::vector<std::vector<std::uint32_t>>
chainsOf(const Links& links)
{
  std::vector<std::vector<std::uint32_t>> chains;
  std::vector<char> is_used(links.size(), 0);
  const auto start = [&](bool only_ends) {
    for (std::uint32_t i = 0; i < links.size(); ++i)
      if (!is_used[i] && (!only_ends || links[i][0] == none || links[i][1] == none))
        chains.push_back(trace(links, i, is_used));
  };
  start(true);
  start(false);
  return chains;
}

/** The end of a chain, moved outwards to where the crease points of its node end. */
Vector3f
endOf(const Place& end, const Place& inner)
{
  const bool is_along = (end.position - inner.position).dot(end.direction) > 0.0f;
  return end.position + (is_along ? end.beyond : -end.before) * end.direction;
}

CreaseLine
lineOf(const std::vector<Place>& nodes, const std::vector<std::uint32_t>& chain)
{
  std::vector<Vector3f> positions;
  std::vector<float> angles, spacings;
  for (const std::uint32_t i : chain) {
    positions.push_back(nodes[i].position);
    angles.push_back(nodes[i].angle);
    spacings.push_back(nodes[i].spacing);
  }
  CreaseLine line;
  line.closed = chain.size() > 1 && chain.front() == chain.back();
  if (!line.closed && chain.size() > 1) {
    positions.front() = endOf(nodes[chain[0]], nodes[chain[1]]);
    positions.back() = endOf(nodes[chain.back()], nodes[chain[chain.size() - 2]]);
  }
  line.spacing = median(std::move(spacings));
  line.angle = median(std::move(angles));
  positions = simplified(positions, straight_spacings * line.spacing);
  line.length = lengthOf(positions);
  for (const Vector3f& p : positions)
    line.points.push_back({p.x(), p.y(), p.z()});
  return line;
}

} // namespace

std::vector<CreaseLine>
creaseLines(const std::vector<CreasePoint>& creases)
{
  requireUsable(creases);
  const std::vector<Place> nodes = creaseNodes(creases);
  std::vector<CreaseLine> lines;
  for (const auto& chain : chainsOf(chooseLinks(nodes))) {
    CreaseLine line = lineOf(nodes, chain);
    if (line.length >= min_spacings * line.spacing)
      lines.push_back(std::move(line));
  }
  std::stable_sort(lines.begin(), lines.end(), [](const auto& a, const auto& b) {
    return a.length > b.length;
  });
  return lines;
}

} // namespace pcl
