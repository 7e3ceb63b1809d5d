/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * Point Cloud Library (PCL) - www.pointclouds.org
 * Copyright (c) 2026, pcl_shape contributors
 *
 * All rights reserved
 */

#pragma once

#include "row_index.h"
#include "sweep_block.h"

#include <vector>

namespace pcl::kernels {

/** \brief The box of a block of queries. */
struct Box {
  float x_min, x_max, y_min, y_max, z_min, z_max;
};

/** \brief Finds the runs of surface points that lie within a distance of a box.
 *
 * Meant for boxes that come in the order of the rows: the runs of one box are where the
 * search for the next one starts.
 */
class RunFinder {
public:
  explicit RunFinder(const RowIndex& surface) : surface_(surface) {}

  /** \brief Runs, in sorted order, that hold every point within `reach` of the box. */
  const std::vector<Run>& find(const Box& box, double reach);

private:
  struct Window {
    std::int32_t z_first, z_last, y_first, y_last;
  };

  void selectRows(const Window& window);

  const RowIndex& surface_;
  Window window_{1, 0, 1, 0};
  std::vector<std::uint32_t> rows_; ///< positions of the rows in the window
  std::vector<Run> cursors_;        ///< the last run in each of these rows
  std::vector<Run> runs_;
};

} // namespace pcl::kernels
