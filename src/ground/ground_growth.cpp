// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// PURPOSE

#include "ground/ground_growth.h"

#include "common/disjoint_sets.h"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <optional>

namespace pcl::segmentation {
namespace {

constexpr std::uint32_t bins_an_octave = 16;  // see groundCells()
constexpr std::size_t min_plane_patches = 12; // of a plane
constexpr int rounds = 3;
constexpr double bend = 0.03; // of the ground from the plane, per metre of the range

} // namespace

CoarseGround::CoarseGround(const GroundCells& cells,
                           const GroundPatches& all,
                           const std::vector<char>& is_level,
                           float max_step)
: cells_(cells)
, all_(all)
, max_step_(max_step)
{
  std::vector<std::vector<std::size_t>> patches;
  for (std::size_t i = 0; i < is_level.size(); ++i) {
    const std::size_t octave = octaveOf(i);
    patches.resize(std::max(patches.size(), octave + 1));
    if (is_level[i])
      patches[octave].push_back(i);
  }
  const auto size = [](const auto& one, const auto& other) {
    return one.size() < other.size();
  };
  // Ground surrounds what is nearer than most of it; there may be more of cars there.
  const auto surest = std::max_element(patches.begin(), patches.end(), size);
  Plane plane; // what heights are measured from
  for (auto of_octave = surest; of_octave != patches.end(); ++of_octave) {
    for (int round = 0; round < rounds; ++round)
      refit(*of_octave, plane);
    planes_.resize(static_cast<std::size_t>(of_octave - patches.begin()) + 1, plane);
  }
}

bool
CoarseGround::isNear(std::size_t patch) const
{
  return isNear(planes_[octaveOf(patch)], patch);
}

double
CoarseGround::above(const Plane& plane, std::size_t patch) const
{
  const GroundPatch& p = all_.patches[patch];
  return p.low - (plane.z + plane.slope_x * p.x + plane.slope_y * p.y);
}

bool
CoarseGround::isNear(const Plane& plane, std::size_t patch) const
{
  const GroundPatch& p = all_.patches[patch];
  const double range = std::sqrt(double{p.x} * p.x + double{p.y} * p.y);
  return std::abs(above(plane, patch)) <= max_step_ + bend * range;
}

void
CoarseGround::refit(const std::vector<std::size_t>& patches, Plane& plane) const
{
  Eigen::Matrix3d squares = Eigen::Matrix3d::Zero();
  Eigen::Vector3d products = Eigen::Vector3d::Zero();
  std::size_t count = 0;
  for (const std::size_t i : patches) {
    if (!isNear(plane, i))
      continue;
    const GroundPatch& p = all_.patches[i];
    const Eigen::Vector3d row(1.0, p.x, p.y);
    squares += row * row.transpose();
    products += row * double{p.low};
    ++count;
  }
  if (count < min_plane_patches)
    return;
  const Eigen::Vector3d solution = squares.ldlt().solve(products);
  if (solution.allFinite())
    plane = {solution[0], solution[1], solution[2]};
}

std::size_t
CoarseGround::octaveOf(std::size_t patch) const
{
  return cells_.bins[patch] / bins_an_octave;
}

namespace {

constexpr int most_hops = 24; // to the ground before and behind what hides it

struct Votes {
  std::size_t patches = 0, low = 0, high = 0;
};

} // namespace

bool
addLowSets(const GroundCells& cells,
           const GroundPatches& all,
           const CoarseGround* coarse,
           float max_step,
           std::vector<Rest>& rest,
           std::vector<char>& ground)
{
  const auto isLow = [&](std::size_t base, std::size_t patch) {
    const GroundPatch &a = all.patches[base], &b = all.patches[patch];
    return coarse ? std::abs(coarse->rise(base, patch)) <= mostRise(a, b, max_step)
                  : continues(a, b, max_step);
  };
  std::vector<Votes> votes(ground.size());
  for (const auto& [patch, line, set] : rest) {
    ++votes[set].patches;
    const std::uint32_t bin = cells.bins[patch];
    for (const std::int32_t base :
         {nextMarked(all.neighbors, ground, patch, Inner, most_hops),
          nextMarked(all.neighbors, ground, patch, Outer, most_hops),
          markedAside(cells, ground, line, bin, false, most_hops),
          markedAside(cells, ground, line, bin, true, most_hops)})
      if (base != no_patch)
        ++(isLow(static_cast<std::size_t>(base), patch) ? votes[set].low
                                                        : votes[set].high);
  }
  const auto isGround = [&](const Rest& one) {
    const Votes& of_set = votes[one.set];
    return of_set.patches >= min_set_patches && of_set.low > of_set.high;
  };
  for (const Rest& one : rest)
    ground[one.patch] = isGround(one);
  const std::size_t before = rest.size();
  rest.erase(std::remove_if(rest.begin(), rest.end(), isGround), rest.end());
  return rest.size() < before;
}

namespace {

constexpr float least_planar = 0.5f;
constexpr int hops = 3; // over cells that are no ground: a kerb, a pole

std::vector<char>
levelPatches(const GroundCells& cells, const GroundPatches& all, float max_slope)
{
  const float most = std::tan(max_slope) * std::tan(max_slope);
  std::vector<char> level(all.patches.size());
  for (std::size_t i = 0; i < level.size(); ++i) {
    const GroundPatch& p = all.patches[i];
    const float slope_x = p.slope_x + cells.slope_x,
                slope_y = p.slope_y + cells.slope_y;
    level[i] =
        p.planar >= least_planar && slope_x * slope_x + slope_y * slope_y <= most;
  }
  return level;
}

DisjointSets
connect(const GroundPatches& all, const std::vector<char>& level, float max_step)
{
  DisjointSets sets(level.size());
  for (std::size_t i = 0; i < level.size(); ++i) {
    for (const PatchSide side : {Outer, Left, Right}) {
      if (!level[i])
        break;
      const std::int32_t found = nextMarked(all.neighbors, level, i, side, hops);
      if (found == no_patch)
        continue;
      const auto j = static_cast<std::size_t>(found);
      if (continues(all.patches[i], all.patches[j], max_step) &&
          continues(all.patches[j], all.patches[i], max_step))
        sets.unite(static_cast<std::uint32_t>(i), static_cast<std::uint32_t>(j));
    }
  }
  return sets;
}

/** Around a laser: a ring climbs the side of a car as gently as ground rises, and one
 * ring alone does not tell. What is not near the ground in the large is left out. */
void
levelOut(const CoarseGround& coarse, std::vector<Rest>& rest, std::vector<char>& ground)
{
  for (std::size_t i = 0; i < ground.size(); ++i)
    ground[i] = ground[i] && coarse.isNear(i);
  rest.erase(std::remove_if(rest.begin(),
                            rest.end(),
                            [&](const Rest& one) { return !coarse.isNear(one.patch); }),
             rest.end());
}

void
fitToGround(const GroundPatches& all,
            const std::vector<char>& ground,
            std::size_t cell,
            float max_step,
            GroundPatch& patch)
{
  std::array<const GroundPatch*, 4> others{};
  std::size_t count = 0;
  float slope_x = patch.slope_x, slope_y = patch.slope_y;
  for (const std::int32_t at : all.neighbors[cell]) {
    if (at != no_patch && ground[static_cast<std::size_t>(at)] &&
        continues(patch, all.patches[static_cast<std::size_t>(at)], 0.25f * max_step)) {
      others[count] = &all.patches[static_cast<std::size_t>(at)];
      slope_x += others[count]->slope_x;
      slope_y += others[count]->slope_y;
      ++count;
    }
  }
  patch.slope_x = slope_x / static_cast<float>(count + 1);
  patch.slope_y = slope_y / static_cast<float>(count + 1);
  fitPlane(patch, others.data(), count, prior_weight);
}

} // namespace

std::vector<char>
connectedGround(const GroundCells& cells,
                const GroundParameters& parameters,
                unsigned threads,
                GroundPatches& all)
{
  const std::size_t size = all.patches.size();
  const std::vector<char> level = levelPatches(cells, all, parameters.max_slope);
  DisjointSets sets = connect(all, level, parameters.max_step);
  std::vector<std::size_t> set_of(size, size), sizes(size, 0);
  for (std::size_t i = 0; i < size; ++i)
    if (level[i])
      ++sizes[set_of[i] = sets.find(static_cast<std::uint32_t>(i))];
  const auto largest = std::max_element(sizes.begin(), sizes.end());
  std::vector<char> ground(size, 0);
  if (largest == sizes.end() || *largest < min_set_patches)
    return ground;
  const auto main = static_cast<std::size_t>(largest - sizes.begin());
  std::vector<Rest> rest;
  for (std::size_t line = 0; line < cells.lineCount(); ++line) {
    for (std::size_t i = cells.lines[line]; i < cells.lines[line + 1]; ++i) {
      ground[i] = set_of[i] == main;
      if (level[i] && !ground[i])
        rest.push_back({i, line, set_of[i]});
    }
  }
  std::optional<CoarseGround> coarse;
  if (cells.around) {
    coarse.emplace(cells, all, level, parameters.max_step);
    levelOut(*coarse, rest, ground);
  }
  while (addLowSets(
      cells, all, coarse ? &*coarse : nullptr, parameters.max_step, rest, ground)) {
  }
  std::vector<GroundPatch> fitted = all.patches;
  forEachCell(cells, threads, [&](std::size_t i) {
    if (ground[i])
      fitToGround(all, ground, i, parameters.max_step, fitted[i]);
  });
  all.patches = std::move(fitted);
  return ground;
}

NearGround
nearGround(const GroundPatches& all, const std::vector<char>& ground, std::size_t cell)
{
  NearGround near;
  if (ground[cell])
    near.patches[near.count++] = static_cast<std::int32_t>(cell);
  for (const PatchSide side : {Inner, Outer, Right, Left}) {
    const std::int32_t found = nextMarked(all.neighbors, ground, cell, side, hops);
    if (found != no_patch)
      near.patches[near.count++] = found;
  }
  return near;
}

} // namespace pcl::segmentation
