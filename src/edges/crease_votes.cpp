// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Votes of points near creases for where these run, and the places that votes agree on.

#include "edges/crease_votes.h"

#include "common/parallel.h"
#include "geometry/principal_axes.h"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <optional>

namespace pcl::segmentation {
namespace {

using detail::FieldInput;
using Eigen::Matrix3f;
using Eigen::Vector3f;

// Evidence is the logarithm of density(edge) / density(surface).
constexpr float candidate_evidence = 0.7f; // twice as likely as not
constexpr float max_evidence = 4.0f;       // 55 to 1: no point alone decides
// Twice the radius of INAD: clean surface on both sides of the edge.
constexpr float fit_spacings = 2.0f, fit_per_noise = 10.0f;
constexpr std::size_t fit_points = 40; // more gave nothing
constexpr int normal_rounds = 3;       // they only give the planes a start
constexpr int plane_rounds = 5;        // few neighborhoods change after that
constexpr int min_plane_points = 5;    // fewer are no plane, as for normals
constexpr float parallel = 0.05f;      // sine, 3 degrees: the line is anywhere
// Radians. A surface that curves with twice the fit's radius looks like less.
constexpr float min_angle = 0.5f;
constexpr float vote_spacings = 0.6f; // the votes of a crease's band are on one line
constexpr float half_turn = 3.14159265f;

/** A neighborhood about its center in units of the spacing there. */
struct Patch {
  std::vector<Vector3f> points;
  std::vector<Vector3f> normals; ///< unit, of either sign
};

/** The line where the two planes of a patch meet. */
struct CreaseFit {
  Vector3f foot;      ///< the point nearest to the center
  Vector3f direction; ///< unit
  float angle = 0.0f; ///< between the planes' normals, 0 to pi/2
  float turn = 0.0f;  ///< by which the surface turns there, 0 to pi
};

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
  Matrix3f all = Matrix3f::Zero();
  for (const Vector3f& n : normals)
    all += n * n.transpose();
  Vector3f first = farthestFrom(principalAxis(all, 2), normals);
  Vector3f second = farthestFrom(first, normals);
  std::vector<char> group(normals.size());
  for (int round = 0; round < normal_rounds; ++round) {
    Matrix3f of_first = Matrix3f::Zero(), of_second = Matrix3f::Zero();
    for (std::size_t i = 0; i < normals.size(); ++i) {
      group[i] = std::abs(normals[i].dot(second)) > std::abs(normals[i].dot(first));
      (group[i] ? of_second : of_first) += normals[i] * normals[i].transpose();
    }
    first = principalAxis(of_first, 2);
    second = principalAxis(of_second, 2);
  }
  return group;
}

Plane<float>
planeOf(const std::vector<Vector3f>& points, const std::vector<char>& group, char which)
{
  return fitPlane<float>([&](const auto& visit) {
    for (std::size_t i = 0; i < points.size(); ++i)
      if (group[i] == which)
        visit(points[i]);
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

/** Fit two planes by turns: each point to the nearer plane, each plane to its points
 * (k-planes, after Bradley and Mangasarian, "k-Plane Clustering", 2000). */
std::optional<CreaseFit>
fitCrease(const Patch& patch)
{
  const std::vector<Vector3f>& points = patch.points;
  if (points.size() < 2 * min_plane_points)
    return std::nullopt;
  std::vector<char> group = groupNormals(patch.normals);
  Plane<float> first, second;
  for (int round = 0; round < plane_rounds; ++round) {
    if (std::count(group.begin(), group.end(), 0) < min_plane_points ||
        std::count(group.begin(), group.end(), 1) < min_plane_points)
      return std::nullopt;
    first = planeOf(points, group, 0);
    second = planeOf(points, group, 1);
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

/** Some of the points that were found around a candidate. */
void
fillPatch(const FieldInput& input,
          const ShapeField& edges,
          const std::vector<std::uint32_t>& found,
          std::size_t center,
          Patch& patch)
{
  patch.points.clear();
  patch.normals.clear();
  const std::size_t step = std::max<std::size_t>(1, found.size() / fit_points);
  const Vector3f origin = positionOf(input.points, center);
  for (std::size_t k = 0; k < found.size(); k += step) {
    const Vector3f normal = edges.normals[found[k]];
    if (normal.allFinite()) {
      patch.points.emplace_back((positionOf(input.points, found[k]) - origin) /
                                edges.spacings[center]);
      patch.normals.push_back(normal);
    }
  }
}

Agreement
agreementAround(const Vote& vote, const std::vector<Vote>& votes, const PointGrid& grid)
{
  Vector3f sum = Vector3f::Zero();
  float count = 0.0f;
  Agreement result;
  grid.forEachWithin(
      vote.position, vote_spacings * vote.spacing, [&](std::uint32_t k, float) {
        sum += votes[k].position - vote.position;
        count += 1.0f;
        result.evidence += votes[k].evidence;
      });
  const Vector3f mean = vote.position + sum / std::max(count, 1.0f);
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

float
patchSpacings(double noise, double noise_level)
{
  // A little wider than normals need: the planes are to give the angle, too.
  constexpr double of_thickness = 0.25;
  return fitSpacings(noise_level + of_thickness * (noise - noise_level));
}

float
agreementSpacings()
{
  return vote_spacings;
}

std::vector<Vote>
collectVotes(const FieldInput& input,
             const ShapeField& edges,
             const std::vector<float>& evidence,
             const PointGrid& grid)
{
  std::vector<std::size_t> candidates;
  for (std::size_t i = 0; i < evidence.size(); ++i)
    if (evidence[i] > candidate_evidence)
      candidates.push_back(i);
  const float reach = patchSpacings(edges.noise, edges.noise_level);
  std::vector<Vote> votes(candidates.size());
  kernels::parallelForRanges(
      candidates.size(), input.threads, [&](std::size_t begin, std::size_t end) {
        std::vector<std::uint32_t> found;
        Patch patch;
        for (std::size_t v = begin; v < end; ++v) {
          const std::size_t i = candidates[v];
          const float spacing = edges.spacings[i];
          const Vector3f center = positionOf(input.points, i);
          found.clear();
          grid.forEachWithin(center, reach * spacing, [&](std::uint32_t j, float) {
            found.push_back(j);
          });
          fillPatch(input, edges, found, i, patch);
          const auto crease = fitCrease(patch);
          if (crease && crease->angle >= min_angle && crease->foot.norm() <= reach)
            votes[v] = {center + spacing * crease->foot,
                        crease->direction,
                        crease->turn,
                        std::min(max_evidence, evidence[i]),
                        spacing};
        }
      });
  const auto is_none = [](const Vote& vote) { return vote.evidence == 0.0f; };
  votes.erase(std::remove_if(votes.begin(), votes.end(), is_none), votes.end());
  return votes;
}

std::vector<Agreement>
countVotes(const std::vector<Vote>& votes,
           float spacing,
           const Bounds& bounds,
           unsigned threads)
{
  std::vector<Agreement> agreements(votes.size());
  const PointGrid grid(positionsOf(votes), vote_spacings * spacing, bounds);
  kernels::parallelForEach(votes.size(), threads, [&](std::size_t i) {
    agreements[i] = agreementAround(votes[i], votes, grid);
  });
  return agreements;
}

} // namespace pcl::segmentation
