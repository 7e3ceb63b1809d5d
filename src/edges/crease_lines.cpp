// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// PURPOSE

#include "common/statistics.h"
#include "geometry/point_grid.h"
#include "geometry/polyline.h"

#include "features/adaptive_inad.h"

#include <pcl/segmentation/shape_field.h>

#include <Eigen/Core>
#include <Eigen/Eigenvalues>

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <string>
#include <tuple>
#include <vector>

namespace pcl::segmentation {

/** \brief A place on a crease that stands for the crease points around it. */
struct CreaseNode {
  Eigen::Vector3f position;
  Eigen::Vector3f direction; ///< unit, of either sign
  float angle = 0.0f;        ///< median of the points it stands for, radians
  float spacing = 0.0f;      ///< metres
  float before = 0.0f;       ///< how far its points reach along -direction, metres
  float beyond = 0.0f;       ///< and along direction
};

/** \brief Thin crease points to nodes about one spacing apart along each crease.
 *
 * Each point moves across its crease to the middle of the points around it that have
 * its direction; then points are chosen, those in the thick of it first, that keep
 * their distance from each other. The result does not depend on the order of points. */
std::vector<CreaseNode> creaseNodes(std::vector<CreasePoint> points);

namespace {

using Eigen::Matrix3f;
using Eigen::Vector3f;

// doc/method.md has the reason of each number.
constexpr float same_direction = 0.866f; // cosine of 30 degrees
constexpr float smooth_spacings = 1.5f;
constexpr int smooth_rounds = 2;
constexpr float apart_spacings = 1.0f;
constexpr std::size_t least_points = 3; // that a node stands for, itself included

struct Point {
  Vector3f position;
  Vector3f direction;
  float angle = 0.0f;
  float spacing = 0.0f;
  std::size_t support = 0; ///< points around it that have its direction
};

std::vector<Point>
sorted(std::vector<CreasePoint> creases)
{
  std::sort(creases.begin(), creases.end(), [](const auto& a, const auto& b) {
    return std::tie(a.position, a.direction, a.angle, a.spacing) <
           std::tie(b.position, b.direction, b.angle, b.spacing);
  });
  std::vector<Point> points;
  points.reserve(creases.size());
  for (const CreasePoint& crease : creases)
    points.push_back({Eigen::Map<const Vector3f>(crease.position.data()),
                      Eigen::Map<const Vector3f>(crease.direction.data()),
                      crease.angle,
                      crease.spacing,
                      0});
  return points;
}

PointGrid
gridOf(const std::vector<Point>& points)
{
  float most = 0.0f;
  for (const Point& point : points)
    most = std::max(most, point.spacing);
  return PointGrid(
      {points[0].position.data(), sizeof(Point) / sizeof(float), points.size()},
      smooth_spacings * most);
}

/** visit(index) for the points around one that have its direction, itself included. */
template <typename Visit>
void
forEachAlong(const std::vector<Point>& points,
             const PointGrid& grid,
             const Point& center,
             float spacings,
             const Visit& visit)
{
  grid.forEachWithin(
      center.position, spacings * center.spacing, [&](std::uint32_t k, float) {
        if (std::abs(points[k].direction.dot(center.direction)) > same_direction)
          visit(k);
      });
}

/** The point moved to the middle of those around it, across their common direction. */
Point
centered(const std::vector<Point>& points, const PointGrid& grid, Point point)
{
  Vector3f sum = Vector3f::Zero();
  Matrix3f directions = Matrix3f::Zero();
  point.support = 0;
  forEachAlong(points, grid, point, smooth_spacings, [&](std::uint32_t k) {
    sum += points[k].position - point.position;
    directions += points[k].direction * points[k].direction.transpose();
    ++point.support;
  });
  if (point.support == 0)
    return point;
  Eigen::SelfAdjointEigenSolver<Matrix3f> solver;
  solver.computeDirect(directions);
  point.direction = solver.eigenvectors().col(2);
  sum /= static_cast<float>(point.support);
  point.position += sum - sum.dot(point.direction) * point.direction;
  return point;
}

std::vector<Point>
centered(const std::vector<Point>& points)
{
  const PointGrid grid = gridOf(points);
  std::vector<Point> moved;
  moved.reserve(points.size());
  for (const Point& point : points)
    moved.push_back(centered(points, grid, point));
  return moved;
}

/** The indices of points, those with the most support first. */
std::vector<std::size_t>
bySupport(const std::vector<Point>& points)
{
  std::vector<std::size_t> order(points.size());
  for (std::size_t i = 0; i < order.size(); ++i)
    order[i] = i;
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return points[a].support > points[b].support;
  });
  return order;
}

/** What a chosen point stands for: all points around it, as they were measured. */
CreaseNode
nodeOf(const std::vector<Point>& points,
       const std::vector<std::uint32_t>& around,
       const Point& chosen)
{
  CreaseNode node{chosen.position, chosen.direction, 0.0f, chosen.spacing, 0.0f, 0.0f};
  std::vector<float> angles;
  for (const std::uint32_t k : around) {
    const float along = (points[k].position - node.position).dot(node.direction);
    node.before = std::max(node.before, -along);
    node.beyond = std::max(node.beyond, along);
    angles.push_back(points[k].angle);
  }
  node.angle = median(std::move(angles));
  return node;
}

} // namespace

