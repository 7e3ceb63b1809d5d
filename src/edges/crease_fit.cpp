// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Fits two planes to a neighborhood, and compares their wedge with a smooth surface.

#include "edges/crease_fit.h"

#include "geometry/principal_axes.h"

#include <Eigen/Cholesky>
#include <Eigen/LU>

#include <algorithm>
#include <array>
#include <cmath>

namespace pcl::segmentation {
namespace {

using Eigen::Matrix3f;
using Eigen::Vector3f;

constexpr int normal_rounds = 3;            // they only give the planes a start
constexpr int plane_rounds = 5;             // few neighborhoods change after that
constexpr std::size_t min_plane_points = 5; // fewer are no plane, as for normals
constexpr float parallel = 0.05f;           // sine, 3 degrees: the line is anywhere
constexpr float half_turn = 3.14159265f;
// Spacings. Without noise neither is exact; what is less than this is no difference.
constexpr double min_deviation = 0.03;

/** The normal that differs most from a direction. */
Vector3f
farthestFrom(const Vector3f& direction, const std::vector<Vector3f>& normals)
{
  return *std::min_element(
      normals.begin(), normals.end(), [&](const Vector3f& a, const Vector3f& b) {
        return std::abs(a.dot(direction)) < std::abs(b.dot(direction));
      });
}

/** Which of two groups each normal is in; they start from the two that differ most. */
std::vector<char>
groupNormals(const std::vector<Vector3f>& normals)
{
  Scatter<float> all;
  for (const Vector3f& n : normals)
    all.add(n);
  Vector3f first = farthestFrom(principalAxis(all.matrix(), 2), normals);
  Vector3f second = farthestFrom(first, normals);
  std::vector<char> group(normals.size());
  for (int round = 0; round < normal_rounds; ++round) {
    std::array<Scatter<float>, 2> of_groups;
    for (std::size_t i = 0; i < normals.size(); ++i) {
      group[i] = std::abs(normals[i].dot(second)) > std::abs(normals[i].dot(first));
      of_groups[static_cast<std::size_t>(group[i])].add(normals[i]);
    }
    first = principalAxis(of_groups[0].matrix(), 2);
    second = principalAxis(of_groups[1].matrix(), 2);
  }
  return group;
}

Plane<float>
planeOf(const std::vector<Vector3f>& points)
{
  return fitPlane<float>([&](const auto& visit) {
    for (const Vector3f& point : points)
      visit(point);
  });
}

std::optional<CreaseFit>
intersection(const Plane<float>& a, const Plane<float>& b)
{
  CreaseFit crease;
  crease.direction = a.normal.cross(b.normal);
  const float sine = crease.direction.norm();
  if (!(sine > parallel))
    return std::nullopt;
  crease.direction /= sine;
  Matrix3f rows;
  rows << a.normal.transpose(), b.normal.transpose(), crease.direction.transpose();
  crease.foot =
      rows.inverse() * Vector3f(a.normal.dot(a.center), b.normal.dot(b.center), 0.0f);
  crease.angle = std::asin(std::min(1.0f, sine));
  const Vector3f to_a = a.center - crease.foot, to_b = b.center - crease.foot;
  const Vector3f& along = crease.direction;
  const float same_side = to_a.dot(to_b) - to_a.dot(along) * to_b.dot(along);
  crease.turn = same_side > 0.0f ? half_turn - crease.angle : crease.angle;
  return crease;
}

/** The least sum over the four wedges that two planes bound. A point belongs to one
 * side or the other by where it is, not by which plane is nearer: two sheets, one over
 * the other, are no wedge, and noise gains nothing by choosing. */
float
wedgeSquares(const std::vector<Vector3f>& points,
             const Plane<float>& first,
             const Plane<float>& second)
{
  std::array<float, 4> squares{};
  for (const Vector3f& point : points) {
    const float a = first.normal.dot(point - first.center);
    const float b = second.normal.dot(point - second.center);
    const std::array<float, 4> distances{
        std::max(a, b), std::min(a, b), std::max(a, -b), std::min(a, -b)};
    for (std::size_t k = 0; k < squares.size(); ++k)
      squares[k] += distances[k] * distances[k];
  }
  return *std::min_element(squares.begin(), squares.end());
}

/** The sum of the squared heights over the quadric nearest to the points, heights
 * measured along the normal of their plane. */
double
quadricSquares(const std::vector<Vector3f>& points)
{
  using Vector6d = Eigen::Matrix<double, 6, 1>;
  const Plane<float> plane = planeOf(points);
  const Vector3f u = plane.normal.unitOrthogonal(), v = plane.normal.cross(u);
  Eigen::Matrix<double, 6, 6> products = Eigen::Matrix<double, 6, 6>::Zero();
  Vector6d heights = Vector6d::Zero();
  double squares = 0.0;
  for (const Vector3f& point : points) {
    const Vector3f from_center = point - plane.center;
    const double x = from_center.dot(u), y = from_center.dot(v);
    const double z = from_center.dot(plane.normal);
    Vector6d row;
    row << 1.0, x, y, x * x, x * y, y * y;
    products += row * row.transpose();
    heights += z * row;
    squares += z * z;
  }
  return std::max(0.0, squares - heights.dot(products.ldlt().solve(heights)));
}

} // namespace

std::optional<CreaseFit>
fitCrease(const Patch& patch)
{
  const std::vector<Vector3f>& points = patch.points;
  if (points.size() < 2 * min_plane_points)
    return std::nullopt;
  std::vector<char> group = groupNormals(patch.normals);
  Plane<float> first, second;
  std::array<std::vector<Vector3f>, 2> of_groups;
  for (std::vector<Vector3f>& of_group : of_groups)
    of_group.reserve(points.size());
  for (int round = 0; round < plane_rounds; ++round) {
    for (std::vector<Vector3f>& of_group : of_groups)
      of_group.clear();
    for (std::size_t i = 0; i < points.size(); ++i)
      of_groups[static_cast<std::size_t>(group[i])].push_back(points[i]);
    if (std::min(of_groups[0].size(), of_groups[1].size()) < min_plane_points)
      return std::nullopt;
    first = planeOf(of_groups[0]);
    second = planeOf(of_groups[1]);
    bool changed = false;
    for (std::size_t i = 0; i < points.size(); ++i) {
      const char nearer = second.distance(points[i]) < first.distance(points[i]);
      changed = changed || nearer != group[i];
      group[i] = nearer;
    }
    if (!changed)
      break;
  }
  std::optional<CreaseFit> crease = intersection(first, second);
  if (crease) {
    crease->wedge_squares = wedgeSquares(points, first, second);
    for (const Vector3f& point : points) {
      const float distance = std::min(first.distance(point), second.distance(point));
      crease->plane_squares += distance * distance;
    }
  }
  return crease;
}

float
wedgeDeviation(const Patch& patch, const CreaseFit& crease)
{
  return std::sqrt(crease.wedge_squares / static_cast<float>(patch.points.size()));
}

float
planeDeviation(const Patch& patch, const CreaseFit& crease)
{
  return std::sqrt(crease.plane_squares / static_cast<float>(patch.points.size()));
}

float
wedgeOverQuadric(const Patch& patch, const CreaseFit& crease)
{
  const auto count = static_cast<double>(patch.points.size());
  const double floor = count * min_deviation * min_deviation;
  return static_cast<float>(0.5 * count *
                            std::log((quadricSquares(patch.points) + floor) /
                                     (crease.wedge_squares + floor)));
}

} // namespace pcl::segmentation
