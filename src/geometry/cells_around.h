// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// The cells of space around some places, to leave most other points out at once.

#pragma once

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace pcl::segmentation {

/** \brief Cells of space that hold all points nearer than a reach to some places. */
class CellsAround {
public:
  /** \param[in] reach meters, not negative
   * \param[in] cells in the reach: the more, the fewer other points are held
   * \param[in] places about how many will be added */
  explicit CellsAround(double reach, int cells = 1, std::size_t places = 1000)
  : cells_(static_cast<float>(cells))
  , cells_per_meter_(1.0f / std::max(static_cast<float>(wider * reach / cells),
                                     std::numeric_limits<float>::min()))
  {
    // 3 % of the slots are marked, unless that would be more than 2 MB.
    const double marks = std::pow(2.0 * cells + 1.0, 3) * static_cast<double>(places);
    while (bits_ < 24 && std::ldexp(1.0, bits_) < 32.0 * marks)
      ++bits_;
    is_marked_.resize(std::size_t{1} << bits_);
  }

  void
  add(const Eigen::Vector3f& place)
  {
    const Eigen::Array3f cell = cellOf(place);
    for (float x = -cells_; x <= cells_; ++x)
      for (float y = -cells_; y <= cells_; ++y)
        for (float z = -cells_; z <= cells_; ++z)
          is_marked_[slotOf(cell + Eigen::Array3f(x, y, z))] = true;
  }

  /** \brief False only of a point that is no nearer than the reach to any place. */
  bool
  mayHold(const Eigen::Vector3f& point) const
  {
    // So far from the origin more is rounded than cells are wider.
    constexpr float far = 0x1p16f;
    const Eigen::Array3f cell = cellOf(point);
    return !(cell.abs() < far).all() || is_marked_[slotOf(cell)];
  }

private:
  static constexpr double wider = 1.01; // than the reach: what is rounded is not missed

  Eigen::Array3f
  cellOf(const Eigen::Vector3f& place) const
  {
    return (place.array() * cells_per_meter_).floor();
  }

  /** Cells may share a slot. */
  std::size_t
  slotOf(const Eigen::Array3f& cell) const
  {
    constexpr float most = 0x1p30f;
    const Eigen::Array3i c = cell.max(-most).min(most).cast<int>();
    std::uint64_t hash = 0;
    for (int axis = 0; axis < 3; ++axis)
      hash = (hash ^ static_cast<std::uint32_t>(c[axis])) * 0x9e3779b97f4a7c15U;
    return static_cast<std::size_t>(hash >> (64 - bits_));
  }

  float cells_; ///< in the reach
  float cells_per_meter_;
  int bits_ = 4;
  std::vector<bool> is_marked_; ///< each slot
};

} // namespace pcl::segmentation
