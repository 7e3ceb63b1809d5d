// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// PURPOSE

#include "ground/ground_patches.h"

#include "common/parallel.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>

namespace pcl::segmentation {
namespace {

/** A surface may continue as far away as its own range: 16 cells of 4 % around a
 * laser. */
constexpr std::uint32_t most_bins_apart = 16;

/** Patches on lines beside each other are neighbors if they are so near. */
constexpr std::uint32_t most_bins_beside = 4;

/** The cells that have a surface, line by line. */
struct Surfaces {
  std::vector<std::size_t> cells;
  std::vector<std::size_t> lines; ///< the first one of each line, and end

  Surfaces(const GroundCells& all, const std::vector<char>& has_surface)
  {
    for (std::size_t line = 0; line < all.lineCount(); ++line) {
      lines.push_back(cells.size());
      for (std::size_t i = all.lines[line]; i < all.lines[line + 1]; ++i)
        if (has_surface[i])
          cells.push_back(i);
    }
    lines.push_back(cells.size());
  }
};

std::uint32_t
binsApart(const GroundCells& cells, std::size_t a, std::size_t b)
{
  return cells.bins[a] < cells.bins[b] ? cells.bins[b] - cells.bins[a]
                                       : cells.bins[a] - cells.bins[b];
}

/** For each cell of a line the surface of another line that is nearest, if it is near.
 */
void
findBeside(const GroundCells& cells,
           const Surfaces& surfaces,
           std::size_t line,
           std::size_t other,
           PatchSide side,
           std::vector<PatchNeighbors>& neighbors)
{
  const std::size_t end = surfaces.lines[other + 1];
  std::size_t at = surfaces.lines[other];
  const auto apart = [&](std::size_t surface, std::size_t cell) {
    return binsApart(cells, surfaces.cells[surface], cell);
  };
  for (std::size_t i = cells.lines[line]; i < cells.lines[line + 1] && at < end; ++i) {
    while (at + 1 < end && apart(at + 1, i) < apart(at, i))
      ++at;
    if (apart(at, i) <= most_bins_beside)
      neighbors[i][side] = static_cast<std::int32_t>(surfaces.cells[at]);
  }
}

void
findNeighbors(const GroundCells& cells,
              const Surfaces& surfaces,
              std::size_t line,
              std::vector<PatchNeighbors>& neighbors)
{
  const std::size_t lines = cells.lineCount(), end = surfaces.lines[line + 1];
  std::size_t next = surfaces.lines[line]; // the first surface behind the cell
  const auto link = [&](std::size_t cell, std::size_t surface, PatchSide side) {
    if (binsApart(cells, surfaces.cells[surface], cell) <= most_bins_apart)
      neighbors[cell][side] = static_cast<std::int32_t>(surfaces.cells[surface]);
  };
  for (std::size_t i = cells.lines[line]; i < cells.lines[line + 1]; ++i) {
    neighbors[i] = {no_patch, no_patch, no_patch, no_patch};
    if (next > surfaces.lines[line])
      link(i, next - 1, Inner);
    if (next < end && surfaces.cells[next] == i)
      ++next;
    if (next < end)
      link(i, next, Outer);
  }
  if (line > 0 || cells.around)
    findBeside(cells, surfaces, line, (line + lines - 1) % lines, Right, neighbors);
  if (line + 1 < lines || cells.around)
    findBeside(cells, surfaces, line, (line + 1) % lines, Left, neighbors);
}

/** The marked patch of a line that is nearest to a bin, within reach. */
std::int32_t
markedInLine(const GroundCells& cells,
             const std::vector<char>& marks,
             std::size_t line,
             std::uint32_t bin)
{
  std::int32_t best = no_patch;
  std::uint32_t least = most_bins_apart + 1;
  const auto first = cells.bins.begin() + cells.lines[line];
  const auto last = cells.bins.begin() + cells.lines[line + 1];
  const std::uint32_t low = bin < most_bins_apart ? 0 : bin - most_bins_apart;
  for (auto at = std::lower_bound(first, last, low);
       at != last && *at <= bin + most_bins_apart;
       ++at) {
    const auto i = static_cast<std::size_t>(at - cells.bins.begin());
    const std::uint32_t apart = *at < bin ? bin - *at : *at - bin;
    if (marks[i] && apart < least) {
      least = apart;
      best = static_cast<std::int32_t>(i);
    }
  }
  return best;
}

} // namespace

std::vector<PatchNeighbors>
patchNeighbors(const GroundCells& cells,
               const std::vector<char>& has_surface,
               unsigned threads)
{
  std::vector<PatchNeighbors> neighbors(cells.size());
  const Surfaces surfaces(cells, has_surface);
  kernels::parallelFor(cells.lineCount(), threads, [&](std::size_t line) {
    findNeighbors(cells, surfaces, line, neighbors);
  });
  return neighbors;
}

std::int32_t
nextMarked(const std::vector<PatchNeighbors>& neighbors,
           const std::vector<char>& marks,
           std::size_t from,
           PatchSide side,
           int most)
{
  std::int32_t at = neighbors[from][side];
  for (int hop = 1; at != no_patch && !marks[static_cast<std::size_t>(at)]; ++hop)
    at = hop < most ? neighbors[static_cast<std::size_t>(at)][side] : no_patch;
  return at;
}

std::int32_t
markedAside(const GroundCells& cells,
            const std::vector<char>& marks,
            std::size_t line,
            std::uint32_t bin,
            bool to_left,
            int most)
{
  const std::size_t lines = cells.lineCount();
  for (int hop = 0; hop < most; ++hop) {
    if (!cells.around && line == (to_left ? lines - 1 : 0))
      break;
    line = (line + (to_left ? 1 : lines - 1)) % lines;
    const std::int32_t found = markedInLine(cells, marks, line, bin);
    if (found != no_patch)
      return found;
  }
  return no_patch;
}

namespace {

// Points nearer to a line than 1/100 of their distances do not tell a plane.
constexpr float least_determinant = 1e-4f;
constexpr float turn = 0.01f; // that a plane may be off, per metre
// By how much ground may leave its own plane, per metre: 0.6 m at 20 m, as on a crest
// with a radius of 330 m.
constexpr float bend = 0.03f;

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
         std::int32_t one,
         std::int32_t other)
{
  const auto at = [&](std::int32_t i) {
    return i == no_patch ? nullptr : &low[static_cast<std::size_t>(i)];
  };
  const GroundPatch *a = at(one), *b = at(other);
  if (!a || !b)
    return a ? a : b;
  return steepness(patch, *a) <= steepness(patch, *b) ? a : b;
}

} // namespace

