// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// PURPOSE

#include "common/finite.h"
#include "ground/ground_growth.h"
#include "ground/ground_level.h"
#include "ground/obstacle_feet.h"

#include <pcl/segmentation/ground_detection.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace pcl {
namespace {

using namespace segmentation;

constexpr float noises = 5.0f; // from the plane to where a point is not on it
// The planes of patches far away are less certain: half a degree.
constexpr float tilt = 0.01f;

constexpr float foot_share = 0.15f; // of the tolerance: ground that reaches a wall

/** How far the planes of other cells may be followed: to where ground may be. */
struct Reach {
  std::size_t cell;
  float max_step;
};

/** Around a laser other cells may be far, and their planes too steep. */
bool
isWithin(const GroundCells& cells,
         const Reach& reach,
         std::size_t other,
         const GroundPatch& patch,
         std::size_t point)
{
  if (!cells.around || other == reach.cell)
    return true;
  GroundPatch at;
  at.x = cells.x[point];
  at.y = cells.y[point];
  return std::abs(cells.z[point] - patch.z) <= mostRise(patch, at, reach.max_step);
}

/** The likelihood of a point on the ground surface that explains it best. */
float
likelihoodOf(const GroundCells& cells,
             const GroundPatches& all,
             const NearGround& near,
             const Reach& reach,
             std::size_t point,
             float tolerance,
             float share)
{
  constexpr float good = 0.8f;
  const float x = cells.x[point], y = cells.y[point], z = cells.z[point];
  float best = 0.0f;
  for (std::size_t k = 0; k < near.count && best < good; ++k) {
    const auto other = static_cast<std::size_t>(near.patches[k]);
    const GroundPatch& patch = all.patches[other];
    const float distance = std::abs(x - patch.x) + std::abs(y - patch.y);
    const float error = patch.above(x, y, z) / (share * (tolerance + tilt * distance));
    const float likelihood = patch.planar * (1.0f - 0.5f * error * error);
    if (likelihood > best && isWithin(cells, reach, other, patch, point))
      best = likelihood;
  }
  return best;
}

/** The standard deviation of the points from the planes of their own cells, by the
 * median. Counts of whole steps do not depend on the order. */
float
groundNoise(const GroundCells& cells,
            const GroundPatches& all,
            const std::vector<char>& ground,
            float max_step)
{
  constexpr std::size_t steps = 256, every = 4; // cells: some are enough
  const float most = 0.5f * max_step;
  std::array<std::uint32_t, steps> counts{};
  std::uint32_t sum = 0;
  for (std::size_t cell = 0; cell < cells.size(); cell += every) {
    for (std::size_t i = cells.begins[cell]; ground[cell] && i < cells.begins[cell + 1];
         ++i) {
      const float above =
          std::abs(all.patches[cell].above(cells.x[i], cells.y[i], cells.z[i]));
      if (above < most) {
        ++counts[static_cast<std::size_t>(above / most * steps)];
        ++sum;
      }
    }
  }
  std::size_t step = 0;
  for (std::uint32_t below = 0; step < steps && 2 * (below += counts[step]) < sum;)
    ++step;
  return 1.48f * most * (static_cast<float>(step) + 0.5f) / steps;
}

} // namespace

std::vector<float>
detail::groundLikelihoods(const GroundQuery& query, const GroundParameters& parameters)
{
  const float step = parameters.max_step;
  GroundCells cells = groundCells(query, parameters.up);
  const bool has_ground = level(parameters, query.threads, cells);
  const std::vector<char> feet = feetOf(cells, step, query.threads);
  GroundPatches all = groundPatches(cells, feet, parameters, query.threads);
  const std::vector<char> ground =
      has_ground ? connectedGround(cells, parameters, query.threads, all)
                 : std::vector<char>(cells.size(), 0);
  const float noise = groundNoise(cells, all, ground, step);
  const float tolerance = std::clamp(noises * noise, 0.2f * step, 0.5f * step);
  std::vector<float> likelihoods(query.size, std::numeric_limits<float>::quiet_NaN());
  forEachCell(cells, query.threads, [&](std::size_t cell) {
    const NearGround near = nearGround(all, ground, cell);
    for (std::size_t i = cells.begins[cell]; i < cells.begins[cell + 1]; ++i)
      likelihoods[cells.positions[i]] = likelihoodOf(
          cells, all, near, {cell, step}, i, tolerance, feet[i] ? foot_share : 1.0f);
  });
  return likelihoods;
}

std::string
detail::problemOf(const GroundParameters& parameters)
{
  const auto is = [](const char* name, float value) {
    return std::string(name) + " is " + std::to_string(value) + ": ";
  };
  const auto& [x, y, z] = parameters.up;
  if (!kernels::isFinite(parameters.up.data()) || x * x + y * y + z * z == 0.0f)
    return "up is (" + std::to_string(x) + ", " + std::to_string(y) + ", " +
           std::to_string(z) + "): a finite direction other than 0 is allowed";
  if (!(parameters.max_slope > 0.0f && parameters.max_slope < 1.57f))
    return is("max_slope", parameters.max_slope) +
           "more than 0 and less than 1.57 radians are allowed";
  if (!(parameters.max_step > 0.0f && std::isfinite(parameters.max_step)))
    return is("max_step", parameters.max_step) +
           "a positive finite number of metres is allowed";
  return {};
}

} // namespace pcl
