// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Votes of points near creases for where these run, and the places that votes agree on.

#include "edges/crease_votes.h"

#include "common/parallel.h"
#include "edges/crease_fit.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace pcl::segmentation {
namespace {

using detail::FieldInput;
using Eigen::Vector3f;

// Evidence is the logarithm of density(edge) / density(surface).
constexpr float candidate_evidence = 0.7f; // twice as likely as not
constexpr float max_evidence = 4.0f;       // 55 to 1: no point alone decides
// Twice the radius of INAD: clean surface on both sides of the edge.
constexpr float fit_spacings = 2.0f, fit_per_noise = 10.0f;
constexpr std::size_t fit_points = 40; // more gave nothing
// Where creases are crowded, that holds more than two planes: then a little more than
// normals need is tried.
constexpr float short_fit_spacings = 1.4f, short_fit_per_noise = 5.0f;
// Spacings, and multiples of the noise: two planes explain no more than a wedge.
constexpr float clear_deviation = 0.1f, clear_noise = 1.3f;
// A smaller fit has fewer points: beyond twice as much it joins faces that do not meet.
constexpr float short_clear = 2.0f;
// Spacings, and multiples of the noise, beyond which two planes do not describe the
// points: as in two sheets.
constexpr float max_plane_deviation = 1.0f / 6.0f, max_plane_noise = 2.0f;
// That a wedge explains a patch better than a smooth surface counts by half, for
// neighbors share points; less 2, which the choice among wedges gains by chance.
constexpr float fit_weight = 0.5f, fit_chance = 2.0f;
// So a fit adds -2 to 4, at most as much as INAD says.
constexpr float min_fit = -2.0f, max_fit = 10.0f;
// Radians. A surface that curves with twice the fit's radius looks like less.
constexpr float min_angle = 0.5f;
constexpr float vote_spacings = 0.6f; // the votes of a crease's band are on one line

/** Finds where the crease next to a candidate runs. */
class CandidateFit {
public:
  CandidateFit(const FieldInput& input,
               const ShapeField& edges,
               float whiteness,
               const PointGrid& grid)
  : input_(input)
  , edges_(edges)
  , whiteness_(whiteness)
  , grid_(grid)
  , reach_(patchSpacings(edges.noise, edges.noise_level))
  , short_reach_(short_fit_spacings +
                 short_fit_per_noise * static_cast<float>(edges.noise_level))
  {}

  /** Without evidence where there is no crease. */
  Vote
  vote(std::size_t candidate, float evidence)
  {
    const std::optional<CreaseFit> crease = clearFit(candidate);
    if (!crease || crease->angle < min_angle || crease->foot.norm() > reach_ ||
        isNoPair(*crease))
      return {};
    const float spacing = edges_.spacings[candidate];
    float weight = std::min(max_evidence, evidence);
    float fit = 0.0f;
    if (whiteness_ > 0.0f) {
      fit = std::clamp(wedgeOverQuadric(patch_, *crease), min_fit, max_fit);
      weight += whiteness_ * fit_weight * (fit - fit_chance);
    }
    return {positionOf(input_.points, candidate) + spacing * crease->foot,
            crease->direction,
            crease->turn,
            std::max(0.0f, weight),
            spacing,
            fit};
  }

private:
  /** Two sheets, or faces of several creases, that two planes do not describe. */
  bool
  isNoPair(const CreaseFit& crease) const
  {
    const float max_deviation = std::max(
        max_plane_deviation, max_plane_noise * static_cast<float>(edges_.noise));
    return whiteness_ > 0.0f && planeDeviation(patch_, crease) > max_deviation;
  }

  /** Within the reach or, if that is no wedge and noise does not explain it, less. */
  std::optional<CreaseFit>
  clearFit(std::size_t candidate)
  {
    findPoints(candidate);
    fillPatch(candidate, reach_);
    std::optional<CreaseFit> crease = fitCrease(patch_);
    const float clear =
        std::max(clear_deviation, clear_noise * static_cast<float>(edges_.noise));
    if (whiteness_ == 0.0f || (crease && wedgeDeviation(patch_, *crease) <= clear))
      return crease;
    std::swap(patch_, wide_);
    fillPatch(candidate, short_reach_);
    const std::optional<CreaseFit> near = fitCrease(patch_);
    if (near && wedgeDeviation(patch_, *near) <= short_clear * clear &&
        (!crease || wedgeDeviation(patch_, *near) < wedgeDeviation(wide_, *crease)))
      return near;
    std::swap(patch_, wide_);
    return crease;
  }

  /** The points around a candidate. */
  void
  findPoints(std::size_t candidate)
  {
    found_.clear();
    grid_.forEachWithin(positionOf(input_.points, candidate),
                        std::max(reach_, short_reach_) * edges_.spacings[candidate],
                        [&](std::uint32_t i, float squared) {
                          found_.push_back({i, squared});
                        });
  }

  /** Some of those that were found, within a reach. */
  void
  fillPatch(std::size_t candidate, float reach)
  {
    patch_.points.clear();
    patch_.normals.clear();
    const float spacing = edges_.spacings[candidate];
    const Vector3f center = positionOf(input_.points, candidate);
    const float radius = reach * spacing;
    const auto isWithin = [squared_radius = radius * radius](const Found& found) {
      return found.squared_distance < squared_radius;
    };
    const auto count =
        static_cast<std::size_t>(std::count_if(found_.begin(), found_.end(), isWithin));
    const std::size_t step = std::max<std::size_t>(1, count / fit_points);
    std::size_t before = step - 1; // so many points of which none was taken
    for (const Found& found : found_) {
      if (!isWithin(found) || ++before < step)
        continue;
      before = 0;
      const Vector3f& normal = edges_.normals[found.point];
      if (normal.allFinite()) {
        patch_.points.emplace_back((positionOf(input_.points, found.point) - center) /
                                   spacing);
        patch_.normals.push_back(normal);
      }
    }
  }

  const FieldInput& input_;
  const ShapeField& edges_;
  float whiteness_;
  const PointGrid& grid_;
  float reach_, short_reach_; ///< spacings
  struct Found {
    std::uint32_t point;
    float squared_distance;
  };
  std::vector<Found> found_;
  Patch patch_, wide_;
};

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
        result.fit += votes[k].fit;
      });
  result.fit /= std::max(count, 1.0f);
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
             float whiteness,
             const PointGrid& grid)
{
  std::vector<std::size_t> candidates;
  for (std::size_t i = 0; i < evidence.size(); ++i)
    if (evidence[i] > candidate_evidence)
      candidates.push_back(i);
  std::vector<Vote> votes(candidates.size());
  kernels::parallelForRanges(
      candidates.size(), input.threads, [&](std::size_t begin, std::size_t end) {
        CandidateFit fit(input, edges, whiteness, grid);
        for (std::size_t v = begin; v < end; ++v)
          votes[v] = fit.vote(candidates[v], evidence[candidates[v]]);
      });
  const auto is_none = [](const Vote& vote) { return vote.evidence == 0.0f; };
  votes.erase(std::remove_if(votes.begin(), votes.end(), is_none), votes.end());
  return votes;
}

std::vector<Agreement>
countVotes(const std::vector<Vote>& votes, float spacing, unsigned threads)
{
  std::vector<Agreement> agreements(votes.size());
  const PointGrid grid(positionsOf(votes), vote_spacings * spacing);
  kernels::parallelForEach(votes.size(), threads, [&](std::size_t i) {
    agreements[i] = agreementAround(votes[i], votes, grid);
  });
  return agreements;
}

} // namespace pcl::segmentation
