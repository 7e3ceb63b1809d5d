/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * Point Cloud Library (PCL) - www.pointclouds.org
 * Copyright (c) 2026, pcl_shape contributors
 *
 * All rights reserved
 */

#include "ground_neighbors.h"

#include "../kernels/parallel.h"

#include <algorithm>

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

} // namespace pcl::segmentation
