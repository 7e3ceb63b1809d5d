// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// The modes of a likelihood over a surface, by an adaptive mean shift.

#include "grasps/mean_shift.h"

#include "common/parallel.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <tuple>

namespace pcl::segmentation {
namespace {

using Eigen::Vector3d;
using Eigen::Vector3f;

// In smallest bandwidths, the cup's radius, unless something else is said.
constexpr float max_bandwidth = 3.0f;    // sees one cup beside the cup, not far ends
constexpr float start_cell = 2.0f;       // every face of twice the cup has a start
constexpr float start_bandwidth = 2.0f;  // the size of these cells
constexpr float same_mode = 0.5f;        // nearer modes are one
constexpr float still_move = 0.05f;      // less is noise: no gripper is placed better
constexpr float still_bandwidth = 0.02f; // of the bandwidth, likewise
// Standard deviations in a bandwidth: it grows by 15 % a step within an even surface.
constexpr float deviations = 2.0f;
constexpr float likely = 0.5f;                // where there are starts
constexpr std::uint32_t max_iterations = 100; // the median is 4, the most seen 47

/** What is in a window, weighted. */
struct Window {
  double weight = 0.0;
  Vector3d offset = Vector3d::Zero(), normal = Vector3d::Zero();
  double squares = 0.0;
};

class MeanShift {
public:
  MeanShift(const TargetSurface& surface,
            const std::vector<float>& weights,
            float min_bandwidth)
  : surface_(surface)
  , weights_(weights)
  , min_bandwidth_(min_bandwidth)
  {}

  /** The mean of the likely points in each cell of space that face the same way. */
  std::vector<Mode>
  starts() const
  {
    std::map<std::array<float, 4>, Window> cells;
    for (std::size_t i = 0; i < weights_.size(); ++i) {
      if (weights_[i] < likely)
        continue;
      const auto& point = surface_.points()[i];
      const Eigen::Array3f c =
          (point.position.array() / (start_cell * min_bandwidth_)).floor();
      Eigen::Index axis = 0;
      const float part = point.normal.cwiseAbs().maxCoeff(&axis);
      const float way = static_cast<float>(axis + 1) *
                        (point.normal[axis] < 0.0f && part > 0.0f ? -1.0f : 1.0f);
      Window& cell = cells[{c.x(), c.y(), c.z(), way}];
      cell.weight += weights_[i];
      cell.offset += weights_[i] * point.position.cast<double>();
      cell.normal += weights_[i] * point.normal.cast<double>();
    }
    std::vector<Mode> starts;
    for (const auto& [key, cell] : cells) {
      Mode& start = starts.emplace_back();
      start.position = (cell.offset / cell.weight).cast<float>();
      start.normal = cell.normal.normalized().cast<float>();
      start.bandwidth = start_bandwidth * min_bandwidth_;
    }
    return starts;
  }

  /** Moves a mode to the mean of its window, and fits the window to the spread there,
   * until it stands still. */
  void
  run(Mode& mode) const
  {
    while (!mode.converged && mode.iterations < max_iterations) {
      mode.converged = shift(mode);
      ++mode.iterations;
    }
  }

private:
  bool
  shift(Mode& mode) const
  {
    const Window window = windowOf(mode);
    if (!(window.weight > 0.0))
      return false;
    const Vector3d mean = window.offset / window.weight;
    const double variance = window.squares / window.weight - mean.squaredNorm();
    const float before = mode.bandwidth;
    mode.density = static_cast<float>(window.weight / (before * before));
    mode.position += mean.cast<float>();
    mode.normal = window.normal.normalized().cast<float>();
    mode.bandwidth =
        std::clamp(deviations * static_cast<float>(std::sqrt(std::max(variance, 0.0))),
                   min_bandwidth_,
                   max_bandwidth * min_bandwidth_);
    return mean.norm() < still_move * min_bandwidth_ &&
           std::abs(mode.bandwidth - before) < still_bandwidth * before;
  }

  Window
  windowOf(const Mode& mode) const
  {
    Window window;
    const double h2 = static_cast<double>(mode.bandwidth) * mode.bandwidth;
    surface_.forEachWithin(
        mode.position, mode.bandwidth, [&](std::uint32_t i, float squared) {
          const auto& point = surface_.points()[i];
          if (!(weights_[i] > 0.0f) || point.normal.dot(mode.normal) < same_direction)
            return;
          const double weight = weights_[i] * areaOf(point) * (1.0 - squared / h2);
          window.weight += weight;
          window.offset += weight * (point.position - mode.position).cast<double>();
          window.normal += weight * point.normal.cast<double>();
          window.squares += weight * squared;
        });
    return window;
  }

  /** The area that a point stands for is as the square of the distance to its 12th
   * neighbor, of which the spacing is the softened root (see AdaptiveRadius). */
  double
  areaOf(const TargetSurface::Point& point) const
  {
    const double spacing = point.spacing / min_bandwidth_;
    return spacing * spacing * spacing * spacing;
  }

  const TargetSurface& surface_;
  const std::vector<float>& weights_;
  float min_bandwidth_;
};

/** One mode for those that ended at the same place. */
std::vector<Mode>
merged(std::vector<Mode> modes, float radius)
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
  const auto representatives = representativesOf(places, radius);
  for (std::size_t m = 0; m < modes.size(); ++m)
    if (representatives[m] != m)
      ++modes[representatives[m]].starts;
  std::vector<Mode> kept;
  for (std::size_t m = 0; m < modes.size(); ++m)
    if (representatives[m] == m)
      kept.push_back(modes[m]);
  return kept;
}

} // namespace

std::vector<std::size_t>
representativesOf(const std::vector<Place>& places, float radius)
{
  const PointGrid grid(viewOf(places), radius);
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

std::vector<Mode>
likelihoodModes(const TargetSurface& surface,
                const std::vector<float>& weights,
                float min_bandwidth,
                unsigned threads)
{
  const MeanShift shift(surface, weights, min_bandwidth);
  std::vector<Mode> modes = shift.starts();
  kernels::parallelFor(
      modes.size(), threads, [&](std::size_t m) { shift.run(modes[m]); });
  return merged(std::move(modes), same_mode * min_bandwidth);
}

} // namespace pcl::segmentation
