// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Ground from points to likelihoods: cells, feet, patches, connected ground, points.

#include "common/finite.h"
#include "common/number_text.h"
#include "common/parallel.h"
#include "common/statistics.h"
#include "ground/ground_growth.h"
#include "ground/ground_level.h"
#include "ground/obstacles.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

namespace pcl {
namespace {

using namespace segmentation;

// The tolerance of points: five times the noise, but within these shares of a step.
constexpr float noises = 5.0f;
constexpr float min_tolerance = 0.2f;
constexpr float max_tolerance = 0.5f;
// Where the ground around is rough, as grass of 15 cm is, more is within its blades.
constexpr float max_rough_tolerance = 0.75f;
constexpr float deviations = 1.48f; // of a normal distribution, in a median distance
// Of the tolerance, for feet: the lowest centimeters of a wall are as high as ground.
constexpr float foot_share = 0.15f;

/** The standard deviation of the points from the planes of their own cells, by the
 * median. Counts of whole steps do not depend on the order. */
float
groundNoise(const GroundCells& cells,
            const GroundPatches& all,
            const std::vector<char>& ground,
            float max_step)
{
  constexpr std::size_t steps = 256, every = 4; // cells: some are enough
  const float limit = max_tolerance * max_step;
  std::array<std::uint32_t, steps> counts{};
  std::uint32_t sum = 0;
  for (std::size_t cell = 0; cell < cells.size(); cell += every) {
    for (std::size_t i = cells.begins[cell]; ground[cell] && i < cells.begins[cell + 1];
         ++i) {
      const float above =
          std::abs(all.patches[cell].above(cells.x[i], cells.y[i], cells.z[i]));
      if (above < limit) {
        const auto step = static_cast<std::size_t>(above / limit * steps);
        ++counts[std::min(step, steps - 1)];
        ++sum;
      }
    }
  }
  std::size_t step = 0;
  for (std::uint32_t below = 0; step < steps && 2 * (below += counts[step]) < sum;)
    ++step;
  return deviations * limit * (static_cast<float>(step) + 0.5f) / steps;
}

/** The standard deviation of the points of each cell within a step of its plane, by the
 * median, without feet; 0 where there is no ground. */
std::vector<float>
noiseOfCells(const GroundCells& cells,
             const GroundPatches& all,
             const std::vector<char>& ground,
             const std::vector<char>& feet,
             float max_step,
             unsigned threads)
{
  std::vector<float> noise(cells.size(), 0.0f);
  forEachCell(cells, threads, [&](std::size_t cell) {
    if (!ground[cell])
      return;
    std::vector<float> distances;
    for (std::size_t i = cells.begins[cell]; i < cells.begins[cell + 1]; ++i) {
      const float above =
          std::abs(all.patches[cell].above(cells.x[i], cells.y[i], cells.z[i]));
      if (!feet[i] && above < max_step)
        distances.push_back(above);
    }
    if (!distances.empty())
      noise[cell] = deviations * median(std::move(distances));
  });
  return noise;
}

using NearPatches = std::array<std::uint32_t, 5>; ///< see nearGround()

/** The noise where it is as large in all directions, as on grass. A wall's lowest
 * points are in one row of cells; an opening, minimum and maximum, takes such rows
 * away. */
std::vector<float>
roughness(const std::vector<float>& noise,
          const std::vector<NearPatches>& near,
          unsigned threads)
{
  const auto ofNeighbors = [&](const std::vector<float>& values, const auto& choose) {
    std::vector<float> chosen(values.size(), 0.0f);
    kernels::parallelForEach(values.size(), threads, [&](std::size_t cell) {
      std::optional<float> value;
      for (const std::uint32_t patch : near[cell])
        if (patch != no_patch)
          value = value ? choose(*value, values[patch]) : values[patch];
      chosen[cell] = value.value_or(0.0f);
    });
    return chosen;
  };
  const auto lower = [](float a, float b) { return std::min(a, b); };
  const auto higher = [](float a, float b) { return std::max(a, b); };
  return ofNeighbors(ofNeighbors(noise, lower), higher);
}

/** What the points of a cell are compared with. */
struct NearSurfaces {
  const GroundCells& cells;
  const GroundPatches& all;
  std::size_t cell;
  const NearPatches& patches;
  float max_step;

  /** The likelihood of a point on the ground surface that explains it best. */
  float
  likelihoodOf(std::size_t point, float tolerance, float share) const
  {
    constexpr float good = 0.8f; // no need to look for a better surface
    const float x = cells.x[point], y = cells.y[point], z = cells.z[point];
    float best = 0.0f;
    for (const std::uint32_t other : patches) {
      if (other == no_patch || best >= good)
        continue;
      const GroundPatch& patch = all.patches[other];
      const float distance = std::abs(x - patch.x) + std::abs(y - patch.y);
      const float error =
          patch.above(x, y, z) / (share * (tolerance + plane_error * distance));
      const float likelihood = patch.planar * (1.0f - 0.5f * error * error);
      // Around a laser other cells may be far, and their planes too steep: they are
      // followed to where ground may be.
      if (likelihood > best && (!cells.around || other == cell ||
                                std::abs(z - patch.z) <= patch.maxRise(x, y, max_step)))
        best = likelihood;
    }
    return best;
  }
};

/** The places of a scan in cells, with heights above the ground in the large. */
struct Scan {
  GroundPlaces places;
  GroundCells cells;
  double ground_share; ///< of the cells, see level()

