// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// The cells of space around some places, to leave most other points out at once.

#pragma once

#include <Eigen/Core>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace pcl::segmentation {

/** \brief Cells of space that hold all points nearer than their size to some places. */
class CellsAround {
public:
  /** \param[in] size of a cell, meters, positive */
  explicit CellsAround(float size) : size_(size), is_marked_(slots) {}

  void
  add(const Eigen::Vector3f& place)
  {
    const Eigen::Array3f cell = cellOf(place);
    for (float x = -1.0f; x <= 1.0f; ++x)
      for (float y = -1.0f; y <= 1.0f; ++y)
        for (float z = -1.0f; z <= 1.0f; ++z)
          is_marked_[slotOf(cell + Eigen::Array3f(x, y, z))] = true;
  }

  /** \brief False only of a point that is no nearer than the size to any place. */
  bool
  mayHold(const Eigen::Vector3f& point) const
  {
    // So far from the origin the next cell may have the same number.
    constexpr float far = 0x1p22f;
    const Eigen::Array3f cell = cellOf(point);
    return !(cell.abs() < far).all() || is_marked_[slotOf(cell)];
  }

private:
  static constexpr std::size_t slots = 1 << 20; // 1,000 places mark 3 % of them

  Eigen::Array3f
  cellOf(const Eigen::Vector3f& place) const
  {
    return (place.array() / size_).floor();
  }

  /** Cells may share a slot. */
  static std::size_t
  slotOf(const Eigen::Array3f& cell)
  {
    constexpr float most = 0x1p30f;
    const Eigen::Array3i c = cell.max(-most).min(most).cast<int>();
    std::uint64_t hash = 0;
    for (int axis = 0; axis < 3; ++axis)
      hash = (hash ^ static_cast<std::uint32_t>(c[axis])) * 0x9e3779b97f4a7c15U;
    return static_cast<std::size_t>(hash >> 44);
  }

  float size_;
  std::vector<bool> is_marked_; ///< each slot
};

} // namespace pcl::segmentation
