/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * Point Cloud Library (PCL) - www.pointclouds.org
 * Copyright (c) 2026, pcl_shape contributors
 *
 * All rights reserved
 */

#include "crease_votes.h"

#include "../kernels/parallel.h"
#include "crease_fit.h"

#include <algorithm>

namespace pcl::segmentation {
namespace {

using detail::AdaptiveEdges;
using detail::AdaptiveInput;
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
collect(const AdaptiveInput& input,
        const AdaptiveEdges& edges,
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
        Eigen::Map<const Vector3f>(&edges.normals[3 * std::size_t{found[k]}]);
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
collectVotes(const AdaptiveInput& input,
             const AdaptiveEdges& edges,
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
