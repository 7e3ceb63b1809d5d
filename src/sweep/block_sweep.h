// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// PURPOSE

#pragma once

#include "common/parallel.h"
#include "sweep/index/row_index.h"
#include "sweep/index/run_finder.h"
#include "sweep/portable/neighborhood.h"
#include "sweep/sweep_block.h"

#include <vector>

namespace pcl::kernels {

/** \brief Walks over the queries' clusters with the surface points around them. */
class BlockSweep {
public:
  /** \param[in] surface, queries sorted with the same edge
   * \param[in] neighborhood radii are by position among the queries given to the index
   */
  BlockSweep(const RowIndex& surface,
             const RowIndex& queries,
             const NeighborhoodSize& neighborhood,
             const KernelTable& kernels);

  void
  setNormals(const UnitNormals& normals)
  {
    normals_ = &normals;
  }

  void
  setQueriesOnSurface(bool on_surface)
  {
    on_surface_ = on_surface;
  }

  void
  setRowsByRadius(bool by_radius)
  {
    rows_by_radius_ = by_radius;
  }

  /** \brief visit(block, order): order[i] is the position of the block's query i. */
  template <typename Visit>
  void
  forEachBlock(unsigned threads, const Visit& visit) const
  {
    constexpr std::size_t blocks_a_task = 64;
    const std::size_t count = queries_.clusters.size();
    parallelFor(
        (count + blocks_a_task - 1) / blocks_a_task, threads, [&](std::size_t t) {
          RunFinder finder(surface_, kernels_);
          double reach = queries_.edge;
          const std::size_t end = std::min(count, (t + 1) * blocks_a_task);
          const auto visitBlock = [&](std::size_t b, SweepBlock& block) {
            visit(block, queries_.order.data() + queries_.clusters.begin[b]);
          };
          for (std::size_t b = t * blocks_a_task; b < end;) {
            const BlockGroup group = groupFrom(b, end);
            const double group_reach =
                neighborhood_.k > 0 ? 1.25 * reach : largestRadius(group);
            const auto& runs = finder.find(group.box, group_reach);
            bool same_runs = true;
            for (; same_runs && b < group.end; ++b) {
              SweepBlock block = queriesOf(b);
              block.runs = runs.data();
              block.run_count = runs.size();
              if (neighborhood_.k > 0) {
                reach = std::min(reach, group_reach);
                same_runs = findNearest(block, finder, reach);
              }
              visitBlock(b, block);
            }
          }
        });
  }

private:
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

  const RowIndex& surface_;
  const RowIndex& queries_;
  NeighborhoodSize neighborhood_;
  const KernelTable& kernels_;
  const UnitNormals* normals_ = nullptr;
  bool on_surface_ = true;
  bool rows_by_radius_ = false;
};

} // namespace pcl::kernels