std::vector<CreaseNode>
creaseNodes(std::vector<CreasePoint> creases)
{
  std::vector<CreaseNode> nodes;
  if (creases.empty())
    return nodes;
  std::vector<Point> points = sorted(std::move(creases));
  for (int round = 0; round < smooth_rounds; ++round)
    points = centered(points);
  const PointGrid grid = gridOf(points);
  std::vector<char> is_taken(points.size(), 0);
  std::vector<std::uint32_t> around;
  for (const std::size_t i : bySupport(points)) {
    if (is_taken[i])
      continue;
    around.clear();
    forEachAlong(points, grid, points[i], apart_spacings, [&](std::uint32_t k) {
      around.push_back(k);
      is_taken[k] = 1;
    });
    if (around.size() >= least_points)
      nodes.push_back(nodeOf(points, around, points[i]));
  }
  return nodes;
}

} // namespace pcl::segmentation

namespace pcl {
namespace {

using namespace segmentation;
using Eigen::Vector3f;

// doc/method.md has the reason of each number.
constexpr float link_spacings = 6.0f;
constexpr float strip_spacings = 0.7f;
constexpr float same_direction = 0.866f; // cosine of 30 degrees
constexpr float least_spacings = 5.0f;
constexpr float straight_spacings = 0.5f;
constexpr std::uint32_t none = 0xffffffff;

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
isOnCourse(const CreaseNode& node, const Vector3f& offset)
{
  const float along = std::abs(offset.dot(node.direction));
  const float across = offset.cross(node.direction).norm();
  return across < std::min(along, strip_spacings * node.spacing);
}

std::vector<Link>
possibleLinks(const std::vector<CreaseNode>& nodes)
{
  float most = 0.0f;
  for (const CreaseNode& node : nodes)
    most = std::max(most, node.spacing);
  const PointGrid grid(
      {nodes[0].position.data(), sizeof(CreaseNode) / sizeof(float), nodes.size()},
      link_spacings * most);
  std::vector<Link> links;
  for (std::uint32_t i = 0; i < nodes.size(); ++i) {
    const CreaseNode& a = nodes[i];
    grid.forEachWithin(
        a.position, link_spacings * a.spacing, [&](std::uint32_t k, float) {
          const CreaseNode& b = nodes[k];
          const Vector3f offset = b.position - a.position;
          if (k > i && std::abs(a.direction.dot(b.direction)) > same_direction &&
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
chooseLinks(const std::vector<CreaseNode>& nodes)
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
endOf(const CreaseNode& end, const CreaseNode& inner)
{
  const bool is_along = (end.position - inner.position).dot(end.direction) > 0.0f;
  return end.position + (is_along ? end.beyond : -end.before) * end.direction;
}

CreaseLine
lineOf(const std::vector<CreaseNode>& nodes, const std::vector<std::uint32_t>& chain)
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

void
requireUsable(const std::vector<CreasePoint>& creases)
{
  for (std::size_t i = 0; i < creases.size(); ++i) {
    const CreasePoint& c = creases[i];
    const auto refuse = [i](const std::string& what, const std::string& allowed) {
      throw std::invalid_argument("crease point " + std::to_string(i) + ": " + what +
                                  ": allowed is " + allowed);
    };
    if (!Eigen::Map<const Vector3f>(c.position.data()).allFinite())
      refuse("the position is not finite", "a finite one");
    const float norm = Eigen::Map<const Vector3f>(c.direction.data()).norm();
    constexpr float rounding = 1e-3f;
    if (!(std::abs(norm - 1.0f) <= rounding))
      refuse("the direction is " + std::to_string(norm) + " long", "1");
    constexpr float half_turn = 3.1415928f;
    if (!(c.angle >= 0.0f && c.angle <= half_turn))
      refuse("the angle is " + std::to_string(c.angle), "0 to pi");
    if (!(c.spacing > 0.0f && std::isfinite(c.spacing)))
      refuse("the spacing is " + std::to_string(c.spacing), "a positive number");
  }
}

} // namespace

std::vector<CreaseLine>
creaseLines(const std::vector<CreasePoint>& creases)
{
  requireUsable(creases);
  std::vector<CreaseLine> lines;
  const std::vector<CreaseNode> nodes = creaseNodes(creases);
  if (nodes.empty())
    return lines;
  for (const auto& chain : chainsOf(chooseLinks(nodes))) {
    CreaseLine line = lineOf(nodes, chain);
    if (line.length >= least_spacings * line.spacing)
      lines.push_back(std::move(line));
  }
  std::stable_sort(lines.begin(), lines.end(), [](const auto& a, const auto& b) {
    return a.length > b.length;
  });
  return lines;
}

} // namespace pcl
