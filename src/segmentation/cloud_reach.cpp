// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// How far the default method looks from a point: sums over its stages.

#include "edges/crease_votes.h"
#include "edges/edge_band.h"
#include "edges/edge_types.h"
#include "features/local_spacing.h"
#include "features/noise_level.h"

#include <pcl/segmentation/cloud_reach.h>

#include <algorithm>

namespace pcl {
namespace {

using namespace detail;

// Sums of floats are rounded; a neighbor at the very border must not be missed.
constexpr double rounding = 1.001;

} // namespace

CloudReach
reachOf(const CloudNumbers& numbers, const ShapeModel& edge_model)
{
  const double most = rounding * mostSpacing(numbers.distance);
  const INADParameters radii = withNoise(edge_model.parameters(), numbers.noise_level);
  CloudReach reach;
  reach.spacing = rounding * spacingReach(numbers.distance);
  reach.noise = reach.spacing + std::max(variationReach(), angleReach()) * most;
  const double normal = std::max(radii.normal_radius * most, reach.spacing);
  reach.normals = normal;
  const double inad = radii.radius * most + normal;
  const double patch =
      segmentation::patchSpacings(numbers.noise, numbers.noise_level) * most;
  const double candidate = std::max(inad, patch + normal);
  // An agreement: from its mean to its vote, from there to the others, from each of
  // them to its candidate.
  const double agreement =
      2.0 * segmentation::agreementSpacings() * most + patch + candidate;
  reach.edges = segmentation::edgeBand(numbers.noise_level) * most + agreement;
  reach.types = std::max({reach.edges,
                          cornerSpacings(numbers.noise_level) * most + agreement,
                          boundarySpacings() * most + normal});
  return reach;
}

} // namespace pcl
