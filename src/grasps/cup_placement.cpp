// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// PURPOSE

#include "grasps/cup_placement.h"

#include "common/parallel.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace pcl::segmentation {
namespace {

using Eigen::Vector3f;

// doc/grasps.md has the reason of each number.
constexpr int most_moves = 20;
constexpr float enough_clearance = 2.0f;  // in radii
constexpr float same_direction = 0.7071f; // cosine of 45 degrees

float
clearanceOf(const SuctionGrasp& grasp)
{
  return Clearance{grasp.border_distance, grasp.edge_distance, grasp.obstacle_distance}
      .least(grasp.margin);
}

} // namespace

CupPlacement::CupPlacement(const TargetSurface& target,
                           std::vector<float> weights,
                           std::uint32_t surface,
                           const SuctionCup& cup)
: target_(target)
, weights_(std::move(weights))
, surface_(surface)
, radius_(static_cast<float>(cup.radius))
, most_sag_(static_cast<float>(cup.compliance * cup.radius))
, enough_(enough_clearance * radius_)
{}

std::vector<SuctionGrasp>
CupPlacement::run(unsigned threads) const
{
  const std::vector<Mode> modes = likelihoodModes(target_, weights_, radius_, threads);
  std::vector<std::optional<SuctionGrasp>> places(modes.size());
  kernels::parallelFor(
      modes.size(), threads, [&](std::size_t m) { places[m] = place(modes[m]); });
  std::vector<SuctionGrasp> grasps;
  for (const auto& grasp : places)
    if (grasp)
      grasps.push_back(*grasp);
  return grasps;
}

std::optional<TargetSurface::Point>
CupPlacement::nearestTo(const Mode& mode) const
{
  std::optional<TargetSurface::Point> nearest;
  float least = std::numeric_limits<float>::infinity();
  target_.forEachWithin(
      mode.position, mode.bandwidth, [&](std::uint32_t i, float squared) {
        const auto& point = target_.points()[i];
        if (squared < least && weights_[i] > 0.0f &&
            point.normal.dot(mode.normal) > same_direction) {
          least = squared;
          nearest = point;
        }
      });
  return nearest;
}

std::optional<SuctionGrasp>
CupPlacement::place(const Mode& mode) const
{
  const auto start = nearestTo(mode);
  if (!start)
    return std::nullopt;
  auto fit = fitSurface(target_, start->position, mode.normal, radius_);
  if (!fit)
    return std::nullopt;
  CupMap map(target_, *fit, radius_);
  SuctionGrasp grasp = judged(*fit, map);
  for (int move = 0; move < most_moves && clearanceOf(grasp) < enough_; ++move) {
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
  grasp.moved = (grasp.position - start->position).norm();
  return grasp;
}

SuctionGrasp
CupPlacement::judged(const SurfaceFit& fit, const CupMap& map) const
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
  grasp.sag_allowed = most_sag_ + target_.noise() * fit.spacing;
  grasp.residual = std::sqrt(fit.variance);
  grasp.residual_allowed = toleranceOf(target_.noise(), fit.spacing, radius_).residual;
  grasp.likelihood = likelihoodUnder(fit);
  findProblems(grasp);
  const float free = std::clamp(clearanceOf(grasp) / enough_, 0.0f, 1.0f);
  grasp.score = 0.5f * grasp.likelihood * free + (grasp.seals() ? 0.5f : 0.0f);
  return grasp;
}

void
CupPlacement::findProblems(SuctionGrasp& grasp) const
{
  const auto note = [&](bool is_wrong, SealProblem problem) {
    if (is_wrong)
      grasp.problems.push_back(problem);
  };
  const float beside = radius_ + grasp.margin;
  note(grasp.border_distance < beside, SealProblem::Border);
  note(grasp.edge_distance < radius_, SealProblem::Edge);
  note(grasp.obstacle_distance < beside, SealProblem::Obstacle);
  note(grasp.sag > grasp.sag_allowed, SealProblem::Bent);
  note(grasp.residual > grasp.residual_allowed, SealProblem::Rough);
}

float
CupPlacement::likelihoodUnder(const SurfaceFit& fit) const
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

} // namespace pcl::segmentation
