// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Follows creases from where they are clear to where they are faint.

#include "edges/crease_continuation.h"

#include "common/parallel.h"

#include <array>
#include <cmath>
#include <cstdint>
#include <utility>

namespace pcl::segmentation {
namespace {

using Eigen::Vector3f;

constexpr float step_spacings = 2.0f; // as wide as the band of a crease
constexpr int max_steps = 2;        // bounds what a place depends on; more gave little
constexpr float min_cosine = 0.87f; // 30 degrees, as directions of faint places vary
// A likelihood above .5, and no more than where a crease is clear.
constexpr float just_enough = 1.001f;
constexpr float max_turn = 0.5f; // radians by which the angles of both may differ

Vector3f
vectorOf(const std::array<float, 3>& values)
{
  return Eigen::Map<const Vector3f>(values.data());
}

bool
continues(const CreasePoint& place, const CreasePoint& crease)
{
  const Vector3f direction = vectorOf(crease.direction);
  const Vector3f way = vectorOf(place.position) - vectorOf(crease.position);
  const float aside = (way - way.dot(direction) * direction).norm();
  return aside <= agreementSpacings() * place.spacing &&
         std::abs(direction.dot(vectorOf(place.direction))) >= min_cosine &&
         std::abs(place.angle - crease.angle) <= max_turn;
}

/** For each of the places whether it continues one of the creases. */
std::vector<char>
whichContinue(const std::vector<CreasePoint>& creases,
              const std::vector<Agreement>& agreements,
              const std::vector<std::uint32_t>& places,
              const PointGrid& grid,
              unsigned threads)
{
  std::vector<char> which(places.size());
  kernels::parallelForEach(places.size(), threads, [&](std::size_t k) {
    const CreasePoint& place = agreements[places[k]].point;
    const bool does = grid.anyWithin(
        vectorOf(place.position),
        step_spacings * place.spacing,
        [&](std::uint32_t i, const Vector3f&) { return continues(place, creases[i]); });
    which[k] = does ? 1 : 0;
  });
  return which;
}

} // namespace

void
continueCreases(float needed,
                float faint,
                float spacing,
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
    const PointGrid grid(positionsOf(creases), step_spacings * spacing);
    const std::vector<char> which =
        whichContinue(creases, agreements, places, grid, threads);
    creases.clear();
    std::vector<std::uint32_t> left;
    for (std::size_t k = 0; k < places.size(); ++k) {
      if (which[k] == 0) {
        left.push_back(places[k]);
        continue;
      }
      creases.push_back(agreements[places[k]].point);
      agreements[places[k]].evidence = just_enough * needed;
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
