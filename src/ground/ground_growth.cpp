// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Which patches are ground: level, planar, and connected or at the ground's height.

#include "ground/ground_growth.h"

#include "common/disjoint_sets.h"

#include <Eigen/Dense>
#include <Eigen/Geometry>

#include <utility>

namespace pcl::segmentation {
namespace {

// Between connected patches at most two cells may be no ground: a curb, a pole.
constexpr int max_hops = 3;
// To the ground before and behind what hides it: an octave and a half of the range.
constexpr int max_vote_hops = 24;
constexpr std::size_t min_set_patches = 4; // of ground that stands alone
constexpr float min_planar = 0.5f;         // the border of the paper's first bin

/** A level patch not yet accepted as ground, with its line and set. */
struct Candidate {
  std::size_t patch, line, set;
};

/** The nearest patch on a side that is marked; what is between may be anything. */
std::uint32_t
nextMarked(const std::vector<PatchNeighbors>& neighbors,
           const std::vector<char>& marks,
           std::size_t from,
           PatchSide side,
           int hops)
{
  std::uint32_t at = neighbors[from][side];
  for (int hop = 1; at != no_patch && !marks[at]; ++hop)
    at = hop < hops ? neighbors[at][side] : no_patch;
  return at;
}

/** The nearest marked patch on lines to one side. */
std::uint32_t
markedAside(const GroundCells& cells,
            const std::vector<char>& marks,
            const Candidate& from,
            PatchSide side)
{
  const std::size_t lines = cells.lineCount();
  std::size_t line = from.line;
  for (int hop = 0; hop < max_vote_hops; ++hop) {
    if (!cells.around && line == (side == Left ? lines - 1 : 0))
      break;
    line = (line + (side == Left ? 1 : lines - 1)) % lines;
    const std::uint32_t found =
        nearestInLine(cells, marks, line, cells.bins[from.patch], max_bins_apart);
    if (found != no_patch)
      return found;
  }
  return no_patch;
}

/** The nearest marked patch inward; if there is none, the first one behind the laser:
 * the vehicle stands on ground that continues below it. Not for what is far away. */
std::uint32_t
markedInward(const GroundCells& cells,
             const GroundPatches& all,
             const std::vector<char>& marks,
             const Candidate& from)
{
  const std::uint32_t found =
      nextMarked(all.neighbors, marks, from.patch, Inner, max_vote_hops);
  if (found != no_patch || !cells.around)
    return found;
  const std::size_t lines = cells.lineCount();
  const std::size_t line = (from.line + lines / 2) % lines;
  for (std::uint32_t i = cells.lines[line]; i < cells.lines[line + 1]; ++i)
    if (marks[i])
      return cells.bins[from.patch] <= cells.bins[i] + max_bins_apart ? i : no_patch;
  return no_patch;
}

std::vector<char>
levelPatches(const GroundCells& cells, const GroundPatches& all, float max_slope)
{
  const float max_squared = std::tan(max_slope) * std::tan(max_slope);
  std::vector<char> level(all.patches.size());
  for (std::size_t i = 0; i < level.size(); ++i) {
    const GroundPatch& p = all.patches[i];
    const float x = p.slope_x + cells.slope_x, y = p.slope_y + cells.slope_y;
    level[i] = p.planar >= min_planar && x * x + y * y <= max_squared;
  }
  return level;
}

/** Level patches that continue each other: sets by their smallest patch. */
struct Continuations {
  std::vector<std::size_t> set_of; ///< the number of patches for those not level
  std::vector<std::size_t> wide_set_of;
};

/** Sides on which a patch continues; it is wide with three: not one ring alone, which
 * may climb the side of a car as gently as ground rises. */
constexpr int wide_sides = 3;

Continuations
continuations(const GroundPatches& all, const std::vector<char>& level, float max_step)
{
  const std::size_t size = level.size();
  std::vector<std::array<std::uint32_t, 3>> next(size);
  std::vector<int> sides(size, 0);
  for (std::size_t i = 0; i < size; ++i) {
    next[i].fill(no_patch);
    std::size_t at = 0;
    for (const PatchSide side : {Outer, Left, Right}) {
      const std::uint32_t j =
          level[i] ? nextMarked(all.neighbors, level, i, side, max_hops) : no_patch;
      if (j != no_patch && all.patches[i].continuesTo(all.patches[j], max_step) &&
          all.patches[j].continuesTo(all.patches[i], max_step)) {
        next[i][at] = j;
        ++sides[i];
        if (side == Outer)
          ++sides[j];
      }
      ++at;
    }
  }
  DisjointSets sets(size), wide(size);
  for (std::size_t i = 0; i < size; ++i)
    for (const std::uint32_t j : next[i]) {
      if (j == no_patch)
        continue;
      sets.unite(static_cast<std::uint32_t>(i), j);
      if (sides[i] >= wide_sides && sides[j] >= wide_sides)
        wide.unite(static_cast<std::uint32_t>(i), j);
    }
  Continuations found{std::vector<std::size_t>(size, size),
                      std::vector<std::size_t>(size, size)};
  for (std::size_t i = 0; i < size; ++i) {
    if (!level[i])
      continue;
    found.set_of[i] = sets.find(static_cast<std::uint32_t>(i));
    if (sides[i] >= wide_sides)
      found.wide_set_of[i] = wide.find(static_cast<std::uint32_t>(i));
  }
  return found;
}

/** The ground around a laser in the large, within an octave of the range. */
struct CoarsePlane {
  double z = 0.0, slope_x = 0.0, slope_y = 0.0;

