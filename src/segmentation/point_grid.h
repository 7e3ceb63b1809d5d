/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * Point Cloud Library (PCL) - www.pointclouds.org
 * Copyright (c) 2026, pcl_shape contributors
 *
 * All rights reserved
 */

#pragma once

#include <pcl/features/neighborhood_sweep.h>

#include <Eigen/Core>

#include <cstdint>
#include <vector>

namespace pcl::segmentation {

/** \brief Points in cells of space, to visit those within a radius. Unlike the sweep it
 * answers one query at a time, for the few points that need their neighbors one by one.
 *
 * Points are visited in an order given by their coordinates alone. */
class PointGrid {
public:
  /** \param[in] points those that are not finite are left out
   * \param[in] cell the size of a cell, about the radius of the queries */
  PointGrid(const XYZView& points, float cell);

  /** \brief visit(index, squared distance) for the points nearer than the radius. */
  template <typename Visit>
  void
  forEachWithin(const Eigen::Vector3f& center, float radius, const Visit& visit) const
  {
    const Eigen::Array3i low = cellOf(center.array() - radius);
    const Eigen::Array3i high = cellOf(center.array() + radius);
    const float r2 = radius * radius;
    for (int z = low.z(); z <= high.z(); ++z) {
      for (int y = low.y(); y <= high.y(); ++y) {
        const std::uint64_t last = keyOf(high.x(), y, z);
        for (std::size_t c = firstCell(keyOf(low.x(), y, z));
             c < keys_.size() && keys_[c] <= last;
             ++c) {
          for (std::uint32_t i = begins_[c]; i < begins_[c + 1]; ++i) {
            const float d2 = (positions_[i] - center).squaredNorm();
            if (d2 < r2) {
              visit(indices_[i], d2);
            }
          }
        }
      }
    }
  }

private:
  static std::uint64_t
  keyOf(int x, int y, int z)
  {
    constexpr int bits = 21;
    return (static_cast<std::uint64_t>(z) << (2 * bits)) |
           (static_cast<std::uint64_t>(y) << bits) | static_cast<std::uint64_t>(x);
  }

  /** The cell of a position, the nearest one of the grid if it is outside. */
  Eigen::Array3i cellOf(const Eigen::Array3f& position) const;

  /** The first cell whose key is not less. */
  std::size_t firstCell(std::uint64_t key) const;

  Eigen::Array3f origin_ = Eigen::Array3f::Zero();
  Eigen::Array3f last_ = Eigen::Array3f::Zero(); ///< of the cells
  float cell_ = 1.0f;
  std::vector<std::uint64_t> keys_;    ///< of the cells with points, ascending
  std::vector<std::uint32_t> begins_;  ///< of each cell in positions_, and the end
  std::vector<std::uint32_t> indices_; ///< of the points, cell by cell
  std::vector<Eigen::Vector3f> positions_;
};

inline Eigen::Vector3f
positionOf(const XYZView& points, std::size_t i)
{
  return Eigen::Map<const Eigen::Vector3f>(points[i]);
}

} // namespace pcl::segmentation
