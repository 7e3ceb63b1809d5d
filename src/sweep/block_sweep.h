// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Walks over the queries block by block, each with the surface points around it.

#pragma once

#include "common/parallel.h"
#include "sweep/index/run_finder.h"
#include "sweep/portable/neighborhood.h"

namespace pcl::kernels {

/** \brief What to walk over: surface and queries sorted with the same edge. */
struct BlockSweep {
  const RowIndex& surface;
  const RowIndex& queries;
  NeighborhoodSize neighborhood;  ///< radii are by position among the queries given
  bool queries_on_surface = true; ///< each query is a surface point
  bool rows_by_radius = false;    ///< the rows' width follows from the radius alone
  const UnitNormals* normals = nullptr; ///< of the surface, or null

  /** \brief visit(block, order): order[i] is the position of the block's query i.
   * Blocks that repeat the one before are left out (forEachRepeat()). */
  template <typename Visit>
  void
  forEachBlock(unsigned threads, const Visit& visit) const
  {
    constexpr std::size_t blocks_per_task = 64; // a thousand queries
    const std::size_t count = queries.clusters.size();
    parallelFor(
        (count + blocks_per_task - 1) / blocks_per_task, threads, [&](std::size_t t) {
          RunFinder finder(surface);
          double reach = queries.edge;
          const std::size_t end = std::min(count, (t + 1) * blocks_per_task);
          for (std::size_t b = t * blocks_per_task; b < end;) {
            const BlockGroup group = groupFrom(b, end);
            // For k, with room for blocks that are a little less dense.
            const double group_reach =
                neighborhood.k > 0 ? 1.25 * reach : largestRadius(group);
            const auto& runs = finder.find(group.box, group_reach);
            bool same_runs = true;
            for (; same_runs && b < group.end; ++b) {
              if (repeatsTheOneBefore(b))
                continue;
              SweepBlock block = queriesOf(b);
              block.runs = runs.data();
              block.run_count = runs.size();
              if (neighborhood.k > 0) {
                reach = std::min(reach, group_reach);
                same_runs = findNearest(block, finder, reach);
              }
              visit(block, queries.order.data() + queries.clusters.begin[b]);
            }
          }
        });
  }

  /** \brief visit(position, same): the query at this position has the result of the
   * one at the position `same`, which was visited. */
  template <typename Visit>
  void
  forEachRepeat(const Visit& visit) const
  {
    const auto& begin = queries.clusters.begin;
    std::uint32_t same = 0;
    for (std::size_t b = 0; b < queries.clusters.size(); ++b) {
      if (!repeatsTheOneBefore(b))
        same = queries.order[begin[b]];
      else
        for (std::uint32_t i = begin[b]; i < begin[b + 1]; ++i)
          visit(queries.order[i], same);
    }
  }

private:
  /** \brief Whether all queries of a block, and of the one before, are at one place,
   * and nothing else tells them apart either: many points at one place are looked at
   * once, or their cost would grow with the square of their number. */
  bool repeatsTheOneBefore(std::size_t block) const;

  /** \brief Blocks [begin, end) that are close enough together to share runs: kernels
   * look at each of their clusters anyway. */
  struct BlockGroup {
    std::size_t begin, end;
    Box box;
  };

  BlockGroup groupFrom(std::size_t first, std::size_t end) const;

  Box boxOf(std::size_t block) const;

  SweepBlock queriesOf(std::size_t block) const;

  double largestRadius(const BlockGroup& group) const;

  /** \brief The k nearest of a block whose runs reach that far.
   * \param[in,out] reach how far to look: about as far for the next block
   * \return false if that was not far enough: the finder's runs are others */
  bool findNearest(SweepBlock& block, RunFinder& finder, double& reach) const;
};

} // namespace pcl::kernels
