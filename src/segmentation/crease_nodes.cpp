/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * Point Cloud Library (PCL) - www.pointclouds.org
 * Copyright (c) 2026, pcl_shape contributors
 *
 * All rights reserved
 */

#include "crease_nodes.h"

#include "median.h"
#include "point_grid.h"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <tuple>

namespace pcl::segmentation {
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
