// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Follows creases from where they are clear to where they are faint.

#include "edges/crease_continuation.h"

#include "common/parallel.h"

#include <array>
#include <cmath>
#include <cstdint>

namespace pcl::segmentation {
namespace {

using Eigen::Vector3f;

// Spacings: as wide as the band of a crease. Results depend on no more than three
// steps.
constexpr float step_spacings = 2.0f;
constexpr int max_steps = 2;
constexpr float min_cosine = 0.87f; // 30 degrees, as directions of faint places vary
constexpr float max_turn = 0.5f;    // radians by which the angles of both may differ

Vector3f
vectorOf(const std::array<float, 3>& values)
{
  return Eigen::Map<const Vector3f>(values.data());
}

bool
isFartherAlong(const CreasePoint& place, const CreasePoint& crease)
{
  const Vector3f direction = vectorOf(crease.direction);
  const Vector3f way = vectorOf(place.position) - vectorOf(crease.position);
  const float aside = (way - way.dot(direction) * direction).norm();
  return aside <= agreementSpacings() * place.spacing &&
         std::abs(direction.dot(vectorOf(place.direction))) >= min_cosine &&
         std::abs(place.angle - crease.angle) <= max_turn;
}

/** Those places that continue one of the creases. */
std::vector<char>
placesAlong(const std::vector<CreasePoint>& creases,
            const std::vector<Agreement>& agreements,
            const std::vector<std::uint32_t>& places,
            const PointGrid& grid,
            unsigned threads)
{
  std::vector<char> along(places.size());
  kernels::parallelForEach(places.size(), threads, [&](std::size_t k) {
    const CreasePoint& place = agreements[places[k]].point;
    along[k] = grid.anyWithin(vectorOf(place.position),
                              step_spacings * place.spacing,
                              [&](std::uint32_t i, const Vector3f&) {
                                return isFartherAlong(place, creases[i]);
                              });
  });
  return along;
}

} // namespace

void
continueCreases(float needed,
                float faint,
                float spacing,
                const Bounds& bounds,
                unsigned threads,
                std::vector<Agreement>& agreements)
{
  std::vector<CreasePoint> creases;
  std::vector<std::uint32_t> places;
  for (std::uint32_t i = 0; i < agreements.size(); ++i)
    if (agreements[i].evidence >= needed)
      creases.push_back(agreements[i].point);
    else if (agreements[i].evidence >= faint && agreements[i].fit >= 0.0f)
      places.push_back(i);
  for (int step = 0; step < max_steps && !creases.empty() && !places.empty(); ++step) {
    const PointGrid grid(positionsOf(creases), step_spacings * spacing, bounds);
    const std::vector<char> along =
        placesAlong(creases, agreements, places, grid, threads);
    creases.clear();
    std::vector<std::uint32_t> left;
    for (std::size_t k = 0; k < places.size(); ++k) {
      if (!along[k]) {
        left.push_back(places[k]);
        continue;
      }
      creases.push_back(agreements[places[k]].point);
      agreements[places[k]].evidence += needed;
    }
    places = std::move(left);
  }
}

float
continuationSpacings()
{
  return static_cast<float>(max_steps) * step_spacings;
}

} // namespace pcl::segmentation
