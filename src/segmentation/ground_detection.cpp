/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * Point Cloud Library (PCL) - www.pointclouds.org
 * Copyright (c) 2026, pcl_shape contributors
 *
 * All rights reserved
 */

#include "../kernels/finite.h"
#include "ground_growth.h"

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

constexpr float good_error = 0.5f;
constexpr float foot_error = 0.4f;   // two noises: ground that reaches a wall
constexpr float worst_error = 1.42f; // the likelihood is 0 from the root of 2 on

/** A point and the ground surface that explains it best. */
struct Explained {
  float error = std::numeric_limits<float>::infinity(); ///< 1: at the tolerance
  float above = 0.0f;                                   ///< the surface, metres
  float planar = 0.0f;                                  ///< of the surface
};

Explained
explain(const GroundCells& cells,
        const GroundPatches& all,
        const NearGround& near,
        std::size_t point,
        float tolerance,
        float highest)
{
  const float x = cells.x[point], y = cells.y[point], z = cells.z[point];
  Explained best;
  for (std::size_t k = 0; k < near.count; ++k) {
    const GroundPatch& patch = all.patches[static_cast<std::size_t>(near.patches[k])];
    const float above = patch.above(x, y, z);
    const float distance = std::abs(x - patch.x) + std::abs(y - patch.y);
    const float error = std::abs(above) / (tolerance + tilt * distance);
    if (error < best.error)
      best = {error, above, patch.planar};
    if (best.error < good_error || above > highest)
      break; // no need to look, no hope
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

/** The likelihoods of points, cell by cell. */
class Classifier {
public:
  Classifier(const GroundCells& cells,
             const GroundPatches& all,
             const std::vector<char>& ground,
             float max_step,
             std::vector<float>& likelihoods)
  : cells_(cells)
  , all_(all)
  , ground_(ground)
  , max_step_(max_step)
  , tolerance_(std::clamp(noises * groundNoise(cells, all, ground, max_step),
                          0.2f * max_step,
                          0.5f * max_step))
  , likelihoods_(likelihoods)
  , upright_(cells.size(), 0)
  {}

  /** \brief By the distance from the ground near. */
  void
  classify(std::size_t cell)
  {
    const NearGround near = nearGround(all_, ground_, cell);
    for (std::size_t i = cells_.begins[cell];
         near.count > 0 && i < cells_.begins[cell + 1];
         ++i) {
      const Explained by =
          explain(cells_, all_, near, i, tolerance_, highest_steps * max_step_);
      if (by.error < worst_error)
        likelihoods_[cells_.positions[i]] = by.planar * std::exp2(-by.error * by.error);
      else if (isUpright(by.above))
        upright_[cell] = 1;
    }
  }

  /** \brief Take the feet of what stands on the ground away: points beneath others that
   * are higher than a step. All cells must have been classified. */
  void
  removeFeet(std::size_t cell)
  {
    const std::size_t first = beside(cell, Inner), last = beside(cell, Outer);
    if (std::none_of(&upright_[first], &upright_[last] + 1, [](char u) { return u; }))
      return;
    const NearGround near = nearGround(all_, ground_, cell);
    for (std::size_t i = cells_.begins[cell];
         near.count > 0 && i < cells_.begins[cell + 1];
         ++i) {
      float& likelihood = likelihoods_[cells_.positions[i]];
      if (likelihood > 0.0f &&
          explain(cells_, all_, near, i, tolerance_, highest_steps * max_step_).error >
              foot_error &&
          isBeneath(
              i, all_.patches[static_cast<std::size_t>(near.patches[0])], first, last))
        likelihood = 0.0f;
    }
  }

private:
  bool
  isUpright(float above) const
  {
    return above > max_step_ && above < highest_steps * max_step_;
  }

  /** The next cell of the line if it is directly beside, else the cell itself. */
  std::size_t
  beside(std::size_t cell, PatchSide side) const
  {
    const std::int32_t found = all_.neighbors[cell][side];
    if (found == no_patch)
      return cell;
    const auto other = static_cast<std::size_t>(found);
    const std::uint32_t apart = other > cell ? cells_.bins[other] - cells_.bins[cell]
                                             : cells_.bins[cell] - cells_.bins[other];
    return apart == 1 ? other : cell;
  }

  bool
  isBeneath(std::size_t point,
            const GroundPatch& base,
            std::size_t first,
            std::size_t last) const
  {
    const float x = cells_.x[point], y = cells_.y[point];
    const float reach = 0.25f * max_step_ * max_step_;
    int found = 0;
    for (std::size_t i = cells_.begins[first]; i < cells_.begins[last + 1]; ++i) {
      const float dx = cells_.x[i] - x, dy = cells_.y[i] - y;
      const float above = base.above(cells_.x[i], cells_.y[i], cells_.z[i]);
      found |= static_cast<int>(dx * dx + dy * dy < reach) &
               static_cast<int>(above > max_step_) &
               static_cast<int>(above < highest_steps * max_step_);
    }
    return found != 0;
  }

  const GroundCells& cells_;
  const GroundPatches& all_;
  const std::vector<char>& ground_;
  float max_step_;
  float tolerance_;
  std::vector<float>& likelihoods_;
  std::vector<char> upright_; ///< cells with points of what stands on the ground
};

} // namespace

std::vector<float>
detail::groundLikelihoods(const GroundQuery& query, const GroundParameters& parameters)
{
  const GroundCells cells = groundCells(query, parameters.up);
  std::vector<float> likelihoods(query.size, std::numeric_limits<float>::quiet_NaN());
  for (const std::uint32_t position : cells.positions)
    likelihoods[position] = 0.0f;
  GroundPatches all = groundPatches(cells, parameters, query.threads);
  const std::vector<char> ground =
      connectedGround(cells, parameters, query.threads, all);
  if (std::find(ground.begin(), ground.end(), 1) == ground.end())
    return likelihoods;
  Classifier classifier(cells, all, ground, parameters.max_step, likelihoods);
  forEachCell(
      cells, query.threads, [&](std::size_t cell) { classifier.classify(cell); });
  forEachCell(
      cells, query.threads, [&](std::size_t cell) { classifier.removeFeet(cell); });
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
