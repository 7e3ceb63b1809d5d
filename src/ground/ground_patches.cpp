// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// The lowest surface of each cell, its plane, and how planar it is.

#include "ground/ground_patches.h"

#include <optional>

namespace pcl::segmentation {

std::uint32_t
nearestInLine(const GroundCells& cells,
              const std::vector<char>& marks,
              std::size_t line,
              std::uint32_t bin,
              std::uint32_t max_bins)
{
  const std::uint32_t end = cells.lines[line + 1];
  const auto first = std::lower_bound(cells.bins.begin() + cells.lines[line],
                                      cells.bins.begin() + end,
                                      std::max(bin, max_bins) - max_bins);
  std::uint32_t best = no_patch, min_apart = max_bins + 1;
  for (auto i = static_cast<std::uint32_t>(first - cells.bins.begin());
       i < end && cells.bins[i] <= bin + max_bins;
       ++i) {
    const std::uint32_t apart =
        std::max(cells.bins[i], bin) - std::min(cells.bins[i], bin);
    if (marks[i] && apart < min_apart) {
      min_apart = apart;
      best = i;
    }
  }
  return best;
}

void
PlaneFit::add(const GroundPatch& other)
{
  const float dx = other.x - patch_.x, dy = other.y - patch_.y;
  const float dz = other.low - patch_.low;
  n_ += 1.0f;
  x_ += dx, y_ += dy, z_ += dz;
  xx_ += dx * dx, xy_ += dx * dy, yy_ += dy * dy;
  xz_ += dx * dz, yz_ += dy * dz;
}

bool
PlaneFit::run(float weight)
{
  // Points nearer to a line than 1/100 of their distances do not define a plane.
  constexpr float min_determinant = 1e-4f;
  const float x = x_ / n_, y = y_ / n_, z = z_ / n_;
  const float xx = xx_ / n_ - x * x + weight;
  const float yy = yy_ / n_ - y * y + weight;
  const float xy = xy_ / n_ - x * y;
  const float xz = xz_ / n_ - x * z + weight * patch_.slope_x;
  const float yz = yz_ / n_ - y * z + weight * patch_.slope_y;
  const float determinant = xx * yy - xy * xy;
  if (!(determinant > min_determinant * (xx + yy) * (xx + yy)))
    return false;
  patch_.slope_x = (xz * yy - yz * xy) / determinant;
  patch_.slope_y = (yz * xx - xz * xy) / determinant;
  patch_.z = patch_.low + z - patch_.slope_x * x - patch_.slope_y * y;
  return true;
}

bool
PlaneFit::isSpread() const
{
  constexpr float min_determinant = 0.055f; // (1/4)^2 / (1 + (1/4)^2)^2
  const float x = x_ / n_, y = y_ / n_;
  const float xx = xx_ / n_ - x * x, yy = yy_ / n_ - y * y, xy = xy_ / n_ - x * y;
  return xx * yy - xy * xy > min_determinant * (xx + yy) * (xx + yy);
}

namespace {

// Patches on lines beside each other are neighbors up to a fifth of their range.
constexpr std::uint32_t max_bins_beside = 4;
constexpr float paper_bin = 0.157f; // 9 degrees: of 10 bins over 90

/** The neighbors of the cells of a line, whether or not these have a surface. */
void
findNeighbors(const GroundCells& cells,
              const std::vector<char>& has_surface,
              std::size_t line,
              std::vector<PatchNeighbors>& neighbors)
{
  const std::uint32_t begin = cells.lines[line], end = cells.lines[line + 1];
  std::uint32_t nearest = no_patch;
  const auto link = [&](std::uint32_t i, PatchSide side) {
    const bool is_near =
        nearest != no_patch && std::max(cells.bins[i], cells.bins[nearest]) -
                                       std::min(cells.bins[i], cells.bins[nearest]) <=
                                   max_bins_apart;
    neighbors[i][side] = is_near ? nearest : no_patch;
    if (has_surface[i])
      nearest = i;
  };
  for (std::uint32_t i = begin; i < end; ++i)
    link(i, Inner);
  nearest = no_patch;
  for (std::uint32_t i = end; i > begin; --i)
    link(i - 1, Outer);
  const std::size_t lines = cells.lineCount();
  const auto linkBeside = [&](std::size_t other, PatchSide side) {
    for (std::uint32_t i = begin; i < end; ++i)
      neighbors[i][side] =
          nearestInLine(cells, has_surface, other, cells.bins[i], max_bins_beside);
  };
  if (line > 0 || cells.around)
    linkBeside((line + lines - 1) % lines, Right);
  if (line + 1 < lines || cells.around)
    linkBeside((line + 1) % lines, Left);
}

/** The mean of the points near the lowest one that carries nothing, if there is one not
 * far above the bottom of the cell. Sums are of whole numbers: the order of the points
 * does not matter. */
std::optional<GroundPatch>
lowestSurface(const GroundCells& cells,
              const std::vector<char>& feet,
              std::size_t cell,
              float max_step)
{
  const std::size_t begin = cells.begins[cell], end = cells.begins[cell + 1];
  constexpr float none = std::numeric_limits<float>::infinity();
  float bottom = none, low = none;
  for (std::size_t i = begin; i < end; ++i) {
    bottom = std::min(bottom, cells.z[i]);
    low = feet[i] ? low : std::min(low, cells.z[i]);
  }
  if (!(low - bottom < max_step))
    return std::nullopt;
  const float unit = cells.extent / (1 << 24), units = 1.0f / unit;
  const auto whole = [units](float value) {
    constexpr float limit = 1LL << 40; // of a point that is far beyond all others
    return static_cast<std::int64_t>(std::clamp(value * units, -limit, limit));
  };
  std::int64_t count = 0, x = 0, y = 0, z = 0;
  for (std::size_t i = begin; i < end; ++i) {
    if (!feet[i] && cells.z[i] - low < surface_steps * max_step) {
      ++count;
      x += whole(cells.x[i]);
      y += whole(cells.y[i]);
      z += whole(cells.z[i] - low);
    }
  }
  const float share = unit / static_cast<float>(count);
  GroundPatch patch;
  patch.x = static_cast<float>(x) * share;
  patch.y = static_cast<float>(y) * share;
  patch.z = patch.low = low + static_cast<float>(z) * share;
  return patch;
}

/** How steep the way from a patch to another one is. */
float
steepness(const GroundPatch& from, const GroundPatch& to)
{
  return std::abs(to.low - from.low) /
         std::max(std::hypot(to.x - from.x, to.y - from.y),
                  std::numeric_limits<float>::min());
}

/** Of the neighbors on opposite sides the one that is reached less steeply: where the
 * surface ends on one side, the other one still tells its slope. */
const GroundPatch*
levelOne(const std::vector<GroundPatch>& low,
         const GroundPatch& patch,
         std::uint32_t one,
         std::uint32_t other)
{
  const GroundPatch* const a = one == no_patch ? nullptr : &low[one];
  const GroundPatch* const b = other == no_patch ? nullptr : &low[other];
  if (!a || !b)
    return a ? a : b;
  return steepness(patch, *a) <= steepness(patch, *b) ? a : b;
}

/** A plane through the patch and a neighbor in each of both directions, then one that
 * fits to all neighbors that it passes nearby. Where one line of points is all there
 * is, the ground is as level across it as in the large. What is nearer than the heights
 * of a patch's own points differ, as at the feet of a robot, tells little of its slope.
 * \return false if there is none */
bool
fitRobustly(const std::vector<GroundPatch>& low,
            const PatchNeighbors& neighbors,
            float near, ///< how far points of a surface are from it, meters
            GroundPatch& patch)
{
  const GroundPatch* const along =
      levelOne(low, patch, neighbors[Inner], neighbors[Outer]);
  const GroundPatch* const across =
      levelOne(low, patch, neighbors[Right], neighbors[Left]);
  if (!across)
    return false;
  const float weight = along ? 0.0f : prior_weight;
  PlaneFit first(patch);
  first.add(*across);
  if (along)
    first.add(*along);
  if (!first.run(weight))
    return false;
  PlaneFit second(patch);
  for (const std::uint32_t neighbor : neighbors) {
    if (neighbor == no_patch)
      continue;
    const GroundPatch& other = low[neighbor];
    const float distance = std::abs(other.x - patch.x) + std::abs(other.y - patch.y);
    if (std::abs(patch.above(other.x, other.y, other.low)) <
        near + plane_error * distance)
      second.add(other);
  }
  if (second.run(weight) && along && second.isSpread()) {
    patch.slope_x = patch.slope_y = 0.0f;
    second.run(near * near);
  }
  return true;
}

std::array<float, 3>
normalOf(const GroundPatch& patch)
{
  const float z = 1.0f / std::sqrt(1.0f + patch.slope_x * patch.slope_x +
                                   patch.slope_y * patch.slope_y);
  return {-patch.slope_x * z, -patch.slope_y * z, z};
}

/** The likelihood of a plane by the angles between its normal and its neighbors', of
 * which the larger half is left out: a surface may end there. Chords stand for the
 * angles: below 30 degrees they differ by a hundredth. */
float
planarLikelihood(const GroundPatches& all,
                 const std::vector<char>& has_plane,
                 std::size_t patch)
{
  const auto [nx, ny, nz] = normalOf(all.patches[patch]);
  float smallest = std::numeric_limits<float>::infinity(), second = smallest;
  int count = 0;
  for (const std::uint32_t other : all.neighbors[patch]) {
    if (other == no_patch || !has_plane[other])
      continue;
    const auto [mx, my, mz] = normalOf(all.patches[other]);
    const float angle = std::sqrt((nx - mx) * (nx - mx) + (ny - my) * (ny - my) +
                                  (nz - mz) * (nz - mz));
    second = std::min(second, std::max(smallest, angle));
    smallest = std::min(smallest, angle);
    ++count;
  }
  if (count == 0)
    return 0.0f;
  const float mean = count <= 2 ? smallest : (smallest + second) / 2.0f;
  const float bins = mean / paper_bin;
  return 1.0f / (1.0f + bins * bins);
}

} // namespace

GroundPatches
groundPatches(const GroundCells& cells,
              const std::vector<char>& feet,
              float max_step,
              unsigned threads)
{
  std::vector<GroundPatch> low(cells.size());
  std::vector<char> has_surface(cells.size()), has_plane(cells.size());
  forEachCell(cells, threads, [&](std::size_t i) {
    const auto found =
        cells.hangs[i] ? std::nullopt : lowestSurface(cells, feet, i, max_step);
    has_surface[i] = found.has_value();
    low[i] = found.value_or(GroundPatch());
  });
  PatchNeighbors none;
  none.fill(no_patch);
  GroundPatches all{low, std::vector<PatchNeighbors>(cells.size(), none)};
  kernels::parallelFor(cells.lineCount(), threads, [&](std::size_t line) {
    findNeighbors(cells, has_surface, line, all.neighbors);
  });
  forEachCell(cells, threads, [&](std::size_t i) {
    has_plane[i] =
        has_surface[i] &&
        fitRobustly(low, all.neighbors[i], surface_steps * max_step, all.patches[i]);
  });
  forEachCell(cells, threads, [&](std::size_t i) {
    all.patches[i].planar = has_plane[i] ? planarLikelihood(all, has_plane, i) : 0.0f;
  });
  return all;
}

} // namespace pcl::segmentation
