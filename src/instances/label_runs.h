// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Labels in the order of a grid's points, to pass over ranges that have one only.

#pragma once

#include "geometry/point_grid.h"

#include <cstdint>
#include <vector>

namespace pcl::segmentation {

/** \brief Labels in the order of a grid's points. */
class LabelRuns {
public:
  LabelRuns(const PointGrid& grid, const std::vector<std::int32_t>& labels)
  : runs_(grid.order().size() + 1)
  {
    const auto size = static_cast<std::uint32_t>(grid.order().size());
    runs_.back() = {-1, size, size};
    for (std::uint32_t at = size; at-- > 0;) {
      const std::int32_t label = labels[grid.order()[at]];
      const Run& after = runs_[at + 1];
      runs_[at] = label < 0              ? after
                  : label == after.label ? Run{label, at, after.change}
                                         : Run{label, at, after.first};
    }
  }

  /** \brief Whether a range of the order has a label but this one; -1 is none. */
  bool
  hasOther(std::uint32_t begin, std::uint32_t end, std::int32_t label) const
  {
    const Run& run = runs_[begin];
    return run.first < end && (run.label != label || run.change < end);
  }

private:
  /** The first label from a place on, where it is, and where the next other one is. */
  struct Run {
    std::int32_t label;
    std::uint32_t first, change;
  };

  std::vector<Run> runs_;
};

} // namespace pcl::segmentation