  double
  above(const GroundPatch& p) const
  {
    return p.low - (z + slope_x * p.x + slope_y * p.y);
  }

  bool
  isNear(const GroundPatch& p, float max_step) const
  {
    const double range = std::sqrt(double{p.x} * p.x + double{p.y} * p.y);
    return std::abs(above(p)) <= max_step + ground_bend * range;
  }

  /** To the patches near it, if they are enough. */
  void
  refit(const std::vector<GroundPatch>& patches, float max_step)
  {
    constexpr std::size_t min_patches = 12; // four times the unknowns
    Eigen::Matrix3d squares = Eigen::Matrix3d::Zero();
    Eigen::Vector3d products = Eigen::Vector3d::Zero();
    std::size_t count = 0;
    for (const GroundPatch& p : patches) {
      if (!isNear(p, max_step))
        continue;
      const Eigen::Vector3d row(1.0, p.x, p.y);
      squares += row * row.transpose();
      products += row * double{p.low};
      ++count;
    }
    if (count < min_patches)
      return;
    const Eigen::Vector3d solution = squares.ldlt().solve(products);
    if (solution.allFinite())
      *this = {solution[0], solution[1], solution[2]};
  }
};

/** A plane for each octave of the range, from the inside outwards, fitted to patches
 * that are ground, most of them. */
std::vector<CoarsePlane>
coarseGround(const GroundCells& cells,
             const GroundPatches& all,
             const std::vector<char>& level,
             float max_step)
{
  std::vector<std::vector<GroundPatch>> patches;
  std::vector<std::size_t> near; // patches of each octave
  CoarsePlane plane;             // what heights are measured from
  for (std::size_t i = 0; i < level.size(); ++i) {
    const std::size_t octave = cells.bins[i] / bins_per_octave;
    patches.resize(std::max(patches.size(), octave + 1));
    near.resize(patches.size(), 0);
    if (!level[i])
      continue;
    patches[octave].push_back(all.patches[i]);
    near[octave] += plane.isNear(all.patches[i], max_step) ? 1U : 0U;
  }
  // Ground surrounds what is nearer than most of it; there may be more of cars there.
  const auto surest = std::max_element(near.begin(), near.end()) - near.begin();
  constexpr int rounds = 3; // each with the patches near the last plane
  std::vector<CoarsePlane> planes;
  for (auto of_octave = patches.begin() + surest; of_octave != patches.end();
       ++of_octave) {
    for (int round = 0; round < rounds; ++round)
      plane.refit(*of_octave, max_step);
    planes.resize(static_cast<std::size_t>(of_octave - patches.begin()) + 1, plane);
  }
  return planes;
}

/** The sets that are wider than vehicles in all directions, wherever they point. */
std::vector<char>
wideSets(const GroundPatches& all, const std::vector<Candidate>& candidates)
{
  constexpr float min_width = 5.0f; // meters: cars are shorter, trucks narrower
  constexpr int directions = 8;     // widths are then known to 2 %
  constexpr float pi = 3.14159265f;
  std::vector<char> wide(all.patches.size(), 1);
  for (int d = 0; d < directions; ++d) {
    const float angle = pi * static_cast<float>(d) / directions;
    const Eigen::Vector2f along(std::cos(angle), std::sin(angle));
    std::vector<Eigen::AlignedBox1f> spans(all.patches.size());
    for (const Candidate& c : candidates)
      spans[c.set].extend(Eigen::Matrix<float, 1, 1>(
          along.x() * all.patches[c.patch].x + along.y() * all.patches[c.patch].y));
    for (std::size_t set = 0; set < wide.size(); ++set)
      wide[set] =
          wide[set] && !spans[set].isEmpty() && spans[set].sizes()[0] > min_width;
  }
  return wide;
}

/** Moves the sets that are at the height of the ground nearest to them, or where a
 * slope may lead from there, from the candidates to the ground, by vote. Nothing but
 * ground is below the ground, and what is above it is a field if it is wide and still
 * below the sensor; the slope itself may be hidden behind its crest, or in a ditch.
 * \param[in] coarse tells heights along the ground; without, the planes of patches do
 * \return whether there were any */
bool
addLowSets(const GroundCells& cells,
           const GroundPatches& all,
           const std::vector<CoarsePlane>& coarse,
           const GroundParameters& parameters,
           std::vector<Candidate>& candidates,
           std::vector<char>& ground)
{
  struct Votes {
    std::size_t patches = 0, low = 0, high = 0;
  };
  const float steepest = std::tan(parameters.max_slope);
  const std::vector<char> wide = wideSets(all, candidates);
  // A vehicle's sensor stands on the ground; from higher up roofs are below it, too.
  constexpr float highest_sensor = 5.0f; // meters
  const bool stands = cells.below_sensor && cells.sensor_z < highest_sensor;
  const auto isLow = [&](std::size_t base, const Candidate& c) {
    const GroundPatch &a = all.patches[base], &b = all.patches[c.patch];
    const double rise = [&] {
      if (coarse.empty())
        return double{a.above(b.x, b.y, b.z)};
      const CoarsePlane& plane = coarse[cells.bins[base] / bins_per_octave];
      return plane.above(b) - plane.above(a);
    }();
    return std::abs(rise) <= a.maxRise(b.x, b.y, parameters.max_step) ||
           ((rise < 0.0 ||
             (stands && wide[c.set] && b.z < cells.sensor_z - parameters.max_step)) &&
            std::abs(b.z - a.z) <= steepest * std::hypot(b.x - a.x, b.y - a.y));
  };
  std::vector<Votes> votes(ground.size());
  for (const Candidate& c : candidates) {
    Votes& of_set = votes[c.set];
    ++of_set.patches;
    for (const std::uint32_t base :
         {markedInward(cells, all, ground, c),
          nextMarked(all.neighbors, ground, c.patch, Outer, max_vote_hops),
          markedAside(cells, ground, c, Right),
          markedAside(cells, ground, c, Left)})
      if (base != no_patch)
        ++(isLow(base, c) ? of_set.low : of_set.high);
  }
  const auto isGround = [&](const Candidate& c) {
    const Votes& of_set = votes[c.set];
    return of_set.patches >= min_set_patches && of_set.low > of_set.high;
  };
  for (const Candidate& c : candidates)
    ground[c.patch] = isGround(c);
  const std::size_t before = candidates.size();
  candidates.erase(std::remove_if(candidates.begin(), candidates.end(), isGround),
                   candidates.end());
  return candidates.size() < before;
}

/** Fits the plane of a patch to ground only, with slopes drawn to the mean there. */
void
fitToGround(const GroundPatches& all,
            const std::vector<char>& ground,
            std::size_t cell,
            float max_step,
            GroundPatch& patch)
{
  PlaneFit fit(patch);
  float slope_x = patch.slope_x, slope_y = patch.slope_y, count = 1.0f;
  for (const std::uint32_t at : all.neighbors[cell]) {
    if (at == no_patch || !ground[at] ||
        !patch.continuesTo(all.patches[at], surface_steps * max_step))
      continue;
    fit.add(all.patches[at]);
    slope_x += all.patches[at].slope_x;
    slope_y += all.patches[at].slope_y;
    count += 1.0f;
  }
  patch.slope_x = slope_x / count;
  patch.slope_y = slope_y / count;
  fit.run(prior_weight);
}

} // namespace

std::vector<char>
connectedGround(const GroundCells& cells,
                const GroundParameters& parameters,
                unsigned threads,
                GroundPatches& all)
{
  const float max_step = parameters.max_step;
  const std::size_t size = all.patches.size();
  const std::vector<char> level = levelPatches(cells, all, parameters.max_slope);
  const Continuations of = continuations(all, level, max_step);
  std::vector<CoarsePlane> coarse;
  if (cells.around)
    coarse = coarseGround(cells, all, level, max_step);
  const auto isNear = [&](std::size_t i) {
    const CoarsePlane plane =
        cells.around ? coarse[cells.bins[i] / bins_per_octave] : CoarsePlane();
    return plane.isNear(all.patches[i], max_step);
  };
  // A larger set may hang above the ground that the sensor stands on.
  const auto largestOf = [&](const std::vector<std::size_t>& set_of) {
    std::vector<std::size_t> sizes(size + 1, 0);
    for (std::size_t i = 0; i < size; ++i)
      if (level[i] && (!cells.below_sensor || isNear(i)))
        ++sizes[set_of[i]];
    const auto largest = std::max_element(sizes.begin(), sizes.end() - 1);
    return std::make_pair(static_cast<std::size_t>(largest - sizes.begin()), *largest);
  };
  const auto [first, first_size] = largestOf(of.set_of);
  const auto [wide, wide_size] = largestOf(of.wide_set_of);
  std::vector<char> ground(size, 0);
  if (first_size < min_set_patches)
    return ground;
  std::vector<Candidate> candidates;
  for (std::size_t line = 0; line < cells.lineCount(); ++line) {
    for (std::size_t i = cells.lines[line]; i < cells.lines[line + 1]; ++i) {
      // A ring climbs the side of a car as gently as ground rises, and one ring alone
      // does not tell: what is not near the ground in the large is left out.
      const bool is_wide = wide_size > 0 && of.wide_set_of[i] == wide;
      if (!level[i] || (cells.around && !is_wide && !isNear(i)))
        continue;
      if (of.set_of[i] == first)
        ground[i] = 1;
      else
        candidates.push_back({i, line, of.set_of[i]});
    }
  }
  while (addLowSets(cells, all, coarse, parameters, candidates, ground)) {
  }
  std::vector<GroundPatch> fitted = all.patches;
  forEachCell(cells, threads, [&](std::size_t i) {
    if (ground[i])
      fitToGround(all, ground, i, max_step, fitted[i]);
  });
  all.patches = std::move(fitted);
  return ground;
}

std::array<std::uint32_t, 5>
nearGround(const GroundPatches& all, const std::vector<char>& ground, std::size_t cell)
{
  const auto next = [&](PatchSide side) {
    return nextMarked(all.neighbors, ground, cell, side, max_hops);
  };
  return {ground[cell] ? static_cast<std::uint32_t>(cell) : no_patch,
          next(Inner),
          next(Outer),
          next(Right),
          next(Left)};
}

} // namespace pcl::segmentation