float
mostRise(const GroundPatch& a, const GroundPatch& b, float max_step)
{
  return max_step + bend * std::hypot(b.x - a.x, b.y - a.y);
}

bool
continues(const GroundPatch& a, const GroundPatch& b, float max_step)
{
  return std::abs(a.above(b.x, b.y, b.z)) <= mostRise(a, b, max_step);
}

bool
fitPlane(GroundPatch& patch,
         const GroundPatch* const* others,
         std::size_t count,
         float prior_weight)
{
  // Around the patch: the plane need not go through it.
  float n = 1.0f, x = 0.0f, y = 0.0f, z = 0.0f;
  float xx = 0.0f, xy = 0.0f, yy = 0.0f, xz = 0.0f, yz = 0.0f;
  for (std::size_t i = 0; i < count; ++i) {
    const float dx = others[i]->x - patch.x, dy = others[i]->y - patch.y;
    const float dz = others[i]->low - patch.low;
    n += 1.0f;
    x += dx, y += dy, z += dz;
    xx += dx * dx, xy += dx * dy, yy += dy * dy;
    xz += dx * dz, yz += dy * dz;
  }
  x /= n, y /= n, z /= n;
  xx = xx / n - x * x + prior_weight;
  yy = yy / n - y * y + prior_weight;
  xy = xy / n - x * y;
  xz = xz / n - x * z + prior_weight * patch.slope_x;
  yz = yz / n - y * z + prior_weight * patch.slope_y;
  const float determinant = xx * yy - xy * xy;
  if (!(determinant > least_determinant * (xx + yy) * (xx + yy)))
    return false;
  patch.slope_x = (xz * yy - yz * xy) / determinant;
  patch.slope_y = (yz * xx - xz * xy) / determinant;
  patch.z = patch.low + z - patch.slope_x * x - patch.slope_y * y;
  return true;
}

