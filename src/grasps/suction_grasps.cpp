// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Suction grasps on a target: checks of the cup, places for it, ranking.

#include "grasps/suction_grasps.h"

#include "common/number_text.h"
#include "common/statistics.h"
#include "grasps/cup_placement.h"
#include "grasps/mean_shift.h"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace pcl {
namespace {

using namespace segmentation;
using detail::GraspSurface;
using Eigen::Vector3f;

// What matters around a target, in cup radii: more than a cup's map reaches.
constexpr float surroundings = 8.0f;
constexpr double min_spacings = 0.5; // in a cup's radius: below it has no points

/** Likelihoods in the order of the target's points; none on edges and where unknown. */
std::vector<float>
weightsOf(const TargetSurface& target, const GraspSurface& surface)
{
  std::vector<float> weights;
  weights.reserve(target.points().size());
  for (const auto& point : target.points()) {
    const float likelihood = surface.likelihood[point.source];
    weights.push_back(likelihood > 0.0f && !point.is_edge ? likelihood : 0.0f);
  }
  return weights;
}

/** The best first; of those nearer than a radius only the best. */
std::vector<SuctionGrasp>
ranked(std::vector<SuctionGrasp> grasps, float radius)
{
  std::sort(
      grasps.begin(), grasps.end(), [](const SuctionGrasp& a, const SuctionGrasp& b) {
        const Vector3f &p = a.position, &q = b.position;
        return std::make_tuple(-a.score, p.z(), p.y(), p.x(), a.surface) <
               std::make_tuple(-b.score, q.z(), q.y(), q.x(), b.surface);
      });
  std::vector<Place> places;
  places.reserve(grasps.size());
  for (const SuctionGrasp& grasp : grasps)
    places.push_back({grasp.position, grasp.approach});
  const auto representatives = representativesOf(places, radius);
  std::vector<SuctionGrasp> kept;
  for (std::size_t g = 0; g < grasps.size(); ++g)
    if (representatives[g] == g)
      kept.push_back(grasps[g]);
  return kept;
}

} // namespace

const char*
nameOf(SealProblem problem)
{
  switch (problem) {
  case SealProblem::Border:
    return "border";
  case SealProblem::Edge:
    return "edge";
  case SealProblem::Obstacle:
    return "obstacle";
  case SealProblem::Bent:
    return "bent";
  case SealProblem::Rough:
    return "rough";
  }
  return "";
}

namespace detail {

std::string
problemOfCup(const SuctionCup& cup)
{
  if (!(cup.radius > 0.0) || !std::isfinite(cup.radius))
    return "cup radius is " + numberText(cup.radius) +
           " m: it must be positive and finite";
  if (!(cup.compliance >= 0.0 && cup.compliance <= 1.0))
    return "compliance is " + numberText(cup.compliance) + ": it must be 0 to 1";
  return {};
}

std::string
problemOfCup(const SuctionCup& cup, const GraspTarget& target)
{
  if (std::none_of(target.spacings.begin(), target.spacings.end(), [](float spacing) {
        return std::isfinite(spacing);
      }))
    return {};
  const double min_radius = min_spacings * medianSpacing(target.spacings);
  if (cup.radius >= min_radius)
    return {};
  return "cup radius is " + numberText(cup.radius) +
         " m: the points are too sparse for less than " + numberText(min_radius) +
         " m, half their median spacing";
}

std::vector<SuctionGrasp>
findGrasps(const GraspTarget& target,
           const std::vector<GraspSurface>& surfaces,
           const SuctionCup& cup,
           unsigned threads)
{
  const auto radius = static_cast<float>(cup.radius);
  const TargetSurface points(target, surroundings * radius, radius);
  std::vector<SuctionGrasp> grasps;
  for (const GraspSurface& surface : surfaces) {
    const auto found =
        placeCups(points, weightsOf(points, surface), surface.surface, cup, threads);
    grasps.insert(grasps.end(), found.begin(), found.end());
  }
  return ranked(std::move(grasps), radius);
}

} // namespace detail
} // namespace pcl
