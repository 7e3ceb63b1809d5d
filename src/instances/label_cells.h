// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Coarse cells of space and whether they hold one label, to pass over most points.

#pragma once

#include "geometry/point_grid.h"

#include <Eigen/Core>

#include <cstdint>
#include <unordered_map>
#include <vector>

namespace pcl::segmentation {

/** \brief Which label each coarse cell has: most are inside of a face. */
class LabelCells {
public:
  /** \param[in] labels of the points, -1 none
   * \param[in] cell the size of a cell, several times that of the boxes asked for */
  LabelCells(const XYZView& points, const std::vector<std::int32_t>& labels, float cell)
  : cell_(cell)
  {
    std::int32_t* last = nullptr; // the next point is mostly in the same cell
    std::uint64_t last_key = 0;
    for (std::size_t i = 0; i < labels.size(); ++i) {
      if (labels[i] < 0)
        continue;
      const std::uint64_t key = keyOf(cellOf(positionOf(points, i)));
      if (!last || key != last_key)
        last = &labels_.try_emplace(key, labels[i]).first->second;
      last_key = key;
      if (*last != labels[i])
        *last = several;
    }
  }

  /** \brief Whether a point with another label may be in a box around a place. */
  bool
  mayHaveOther(const Eigen::Vector3f& position, float reach, std::int32_t label) const
  {
    constexpr float but_rounding = 1.001f; // far more than floats are off
    const Eigen::Vector3f half = Eigen::Vector3f::Constant(but_rounding * reach);
    const Eigen::Array3i low = cellOf(position - half);
    const Eigen::Array3i high = cellOf(position + half);
    if (((high - low) > 1).any())
      return true;
    for (int z = low.z(); z <= high.z(); ++z)
      for (int y = low.y(); y <= high.y(); ++y)
        for (int x = low.x(); x <= high.x(); ++x) {
          const auto found = labels_.find(keyOf({x, y, z}));
          if (found != labels_.end() && found->second != label)
            return true;
        }
    return false;
  }

private:
  static constexpr std::int32_t several = -1;
  // Of a key; what is farther shares the last cells.
  static constexpr int axis_bits = 21;

  Eigen::Array3i
  cellOf(const Eigen::Vector3f& position) const
  {
    constexpr float far = 0x1p20f - 1.0f;
    return (position.array() / cell_).floor().max(-far).min(far).cast<int>();
  }

  static std::uint64_t
  keyOf(const Eigen::Array3i& cell)
  {
    std::uint64_t key = 0;
    for (int axis = 0; axis < 3; ++axis)
      key = (key << axis_bits) |
            static_cast<std::uint64_t>(cell[axis] + (1 << (axis_bits - 1)));
    return key;
  }

  float cell_;
  std::unordered_map<std::uint64_t, std::int32_t> labels_;
};

} // namespace pcl::segmentation
