// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// From the modes of a likelihood to places where a suction cup fits.

#include "grasps/cup_placement.h"

#include "common/parallel.h"
#include "grasps/cup_map.h"
#include "grasps/mean_shift.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

namespace pcl::segmentation {
namespace {

constexpr int max_moves = 20; // of a cup: it ends before, where it gains no more
constexpr float enough_clearance = 2.0f; // in radii: as far as it is measured

// In radii: where a cup is bent, one place in each cell of this size is tried instead.
// Cups in neighboring cells have most of their surface in common.
constexpr float place_cell = 0.5f;

float
clearanceOf(const SuctionGrasp& grasp)
{
  return Clearance{grasp.border_distance, grasp.edge_distance, grasp.obstacle_distance}
      .smallest(grasp.margin);
}

/** The surface, not what is on it or around it, keeps the cup from sealing. */
bool
isMisshapen(const SuctionGrasp& grasp)
{
  return std::any_of(
      grasp.problems.begin(), grasp.problems.end(), [](SealProblem problem) {
        return problem == SealProblem::Bent || problem == SealProblem::Rough;
      });
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

  /** From a mode to where the cup fits: uphill to the greatest clearance, and if the
   * surface there is too bent, to a flatter place. */
  std::optional<SuctionGrasp>
  place(const Mode& mode) const
  {
    const auto start = nearestTo(mode);
    if (!start)
      return std::nullopt;
    auto first = candidateOn(fitSurface(target_, *start, mode.normal, radius_));
    if (!first)
      return std::nullopt;
    SuctionGrasp grasp = moved(std::move(*first));
    if (isMisshapen(grasp))
      if (auto flatter = flatterPlace(mode))
        grasp = moved(std::move(*flatter));
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

  /** A cup's place, and what is there. */
  struct Candidate {
    SurfaceFit fit;
    CupMap map;
    SuctionGrasp grasp;
  };

  std::optional<Candidate>
  candidateOn(const std::optional<SurfaceFit>& fit) const
  {
    if (!fit)
      return std::nullopt;
    const CupMap map(target_, *fit, radius_);
    return Candidate{*fit, map, judged(*fit, map)};
  }

  /** Uphill to the greatest clearance. */
  SuctionGrasp
  moved(Candidate from) const
  {
    for (int move = 0; move < max_moves && clearanceOf(from.grasp) < enough_; ++move) {
      const Eigen::Vector2f to = from.map.clearestPlace();
      if (to.isZero())
        break;
      auto next = candidateOn(
          fitSurface(target_, from.fit.at(to.x(), to.y()), from.fit.normal(), radius_));
      if (!next || clearanceOf(next->grasp) <= clearanceOf(from.grasp) ||
          (from.grasp.seals() && !next->grasp.seals()))
        break;
      from = std::move(*next);
    }
    return from.grasp;
  }

  /** Of the places within a mode's window the best one that seals, if there is one: a
   * mode is in the middle of what is likely, not where a body of uneven curvature is
   * flattest. */
  std::optional<Candidate>
  flatterPlace(const Mode& mode) const
  {
    std::optional<Candidate> best;
    for (const std::uint32_t i : placesWithin(mode)) {
      const auto& point = target_.points()[i];
      const auto fit = fitSurface(target_, point.position, point.normal, radius_);
      if (!fit || !isShapedFor(*fit))
        continue;
      auto candidate = candidateOn(fit);
      if (candidate->grasp.seals() &&
          (!best || candidate->grasp.score > best->grasp.score))
        best = std::move(candidate);
    }
    return best;
  }

  /** Likely points within a mode's window that face its way, one for each cell. */
  std::vector<std::uint32_t>
  placesWithin(const Mode& mode) const
  {
    const float cell = place_cell * radius_;
    std::map<std::array<int, 3>, std::uint32_t> first; // as points are sorted
    target_.forEachWithin(mode.position, mode.bandwidth, [&](std::uint32_t i, float) {
      const auto& point = target_.points()[i];
      if (!(weights_[i] > 0.0f) || point.normal.dot(mode.normal) < same_direction)
        return;
      const Eigen::Vector3f of =
          ((point.position - mode.position) / cell).array().floor();
      const std::array<int, 3> key{
          static_cast<int>(of.x()), static_cast<int>(of.y()), static_cast<int>(of.z())};
      const auto at = first.try_emplace(key, i).first;
      at->second = std::min(at->second, i);
    });
    std::vector<std::uint32_t> places;
    for (const auto& [key, i] : first)
      places.push_back(i);
    return places;
  }

  /** What the lip gives way by, and what noise adds: neighbors share it, so that the
   * sag is off by about as much as points are. The noise of the cloud lacks waves that
   * are longer than its neighborhoods, and of a camera these are most of it. */
  float
  allowedSag(const SurfaceFit& fit) const
  {
    const float short_waves = target_.noise() * fit.spacing;
    const float all_waves = std::min(std::sqrt(fit.variance), allowedResidual(fit));
    return max_sag_ + std::max(short_waves, all_waves);
  }

  float
  allowedResidual(const SurfaceFit& fit) const
  {
    return toleranceOf(target_.noise(), fit.spacing, radius_).residual;
  }

  bool
  isShapedFor(const SurfaceFit& fit) const
  {
    return fit.sag(radius_) <= allowedSag(fit) &&
           std::sqrt(fit.variance) <= allowedResidual(fit);
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
    grasp.sag_allowed = allowedSag(fit);
    grasp.residual = std::sqrt(fit.variance);
    grasp.residual_allowed = allowedResidual(fit);
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
