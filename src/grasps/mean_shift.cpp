// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// PURPOSE

#include "grasps/mean_shift.h"

#include "common/parallel.h"
#include "geometry/point_grid.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <tuple>

namespace pcl::segmentation {

std::vector<std::size_t>
representativesOf(const std::vector<Place>& places, float radius)
{
  constexpr float same_direction = 0.7071f; // cosine of 45 degrees
  const XYZView positions{places.empty() ? nullptr : places[0].position.data(),
                          sizeof(Place) / sizeof(float),
                          places.size()};
  const PointGrid grid(positions, radius);
  std::vector<std::size_t> representatives;
  representatives.reserve(places.size());
  for (std::size_t p = 0; p < places.size(); ++p) {
    std::size_t best = p;
    grid.forEachWithin(places[p].position, radius, [&](std::uint32_t other, float) {
      if (other < best && representatives[other] == other &&
          places[other].normal.dot(places[p].normal) > same_direction)
        best = other;
    });
    representatives.push_back(best);
  }
  return representatives;
}

namespace {

using Eigen::Vector3d;
using Eigen::Vector3f;

// doc/grasps.md has the reason of each number.
constexpr float most_bandwidth = 3.0f;    // in least ones
constexpr float spreads = 2.0f;           // standard deviations in a bandwidth
constexpr float same_direction = 0.7071f; // cosine of 45 degrees
constexpr float still_move = 0.05f;       // in least bandwidths
constexpr float still_bandwidth = 0.02f;  // of the bandwidth
constexpr std::uint32_t most_iterations = 100;
constexpr float likely = 0.5f;
constexpr float start_cell = 2.0f; // in least bandwidths
constexpr float same_mode = 0.5f;  // in least bandwidths

/** What is in a window, weighted. */
struct Window {
  double weight = 0.0;
  Vector3d offset = Vector3d::Zero(), normal = Vector3d::Zero();
  double squares = 0.0;
};

/** The area that a point stands for is as the square of the distance to its 12th
 * neighbor, of which the spacing is the softened root (see AdaptiveRadius). */
double
areaOf(const TargetSurface::Point& point, float least)
{
  const double spacing = point.spacing / least;
  return spacing * spacing * spacing * spacing;
}

Window
look(const TargetSurface& surface,
     const std::vector<float>& weights,
     float least,
     const Mode& mode)
{
  Window window;
  const double h2 = static_cast<double>(mode.bandwidth) * mode.bandwidth;
  surface.forEachWithin(
      mode.position, mode.bandwidth, [&](std::uint32_t i, float squared) {
        const auto& point = surface.points()[i];
        if (!(weights[i] > 0.0f) || point.normal.dot(mode.normal) < same_direction)
          return;
        const double weight = weights[i] * areaOf(point, least) * (1.0 - squared / h2);
        window.weight += weight;
        window.offset += weight * (point.position - mode.position).cast<double>();
        window.normal += weight * point.normal.cast<double>();
        window.squares += weight * squared;
      });
  return window;
}

/** Moves a mode to the mean of its window, and fits the window to the spread there.
 * \return whether it stands still */
bool
shift(const TargetSurface& surface,
      const std::vector<float>& weights,
      float least,
      Mode& mode)
{
  const Window window = look(surface, weights, least, mode);
  if (!(window.weight > 0.0))
    return false;
  const Vector3d mean = window.offset / window.weight;
  const double variance = window.squares / window.weight - mean.squaredNorm();
  const float before = mode.bandwidth;
  mode.density = static_cast<float>(window.weight / (before * before));
  mode.position += mean.cast<float>();
  mode.normal = window.normal.normalized().cast<float>();
  mode.bandwidth =
      std::clamp(spreads * static_cast<float>(std::sqrt(std::max(variance, 0.0))),
                 least,
                 most_bandwidth * least);
  return mean.norm() < still_move * least &&
         std::abs(mode.bandwidth - before) < still_bandwidth * before;
}

/** The mean of the likely points in each cell of space that face the same way. */
std::vector<Mode>
startsOf(const TargetSurface& surface, const std::vector<float>& weights, float least)
{
  std::map<std::array<float, 4>, Window> cells;
  for (std::size_t i = 0; i < weights.size(); ++i) {
    if (weights[i] < likely)
      continue;
    const auto& point = surface.points()[i];
    const Eigen::Array3f c = (point.position.array() / (start_cell * least)).floor();
    Eigen::Index axis = 0;
    const float part = point.normal.cwiseAbs().maxCoeff(&axis);
    const float way = static_cast<float>(axis + 1) *
                      (point.normal[axis] < 0.0f && part > 0.0f ? -1.0f : 1.0f);
    Window& cell = cells[{c.x(), c.y(), c.z(), way}];
    cell.weight += weights[i];
    cell.offset += weights[i] * point.position.cast<double>();
    cell.normal += weights[i] * point.normal.cast<double>();
  }
  std::vector<Mode> starts;
  for (const auto& [key, cell] : cells) {
    Mode& start = starts.emplace_back();
    start.position = (cell.offset / cell.weight).cast<float>();
    start.normal = cell.normal.normalized().cast<float>();
    start.bandwidth = 2.0f * least;
  }
  return starts;
}

/** One mode for those that ended at the same place. */
std::vector<Mode>
merged(std::vector<Mode> modes, float least)
{
  std::sort(modes.begin(), modes.end(), [](const Mode& a, const Mode& b) {
    const Vector3f &p = a.position, &q = b.position;
    return std::make_tuple(-a.density, p.z(), p.y(), p.x()) <
           std::make_tuple(-b.density, q.z(), q.y(), q.x());
  });
  std::vector<Place> places;
  places.reserve(modes.size());
  for (const Mode& mode : modes)
    places.push_back({mode.position, mode.normal});
  const auto representatives = representativesOf(places, same_mode * least);
  std::vector<Mode> kept;
  for (std::size_t m = 0; m < modes.size(); ++m)
    if (representatives[m] != m)
      ++modes[representatives[m]].starts;
  for (std::size_t m = 0; m < modes.size(); ++m)
    if (representatives[m] == m)
      kept.push_back(modes[m]);
  return kept;
}

} // namespace

std::vector<Mode>
likelihoodModes(const TargetSurface& surface,
                const std::vector<float>& weights,
                float least,
                unsigned threads)
{
  std::vector<Mode> modes = startsOf(surface, weights, least);
  kernels::parallelFor(modes.size(), threads, [&](std::size_t m) {
    Mode& mode = modes[m];
    while (!mode.converged && mode.iterations < most_iterations) {
      mode.converged = shift(surface, weights, least, mode);
      ++mode.iterations;
    }
  });
  return merged(std::move(modes), least);
}

} // namespace pcl::segmentation
