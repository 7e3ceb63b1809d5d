// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Finds the creases of a cloud: candidates by INAD, votes for where two planes meet.

#include "edges/edge_detection.h"

#include "edges/crease_continuation.h"
#include "edges/crease_votes.h"
#include "features/models/class_evidence.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

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

/** Sets normals, and gives the evidence at each point. */
std::vector<float>
evidenceOf(const FieldInput& input, const ShapeEvidence& densities, ShapeField& field)
{
  AdaptiveINAD inad = adaptiveINAD(
      input, field.spacings, withNoise(densities.parameters(), field.noise_level));
  field.normals = std::move(inad.normals);
  return densities.firstOverSecond(inad.mu_sigma, input.threads);
}

float
neededEvidence(float whiteness, double noise_level)
{
  return (needed_evidence - needed_less_if_fits_count * whiteness) *
         (1.0f + needed_per_noise * static_cast<float>(noise_level));
}

/** What is enough where a crease is expected, if the fits of two planes say that it is
 * no smooth surface. The noise that neighbors share lies in lines, too. */
float
faintEvidence(float needed, float whiteness)
{
  constexpr float of_needed = 1.0f / 3.0f; // three to one, the most that Canny has
  return (1.0f - (1.0f - of_needed) * whiteness) * needed;
}

std::vector<CreasePoint>
creasesAmong(const std::vector<Agreement>& agreements, float needed)
{
  std::vector<CreasePoint> creases;
  for (const Agreement& agreement : agreements)
    if (agreement.evidence >= needed)
      creases.push_back(agreement.point);
  return creases;
}

// A crease of sparse points, such as strays in a shadow, is no band of the dense ones
// beside them. On a foot of an object that is seen at a grazing angle it is: with 1.4
// instead of 2, bands had gaps there.
constexpr float most_of_own = 2.0f;

/** Points near an agreement, in spacings of both, take its likelihood, evidence /
 * (evidence + needed). */
void
markBands(const std::vector<Agreement>& agreements,
          float needed,
          const PointGrid& grid,
          ShapeField& field)
{
  const float band = edgeBand(field.noise_level);
  for (const Agreement& agreement : agreements) {
    const Vector3f center = Eigen::Map<const Vector3f>(agreement.point.position.data());
    const float likelihood = agreement.evidence / (agreement.evidence + needed);
    grid.forEachWithin(
        center, band * agreement.point.spacing, [&](std::uint32_t i, float squared) {
          const float own = band * most_of_own * field.spacings[i];
          if (squared < own * own && !(field.edge_likelihood[i] >= likelihood))
            field.edge_likelihood[i] = likelihood;
        });
  }
}

PointGrid
gridOf(const FieldInput& input, const MeasuredCloud& measured)
{
  return {input.points, 2.0f * measured.spacing, input.threads};
}

std::vector<Agreement>
agreementsOf(const FieldInput& input,
             const MeasuredCloud& measured,
             const PointGrid& grid,
             float whiteness,
             const ShapeEvidence& densities,
             ShapeField& field)
{
  const std::vector<float> evidence = evidenceOf(input, densities, field);
  field.edge_likelihood.reserve(evidence.size());
  for (const float e : evidence)
    field.edge_likelihood.push_back(
        std::isnan(e) ? std::numeric_limits<float>::quiet_NaN() : 0.0f);
  const std::vector<Vote> votes = collectVotes(input, field, evidence, whiteness, grid);
  return countVotes(votes, measured.spacing, input.threads);
}

std::vector<CreasePoint>
creasesOfNextLevel(const FieldInput& input,
                   const MeasuredCloud& measured,
                   const ShapeEvidence& densities,
                   double noise)
{
  MeansOfCloud means = meansOfCloud(input, measured, noise);
  const FieldInput of_means{*means.neighborhoods, means.points, {}, input.threads};
  constexpr float whiteness = 0.0f;
  return creasesAmong(agreementsOf(of_means,
                                   means.measured,
                                   gridOf(of_means, means.measured),
                                   whiteness,
                                   densities,
                                   means.field),
                      neededEvidence(whiteness, means.field.noise_level));
}

/** True edges of a level are edges of the next one, the steps of a sensor are not.
 * Where the noise may be white, its edges count, too. */
void
weakenWhatDoesNotPersist(const std::vector<CreasePoint>& next,
                         const MeasuredCloud& measured,
                         std::vector<Agreement>& agreements)
{
  const PointGrid creases(positionsOf(next), 2.0f * measured.spacing);
  const auto left = static_cast<float>(1.0 - measured.noise.correlation);
  for (Agreement& agreement : agreements) {
    const float reach =
        persistenceSpacings() * std::max(measured.spacing, agreement.point.spacing);
    const bool persists =
        creases.anyWithin(Eigen::Map<const Vector3f>(agreement.point.position.data()),
                          reach,
                          [](std::uint32_t, const Vector3f&) { return true; });
    if (!persists)
      agreement.evidence *= left;
  }
}

} // namespace

void
findEdges(const FieldInput& input,
          const MeasuredCloud& measured,
          const ShapeEvidence& densities,
          ShapeField& field)
{
  const float whiteness = whitenessOf(measured.noise.correlation, field.noise);
  const PointGrid grid = gridOf(input, measured);
  std::vector<Agreement> agreements =
      agreementsOf(input, measured, grid, whiteness, densities, field);
  if (measured.noise.correlation > 0.0 && input.normals.size == 0)
    weakenWhatDoesNotPersist(
        creasesOfNextLevel(input, measured, densities, field.noise),
        measured,
        agreements);
  const float needed = neededEvidence(whiteness, field.noise_level);
  continueCreases(needed,
                  faintEvidence(needed, whiteness),
                  measured.spacing,
                  input.threads,
                  agreements);
  markBands(agreements, needed, grid, field);
  field.creases = creasesAmong(agreements, needed);
}

float
whitenessOf(double correlation, double noise)
{
  constexpr double known = 0.25, unknown = 0.3;
  const double trust = std::clamp((unknown - noise) / (unknown - known), 0.0, 1.0);
  return static_cast<float>((1.0 - correlation) * trust);
}

float
persistenceSpacings()
{
  return 3.0f; // at corners the creases of the next level end farther away
}

} // namespace pcl::detail
