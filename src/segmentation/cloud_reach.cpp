// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// How far the default method looks from a point: sums over its stages.

#include "edges/crease_continuation.h"
#include "edges/crease_votes.h"
#include "edges/edge_detection.h"
#include "edges/edge_types.h"
#include "features/noise/noise_level.h"
#include "features/spacing/local_spacing.h"
#include "surfaces/face_evidence.h"
#include "surfaces/surface_classification.h"

#include <pcl/segmentation/cloud_reach.h>

#include <algorithm>
#include <cmath>

namespace pcl {
namespace {

using namespace detail;

// Sums of floats are rounded; a neighbor at the very border must not be missed.
constexpr double rounding = 1.001;

/** How far the first level of faces looks from the first point of a node.
 * \param[in] layer by which nodes move to the middle of their sheets */
double
firstFacesReach(double cell, double layer, double most, double edges)
{
  const double diagonal = std::sqrt(3.0) * cell;
  // Normals and links are made twice; each time of the nodes that follow. Of two that
  // are linked both have moved, and the last looks as far for its layers.
  return diagonal + 2.0 * segmentation::firstLink(cell, most) + 4.0 * layer + diagonal +
         edges;
}

/** How far a node of a level looks, along each axis from its cell, to make its normal
 * and its links: those of each level twice, by links into the next cells. */
double
levelReach(double first_cell, double link, std::size_t level)
{
  double reach = link + first_cell;
  double cell = first_cell;
  for (std::size_t l = 1; l <= level; ++l) {
    cell *= 2.0;
    reach += 2.0 * (link + cell);
  }
  return reach;
}

/** How far the windows look whose noise counts at the cell of a node, at any level. */
double
windowReach(const CloudNumbers& numbers, double most)
{
  double cell = segmentation::firstCell(numbers.noise, numbers.spacing);
  const double link = segmentation::firstLink(cell, most);
  double reach = 0.0;
  const double first = cell;
  for (std::size_t level = 0; level < segmentation::face_levels; ++level, cell *= 2.0) {
    const double noise = 2.0 * segmentation::noiseCell(cell, numbers.spacing);
    // From a place in the cell to its node, from there to nodes that noise is made of,
    // to the nodes of their windows, and all of their cells.
    reach = std::max(reach,
                     cell + noise + segmentation::windowRadius(cell, most) + cell +
                         levelReach(first, link, level));
  }
  return reach;
}

/** An agreement: from its mean to its vote, from there to the others, from each of them
 * to its candidate, and what that needs. */
double
agreementReach(const CloudNumbers& numbers, const ShapeModel& edge_model)
{
  const double most = rounding * mostSpacing(numbers.distance);
  const INADParameters radii = withNoise(edge_model.parameters(), numbers.noise_level);
  const double normal =
      std::max(radii.normal_radius * most, rounding * spacingReach(numbers.distance));
  const double inad = radii.radius * most + normal;
  const double patch =
      segmentation::patchSpacings(numbers.noise, numbers.noise_level) * most;
  const double candidate = std::max(inad, patch + normal);
  return 2.0 * segmentation::agreementSpacings() * most + patch + candidate;
}

/** From an agreement to what decides whether the next level has it, too. */
double
persistenceReach(const CloudNumbers& numbers, const ShapeModel& edge_model)
{
  if (numbers.noise_correlation == 0.0)
    return 0.0;
  const NextLevel level = nextLevel(numbers);
  const double most = rounding * mostSpacing(numbers.distance);
  return segmentation::agreementSpacings() * most + persistenceSpacings() * most +
         agreementReach(level.numbers, edge_model) + std::sqrt(3.0) * level.size;
}

/** From a place to the crease that it continues. */
double
continuationReach(const CloudNumbers& numbers)
{
  if (whitenessOf(numbers.noise_correlation, numbers.noise) == 0.0f)
    return 0.0;
  return segmentation::continuationSpacings() * rounding *
         mostSpacing(numbers.distance);
}

} // namespace

CloudReach
reachOf(const CloudNumbers& numbers, const ShapeModel& edge_model)
{
  const double most = rounding * mostSpacing(numbers.distance);
  const INADParameters radii = withNoise(edge_model.parameters(), numbers.noise_level);
  CloudReach reach;
  reach.spacing = rounding * spacingReach(numbers.distance);
  reach.noise = reach.spacing +
                std::max(variationReach() * most, rounding * noiseLevelReach(numbers));
  const double normal = std::max(radii.normal_radius * most, reach.spacing);
  reach.normals = normal;
  const double agreement = std::max(agreementReach(numbers, edge_model),
                                    persistenceReach(numbers, edge_model)) +
                           continuationReach(numbers);
  reach.edges = segmentation::edgeBand(numbers.noise_level) * most + agreement;
  reach.types = std::max({reach.edges,
                          cornerSpacings(numbers.noise_level) * most + agreement,
                          boundarySpacings() * most + normal});
  const double cell =
      rounding * segmentation::firstCell(numbers.noise, numbers.spacing);
  const double layer =
      rounding * segmentation::layerReach(numbers.noise, numbers.spacing);
  const double faces = std::max(firstFacesReach(cell, layer, most, reach.edges),
                                rounding * modelReach(numbers,
                                                      ShapeModel::defaultSurfaces(),
                                                      reach.edges,
                                                      reach.normals));
  reach.faces = std::sqrt(3.0) * cell + faces;
  // Pieces are near by their first points, which are in the cell of their mean, and
  // that may have moved.
  reach.surfaces = segmentation::evidenceReach(numbers) +
                   rounding * windowReach(numbers, most) + 2.0 * (cell + layer);
  return reach;
}

} // namespace pcl
