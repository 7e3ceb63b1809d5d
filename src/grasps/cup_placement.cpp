// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// From the modes of a likelihood to places where a suction cup fits.

#include "grasps/cup_placement.h"

#include "common/parallel.h"
#include "grasps/cup_map.h"
#include "grasps/mean_shift.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace pcl::segmentation {
namespace {

constexpr int max_moves = 20; // of a cup: it ends before, where it gains no more
constexpr float enough_clearance = 2.0f; // in radii: as far as it is measured

float
clearanceOf(const SuctionGrasp& grasp)
{
  return Clearance{grasp.border_distance, grasp.edge_distance, grasp.obstacle_distance}
      .smallest(grasp.margin);
}

class CupPlacement {
public:
  CupPlacement(const TargetSurface& target,
               const std::vector<float>& weights,
               std::uint32_t surface,
               const SuctionCup& cup)
  : target_(target)
  , weights_(weights)
  , surface_(surface)
  , radius_(static_cast<float>(cup.radius))
  , max_sag_(static_cast<float>(cup.compliance * cup.radius))
  , enough_(enough_clearance * radius_)
  {}

  /** From a mode to where the cup fits: uphill to the greatest clearance. */
  std::optional<SuctionGrasp>
  place(const Mode& mode) const
  {
    const auto start = nearestTo(mode);
    if (!start)
      return std::nullopt;
    auto fit = fitSurface(target_, *start, mode.normal, radius_);
    if (!fit)
      return std::nullopt;
    CupMap map(target_, *fit, radius_);
    SuctionGrasp grasp = judged(*fit, map);
    for (int move = 0; move < max_moves && clearanceOf(grasp) < enough_; ++move) {
      const Eigen::Vector2f to = map.clearestPlace();
      if (to.isZero())
        break;
      fit = fitSurface(target_, fit->at(to.x(), to.y()), fit->normal(), radius_);
      if (!fit)
        break;
      map = CupMap(target_, *fit, radius_);
      SuctionGrasp moved = judged(*fit, map);
      if (clearanceOf(moved) <= clearanceOf(grasp) || (grasp.seals() && !moved.seals()))
        break;
      grasp = std::move(moved);
    }
    grasp.starts = mode.starts;
    grasp.iterations = mode.iterations;
    grasp.converged = mode.converged;
    grasp.bandwidth = mode.bandwidth;
    grasp.moved = (grasp.position - *start).norm();
    return grasp;
  }

private:
  /** The point of the surface next to a mode. */
  std::optional<Eigen::Vector3f>
  nearestTo(const Mode& mode) const
  {
    std::optional<Eigen::Vector3f> nearest;
    float smallest = std::numeric_limits<float>::infinity();
    target_.forEachWithin(
        mode.position, mode.bandwidth, [&](std::uint32_t i, float squared) {
          const auto& point = target_.points()[i];
          if (squared < smallest && weights_[i] > 0.0f &&
              point.normal.dot(mode.normal) > same_direction) {
            smallest = squared;
            nearest = point.position;
          }
        });
    return nearest;
  }

  SuctionGrasp
  judged(const SurfaceFit& fit, const CupMap& map) const
  {
    SuctionGrasp grasp;
    const Clearance clearance = map.at(0.0f, 0.0f);
    grasp.position = fit.origin;
    grasp.approach = -fit.normal();
    grasp.surface = surface_;
    grasp.margin = map.margin();
    grasp.covered = map.covered(radius_ + map.margin());
    grasp.border_distance = clearance.border;
    grasp.edge_distance = clearance.edge;
    grasp.obstacle_distance = clearance.obstacle;
    grasp.sag = fit.sag(radius_);
    grasp.sag_allowed = max_sag_ + target_.noise() * fit.spacing;
    grasp.residual = std::sqrt(fit.variance);
    grasp.residual_allowed =
        toleranceOf(target_.noise(), fit.spacing, radius_).residual;
    const auto note = [&](bool is_wrong, SealProblem problem) {
      if (is_wrong)
        grasp.problems.push_back(problem);
    };
    const float with_margin = radius_ + grasp.margin;
    note(grasp.border_distance < with_margin, SealProblem::Border);
    note(grasp.edge_distance < radius_, SealProblem::Edge);
    note(grasp.obstacle_distance < with_margin, SealProblem::Obstacle);
    note(grasp.sag > grasp.sag_allowed, SealProblem::Bent);
    note(grasp.residual > grasp.residual_allowed, SealProblem::Rough);
    grasp.likelihood = likelihoodUnder(fit);
    const float free = std::clamp(clearanceOf(grasp) / enough_, 0.0f, 1.0f);
    grasp.score = 0.5f * grasp.likelihood * free + (grasp.seals() ? 0.5f : 0.0f);
    return grasp;
  }

  float
  likelihoodUnder(const SurfaceFit& fit) const
  {
    double sum = 0.0;
    std::size_t count = 0;
    target_.forEachWithin(fit.origin, radius_, [&](std::uint32_t i, float) {
      if (target_.points()[i].normal.dot(fit.axes.col(2)) > same_direction) {
        sum += weights_[i];
        ++count;
      }
    });
    return count > 0 ? static_cast<float>(sum / static_cast<double>(count)) : 0.0f;
  }

  const TargetSurface& target_;
  const std::vector<float>& weights_;
  std::uint32_t surface_;
  float radius_;
  float max_sag_;
  float enough_; ///< clearance
};

} // namespace

std::vector<SuctionGrasp>
placeCups(const TargetSurface& target,
          const std::vector<float>& weights,
          std::uint32_t surface,
          const SuctionCup& cup,
          unsigned threads)
{
  const CupPlacement placement(target, weights, surface, cup);
  const std::vector<Mode> modes =
      likelihoodModes(target, weights, static_cast<float>(cup.radius), threads);
  std::vector<std::optional<SuctionGrasp>> places(modes.size());
  kernels::parallelFor(modes.size(), threads, [&](std::size_t m) {
    places[m] = placement.place(modes[m]);
  });
  std::vector<SuctionGrasp> grasps;
  for (const auto& grasp : places)
    if (grasp)
      grasps.push_back(*grasp);
  return grasps;
}

} // namespace pcl::segmentation
