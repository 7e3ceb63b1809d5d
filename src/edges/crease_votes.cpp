// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// PURPOSE

#include "edges/crease_votes.h"

#include "common/parallel.h"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>

#include <algorithm>
#include <cmath>

namespace pcl::segmentation {
namespace {

using Eigen::Matrix3f;
using Eigen::Vector3f;
using Vectors = std::vector<Vector3f>;

constexpr int normal_rounds = 3; // they only give the planes a start
constexpr int plane_rounds = 5;  // few neighborhoods change after that
constexpr int least_points = 5;
constexpr float parallel = 0.05f; // sine
constexpr float half_turn = 3.14159265f;

struct Plane {
  Vector3f center = Vector3f::Zero();
  Vector3f normal = Vector3f::Zero();
  int points = 0;

  float
  distance(const Vector3f& point) const
  {
    return std::abs(normal.dot(point - center));
  }
};

/** The eigenvector of the smallest (0) or largest (2) eigenvalue. */
Vector3f
eigenvector(const Matrix3f& matrix, int which)
{
  Eigen::SelfAdjointEigenSolver<Matrix3f> solver;
  solver.computeDirect(matrix);
  return solver.eigenvectors().col(which);
}

/** The normal that differs most from a direction. */
Vector3f
farthestFrom(const Vector3f& direction, const Vectors& normals)
{
  return *std::min_element(
      normals.begin(), normals.end(), [&](const Vector3f& a, const Vector3f& b) {
        return std::abs(a.dot(direction)) < std::abs(b.dot(direction));
      });
}

/** Which of two groups each normal is in. */
std::vector<char>
groupNormals(const Vectors& normals)
{
  Matrix3f all = Matrix3f::Zero();
  for (const Vector3f& n : normals)
    all += n * n.transpose();
  Vector3f first = farthestFrom(eigenvector(all, 2), normals);
  Vector3f second = farthestFrom(first, normals);
  std::vector<char> group(normals.size());
  for (int round = 0; round < normal_rounds; ++round) {
    Matrix3f of_first = Matrix3f::Zero(), of_second = Matrix3f::Zero();
    for (std::size_t i = 0; i < normals.size(); ++i) {
      group[i] = std::abs(normals[i].dot(second)) > std::abs(normals[i].dot(first));
      (group[i] ? of_second : of_first) += normals[i] * normals[i].transpose();
    }
    first = eigenvector(of_first, 2);
    second = eigenvector(of_second, 2);
  }
  return group;
}

Plane
planeOf(const Vectors& points, const std::vector<char>& group, char which)
{
  Plane plane;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (group[i] == which) {
      plane.center += points[i];
      ++plane.points;
    }
  }
  if (plane.points < least_points)
    return plane;
  plane.center /= static_cast<float>(plane.points);
  Matrix3f covariance = Matrix3f::Zero();
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Vector3f d = points[i] - plane.center;
    if (group[i] == which)
      covariance += d * d.transpose();
  }
  plane.normal = eigenvector(covariance, 0);
  return plane;
}

std::optional<CreaseFit>
intersection(const Plane& a, const Plane& b)
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

} // namespace

std::optional<CreaseFit>
fitCrease(const Vectors& points, const Vectors& normals)
{
  if (points.size() < 2 * least_points)
    return std::nullopt;
  std::vector<char> group = groupNormals(normals);
  Plane first, second;
  for (int round = 0; round < plane_rounds; ++round) {
    first = planeOf(points, group, 0);
    second = planeOf(points, group, 1);
    if (first.points < least_points || second.points < least_points)
      return std::nullopt;
    bool changed = false;
    for (std::size_t i = 0; i < points.size(); ++i) {
      const char nearer = second.distance(points[i]) < first.distance(points[i]);
      changed = changed || nearer != group[i];
      group[i] = nearer;
    }
    if (!changed)
      break;
  }
  return intersection(first, second);
}

