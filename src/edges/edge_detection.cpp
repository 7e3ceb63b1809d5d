// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Finds the creases of a cloud: candidates by INAD, votes for where two planes meet.

#include "edges/edge_detection.h"

#include "common/parallel.h"
#include "common/statistics.h"
#include "edges/crease_votes.h"
#include "edges/edge_band.h"
#include "features/class_evidence.h"
#include "features/noise_level.h"
#include "geometry/point_grid.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace pcl::detail {
namespace {

using namespace segmentation;
using Eigen::Vector3f;

// Evidence is the logarithm of density(edge) / density(surface). A crease needs the
// votes of some ten points; noise spreads chance votes, so that it takes more to agree.
constexpr float needed_evidence = 20.0f;
constexpr float needed_per_noise = 5.0f;
// Where the fits of two planes are judged, too, crowded creases can share their voters.
constexpr float needed_less_if_fits_count = 4.0f;

/** How much the fits of two planes count. At the limit of the noise that is measured,
 * it is not known how much of a fit's deviation the noise explains. */
float
whitenessOf(const NoiseLevel& level, double noise)
{
  constexpr double known = 0.25, unknown = 0.3;
  const double trust = std::clamp((unknown - noise) / (unknown - known), 0.0, 1.0);
  return static_cast<float>((1.0 - level.correlation) * trust);
}

/** Sets normals, and gives the evidence at each point. */
std::vector<float>
evidenceOf(const FieldInput& input, const ShapeModel& model, ShapeField& field)
{
  AdaptiveINAD inad = adaptiveINAD(
      input, field.spacings, withNoise(model.parameters(), field.noise_level));
  field.normals = std::move(inad.normals);
  const ShapeEvidence densities(model);
  std::vector<float> evidence(input.points.size);
  kernels::parallelForRanges(
      evidence.size(), input.threads, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
          float logs[2];
          densities.logDensities(inad.mu_sigma[2 * i], inad.mu_sigma[2 * i + 1], logs);
          evidence[i] = logs[0] - logs[1];
        }
      });
  return evidence;
}

/** Points near an agreement take its likelihood, evidence / (evidence + needed). */
void
markBands(const std::vector<Agreement>& agreements,
          float whiteness,
          const PointGrid& grid,
          ShapeField& field)
{
  const auto noise = static_cast<float>(field.noise_level);
  const float band = edgeBand(field.noise_level);
  const float needed = (needed_evidence - needed_less_if_fits_count * whiteness) *
                       (1.0f + needed_per_noise * noise);
  for (const Agreement& agreement : agreements) {
    const Vector3f center = Eigen::Map<const Vector3f>(agreement.point.position.data());
    const float likelihood = agreement.evidence / (agreement.evidence + needed);
    grid.forEachWithin(
        center, band * agreement.point.spacing, [&](std::uint32_t i, float) {
          if (!(field.edge_likelihood[i] >= likelihood))
            field.edge_likelihood[i] = likelihood;
        });
    if (agreement.evidence >= needed)
      field.creases.push_back(agreement.point);
  }
}

} // namespace

void
findEdges(const FieldInput& input, const ShapeModel& model, ShapeField& field)
{
  const CloudNumbers* const of_cloud = input.of_cloud;
  field.spacings =
      of_cloud ? localSpacings(input.neighborhoods, input.points.size, *of_cloud)
               : localSpacings(input.neighborhoods, input.points.size, input.is_even);
  const Bounds bounds = boundsOf(input);
  const float spacing = of_cloud ? of_cloud->spacing : median(field.spacings);
  const PointGrid grid(input.points, 2.0f * spacing, bounds);
  field.noise =
      of_cloud ? of_cloud->noise : noiseOf(input.neighborhoods, field.spacings);
  // Of normals of one's own it is not known which noise is left in them.
  const NoiseLevel noise =
      of_cloud ? NoiseLevel{of_cloud->noise_level, of_cloud->noise_correlation}
      : input.normals.size > 0
          ? NoiseLevel{field.noise, 1.0}
          : noiseLevelOf(input.neighborhoods, field.spacings, field.noise, grid);
  field.noise_level = noise.level;
  const std::vector<float> evidence = evidenceOf(input, model, field);
  field.edge_likelihood.reserve(evidence.size());
  for (const float e : evidence)
    field.edge_likelihood.push_back(
        std::isnan(e) ? std::numeric_limits<float>::quiet_NaN() : 0.0f);

  const float whiteness = whitenessOf(noise, field.noise);
  const std::vector<Vote> votes = collectVotes(input, field, evidence, whiteness, grid);
  markBands(countVotes(votes, spacing, bounds, input.threads), whiteness, grid, field);
}

} // namespace pcl::detail