  Scan(const detail::GroundQuery& query,
       const GroundParameters& parameters,
       const Eigen::Vector3f& up)
  : places(groundPlaces(query, up))
  , cells(groundCells(places, query.threads))
  {
    cells.hangs = overhangsOf(cells, parameters.max_step, query.threads);
    ground_share = level(parameters, query.threads, cells);
  }
};

/** Where the ground is steep in the large, the sensor is tilted or on a ramp: then up
 * is what is perpendicular to it. Not if less is level so, and ground may be as steep.
 */
Scan
leveledScan(const detail::GroundQuery& query, const GroundParameters& parameters)
{
  constexpr float max_share = 0.5f; // of the largest slope
  constexpr double less = 0.9;      // of the cells
  constexpr double half = 0.5;      // likewise: a steep plane with fewer is no ground
  Scan scan(query, parameters, parameters.up);
  const Eigen::Vector3f normal(-scan.cells.slope_x, -scan.cells.slope_y, 1.0f);
  const float tilt = std::atan(normal.head<2>().norm());
  if (tilt <= max_share * parameters.max_slope)
    return scan;
  const auto turn =
      Eigen::Quaternionf::FromTwoVectors(parameters.up, Eigen::Vector3f::UnitZ());
  Scan upright(query, parameters, turn.conjugate() * normal);
  const bool is_less = upright.ground_share < less * scan.ground_share;
  if (is_less && tilt <= parameters.max_slope)
    return scan;
  if (tilt > parameters.max_slope && upright.ground_share < half)
    upright.ground_share = 0.0;
  return upright;
}

} // namespace

std::vector<float>
detail::groundLikelihoods(const GroundQuery& query, const GroundParameters& parameters)
{
  const float step = parameters.max_step;
  const Scan scan = leveledScan(query, parameters);
  const GroundPlaces& places = scan.places;
  const GroundCells& cells = scan.cells;
  const std::vector<char> feet = feetOf(cells, step, query.threads);
  GroundPatches all = groundPatches(cells, feet, step, query.threads);
  const std::vector<char> ground =
      scan.ground_share > 0.0 ? connectedGround(cells, parameters, query.threads, all)
                              : std::vector<char>(cells.size(), 0);
  const float tolerance = std::clamp(noises * groundNoise(cells, all, ground, step),
                                     min_tolerance * step,
                                     max_tolerance * step);
  std::vector<NearPatches> near(cells.size());
  forEachCell(cells, query.threads, [&](std::size_t cell) {
    near[cell] = nearGround(all, ground, cell);
  });
  const std::vector<float> rough = roughness(
      noiseOfCells(cells, all, ground, feet, step, query.threads), near, query.threads);
  std::vector<float> of_places(places.x.size());
  forEachCell(cells, query.threads, [&](std::size_t cell) {
    const NearSurfaces surfaces{cells, all, cell, near[cell], step};
    const float of_cell =
        std::max(tolerance, std::min(noises * rough[cell], max_rough_tolerance * step));
    for (std::size_t i = cells.begins[cell]; i < cells.begins[cell + 1]; ++i)
      of_places[cells.places[i]] = feet[i]
                                       ? surfaces.likelihoodOf(i, tolerance, foot_share)
                                       : surfaces.likelihoodOf(i, of_cell, 1.0f);
  });
  std::vector<float> likelihoods(query.size, std::numeric_limits<float>::quiet_NaN());
  for (std::size_t i = 0; i < query.size; ++i)
    if (places.of_points[i] != no_place)
      likelihoods[i] = of_places[places.of_points[i]];
  return likelihoods;
}

std::string
detail::problemOf(const GroundQuery& query, const GroundParameters& parameters)
{
  bool has_finite = false;
  for (std::size_t i = 0; i < query.size; ++i) {
    const pcl::index_t index = query.indices[i];
    if (index < 0 || static_cast<std::size_t>(index) >= query.points.size)
      return "index " + std::to_string(index) + " is out of range: the cloud has " +
             std::to_string(query.points.size) + " points";
    has_finite =
        has_finite || kernels::isFinite(query.points[static_cast<std::size_t>(index)]);
  }
  if (!has_finite)
    return "the cloud has no finite point: at least one is needed";
  const auto& [up, max_slope, max_step, threshold, sensor_height] = parameters;
  if (!(threshold >= 0.0f && threshold <= 1.0f))
    return "threshold is " + numberText(threshold) + ": it must be 0 to 1";
  if (!up.allFinite() || up.squaredNorm() == 0.0f)
    return "up is (" + numberText(up.x()) + ", " + numberText(up.y()) + ", " +
           numberText(up.z()) + "): it must be finite and not 0";
  if (!(max_slope > 0.0f && max_slope < 1.57f))
    return "max_slope is " + numberText(max_slope) +
           ": it must be above 0 and below 1.57 radians";
  if (!(max_step > 0.0f && std::isfinite(max_step)))
    return "max_step is " + numberText(max_step) + " m: it must be positive and finite";
  if (!(sensor_height >= 0.0f && std::isfinite(sensor_height)))
    return "sensor_height is " + numberText(sensor_height) +
           " m: it must be positive and finite, or 0 for unknown";
  return {};
}

} // namespace pcl