namespace {

using detail::FieldInput;
using Eigen::Vector3f;

// Evidence is the logarithm of density(edge) / density(surface). doc/method.md has the
// reason of each number.
constexpr float candidate_evidence = 0.7f; // twice as likely as not
constexpr float most_evidence = 4.0f;      // no point alone decides
constexpr float fit_spacings = 2.0f, fit_per_noise = 10.0f;
constexpr std::size_t fit_points = 40;
constexpr float least_angle = 0.5f; // radians
constexpr float vote_spacings = 0.6f;

/** The neighborhood of a candidate in units of its spacing, thinned out. */
void
collect(const FieldInput& input,
        const ShapeField& edges,
        const std::vector<std::uint32_t>& found,
        std::size_t center,
        std::vector<Vector3f>& points,
        std::vector<Vector3f>& normals)
{
  points.clear();
  normals.clear();
  const std::size_t step = std::max<std::size_t>(1, found.size() / fit_points);
  const Vector3f origin = positionOf(input.points, center);
  for (std::size_t k = 0; k < found.size(); k += step) {
    const Vector3f normal =
        edges.normals[std::size_t{found[k]}];
    if (normal.allFinite()) {
      points.emplace_back((positionOf(input.points, found[k]) - origin) /
                          edges.spacings[center]);
      normals.push_back(normal);
    }
  }
}

std::vector<std::size_t>
candidates(const std::vector<float>& evidence)
{
  std::vector<std::size_t> chosen;
  for (std::size_t i = 0; i < evidence.size(); ++i)
    if (evidence[i] > candidate_evidence)
      chosen.push_back(i);
  return chosen;
}

Agreement
agreementAround(const Vote& vote, const std::vector<Vote>& votes, const PointGrid& feet)
{
  Vector3f sum = Vector3f::Zero();
  float count = 0.0f;
  Agreement result;
  feet.forEachWithin(
      vote.foot, vote_spacings * vote.spacing, [&](std::uint32_t k, float) {
        sum += votes[k].foot - vote.foot;
        count += 1.0f;
        result.evidence += votes[k].evidence;
      });
  const Vector3f mean = vote.foot + sum / std::max(count, 1.0f);
  result.point = {{mean.x(), mean.y(), mean.z()},
                  {vote.direction.x(), vote.direction.y(), vote.direction.z()},
                  vote.angle,
                  vote.spacing};
  return result;
}

} // namespace

float
fitSpacings(double noise)
{
  return fit_spacings + fit_per_noise * static_cast<float>(noise);
}

std::vector<Vote>
collectVotes(const FieldInput& input,
             const ShapeField& edges,
             const std::vector<float>& evidence,
             const PointGrid& grid)
{
  const std::vector<std::size_t> chosen = candidates(evidence);
  const float reach = fitSpacings(edges.noise);
  std::vector<Vote> votes(chosen.size());
  kernels::parallelForRanges(
      chosen.size(), input.threads, [&](std::size_t begin, std::size_t end) {
        std::vector<std::uint32_t> found;
        std::vector<Vector3f> points, normals;
        for (std::size_t v = begin; v < end; ++v) {
          const std::size_t i = chosen[v];
          const float spacing = edges.spacings[i];
          const Vector3f center = positionOf(input.points, i);
          found.clear();
          grid.forEachWithin(center, reach * spacing, [&](std::uint32_t j, float) {
            found.push_back(j);
          });
          collect(input, edges, found, i, points, normals);
          const auto crease = fitCrease(points, normals);
          if (crease && crease->angle >= least_angle && crease->foot.norm() <= reach)
            votes[v] = {center + spacing * crease->foot,
                        crease->direction,
                        crease->turn,
                        std::min(most_evidence, evidence[i]),
                        spacing};
        }
      });
  votes.erase(std::remove_if(votes.begin(),
                             votes.end(),
                             [](const Vote& v) { return v.evidence == 0.0f; }),
              votes.end());
  return votes;
}

std::vector<Agreement>
countVotes(const std::vector<Vote>& votes, float spacing, unsigned threads)
{
  std::vector<Agreement> agreements(votes.size());
  if (votes.empty())
    return agreements;
  const XYZView feet{votes[0].foot.data(), sizeof(Vote) / sizeof(float), votes.size()};
  const PointGrid grid(feet, vote_spacings * spacing);
  kernels::parallelForRanges(
      votes.size(), threads, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i)
          agreements[i] = agreementAround(votes[i], votes, grid);
      });
  return agreements;
}

} // namespace pcl::segmentation