bool
fitRobustly(const std::vector<GroundPatch>& low,
            const PatchNeighbors& neighbors,
            float near,
            GroundPatch& patch)
{
  const GroundPatch* const along =
      levelOne(low, patch, neighbors[Inner], neighbors[Outer]);
  const GroundPatch* const across =
      levelOne(low, patch, neighbors[Right], neighbors[Left]);
  if (!across)
    return false;
  const float weight = along ? 0.0f : prior_weight;
  std::array<const GroundPatch*, 4> others{across, along};
  if (!fitPlane(patch, others.data(), along ? 2 : 1, weight))
    return false;
  std::size_t count = 0;
  for (const std::int32_t neighbor : neighbors) {
    if (neighbor == no_patch)
      continue;
    const GroundPatch& other = low[static_cast<std::size_t>(neighbor)];
    const float distance = std::abs(other.x - patch.x) + std::abs(other.y - patch.y);
    if (std::abs(patch.above(other.x, other.y, other.low)) < near + turn * distance)
      others[count++] = &other;
  }
  fitPlane(patch, others.data(), count, weight);
  return true;
}

namespace {

// A surface is as thick: above the noise, below a low kerb.
constexpr float thickness_steps = 0.25f;
constexpr float paper_bin = 0.157f; // 9 degrees: of 10 bins over 90

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
    constexpr float most = 1LL << 40; // of a point that is far beyond all others
    return static_cast<std::int64_t>(std::clamp(value * units, -most, most));
  };
  std::int64_t count = 0, x = 0, y = 0, z = 0;
  for (std::size_t i = begin; i < end; ++i) {
    if (!feet[i] && cells.z[i] - low < thickness_steps * max_step) {
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

struct Normal {
  float x, y, z;
};

Normal
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
  const Normal n = normalOf(all.patches[patch]);
  std::array<float, 4> angles{};
  std::size_t count = 0;
  for (const std::int32_t other : all.neighbors[patch]) {
    if (other == no_patch || !has_plane[static_cast<std::size_t>(other)])
      continue;
    const Normal m = normalOf(all.patches[static_cast<std::size_t>(other)]);
    angles[count++] = std::sqrt((n.x - m.x) * (n.x - m.x) + (n.y - m.y) * (n.y - m.y) +
                                (n.z - m.z) * (n.z - m.z));
  }
  if (count == 0)
    return 0.0f;
  std::sort(angles.begin(), angles.begin() + static_cast<std::ptrdiff_t>(count));
  const std::size_t half = (count + 1) / 2;
  const float mean = std::accumulate(angles.begin(), angles.begin() + half, 0.0f) /
                     static_cast<float>(half);
  const float bins = mean / paper_bin;
  return 1.0f / (1.0f + bins * bins);
}

} // namespace

GroundPatches
groundPatches(const GroundCells& cells,
              const std::vector<char>& feet,
              const GroundParameters& parameters,
              unsigned threads)
{
  GroundPatches all;
  all.patches.resize(cells.size());
  std::vector<GroundPatch> low(cells.size());
  std::vector<char> has_surface(cells.size()), has_plane(cells.size());
  forEachCell(cells, threads, [&](std::size_t i) {
    const auto found = lowestSurface(cells, feet, i, parameters.max_step);
    has_surface[i] = found.has_value();
    low[i] = found.value_or(GroundPatch());
  });
  all.neighbors = patchNeighbors(cells, has_surface, threads);
  forEachCell(cells, threads, [&](std::size_t i) {
    all.patches[i] = low[i];
    has_plane[i] = has_surface[i] && fitRobustly(low,
                                                 all.neighbors[i],
                                                 thickness_steps * parameters.max_step,
                                                 all.patches[i]);
  });
  forEachCell(cells, threads, [&](std::size_t i) {
    all.patches[i].planar = has_plane[i] ? planarLikelihood(all, has_plane, i) : 0.0f;
  });
  return all;
}

} // namespace pcl::segmentation
