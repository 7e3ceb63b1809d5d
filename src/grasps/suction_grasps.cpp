// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// PURPOSE

#include "common/number_text.h"
#include "grasps/cup_placement.h"
#include "grasps/mean_shift.h"

#include "grasps/suction_grasps.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <tuple>

namespace pcl {
namespace {

using namespace segmentation;
using detail::GraspSurface;
using Eigen::Vector3f;

// doc/grasps.md has the reason of each number.
constexpr float surroundings = 8.0f; // that matter around a target, in cup radii
constexpr double least_radius = 0.5; // in spacings

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
    return "cup radius is " + detail::numberText(cup.radius) +
           " m: it must be positive and finite";
  return cup.compliance >= 0.0 && cup.compliance <= 1.0
             ? std::string()
             : "compliance is " + detail::numberText(cup.compliance) +
                   ": 0 to 1 is allowed";
}

std::string
problemOfCup(const SuctionCup& cup, const GraspTarget& target)
{
  std::vector<float> spacings;
  std::copy_if(target.spacings.begin(),
               target.spacings.end(),
               std::back_inserter(spacings),
               [](float spacing) { return std::isfinite(spacing); });
  if (spacings.empty())
    return {};
  const auto middle =
      spacings.begin() + static_cast<std::ptrdiff_t>(spacings.size() / 2);
  std::nth_element(spacings.begin(), middle, spacings.end());
  const double least = least_radius * *middle;
  return cup.radius >= least
             ? std::string()
             : "cup radius is " + detail::numberText(cup.radius) +
                   " m: the points are too sparse for less than " +
                   detail::numberText(least) + " m, half their median spacing";
}

std::vector<SuctionGrasp>
findGrasps(const GraspTarget& target,
           const std::vector<GraspSurface>& surfaces,
           const SuctionCup& cup,
           unsigned threads)
{
  const auto radius = static_cast<float>(cup.radius);
  const TargetSurface of(target, surroundings * radius, radius);
  std::vector<SuctionGrasp> grasps;
  for (const GraspSurface& surface : surfaces) {
    const auto found =
        CupPlacement(of, weightsOf(of, surface), surface.surface, cup).run(threads);
    grasps.insert(grasps.end(), found.begin(), found.end());
  }
  return ranked(std::move(grasps), radius);
}

} // namespace detail
} // namespace pcl
