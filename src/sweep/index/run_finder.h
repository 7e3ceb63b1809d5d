// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Finds the runs of clusters that lie within a distance of a box.

#pragma once

#include "sweep/index/row_index.h"
#include "sweep/portable/targets.h"

namespace pcl::kernels {

/** \brief Finds the runs of clusters that lie within a distance of a box.
 *
 * Meant for boxes that come in the order of the rows: the runs of one box are where the
 * search for the next one starts.
 */
class RunFinder {
public:
  explicit RunFinder(const RowIndex& surface) : surface_(surface) {}

  /** \brief Runs, in sorted order, that hold every point within `reach` of the box. */
  const std::vector<ClusterRun>& find(const Box& box, double reach);

private:
  struct Window {
    std::int32_t z_first, z_last, y_first, y_last;
  };

  /** \brief A row of the window, and the last run in it. */
  struct NearRow {
    double y_min, y_max, z_min, z_max;
    std::uint32_t begin, end; ///< its clusters
    ClusterRun cursor;
  };

  Window windowOf(const Box& box, double far) const;

  void selectRows(const Window& window);

  const RowIndex& surface_;
  const KernelTable& kernels_ = chosenKernels();
  Window window_{1, 0, 1, 0};
  std::vector<NearRow> rows_;
  std::vector<ClusterRun> runs_;
};

} // namespace pcl::kernels
