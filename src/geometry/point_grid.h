// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Points in cells of space, to visit those around a place.

#pragma once

#include <pcl/features/xyz_view.h>

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cstdint>
#include <numeric>
#include <utility>
#include <vector>

namespace pcl::segmentation {

/** \brief The box that holds points. */
struct Bounds {
  Eigen::Array3f low, high; ///< low above high if there is none

  static Bounds of(const XYZView& points);
};

/** \brief Points in cells of space, to visit those within a radius. Unlike the sweep it
 * answers one query at a time, for the few points that need their neighbors one by one.
 *
 * Points are visited in an order given by their coordinates alone. */
class PointGrid {
public:
  /** \param[in] points those that are not finite are left out; each may be as far from
   * the others as floats allow
   * \param[in] cell the size of a cell, about the radius of the queries
   *
   * Cells begin at multiples of their size: a part of a cloud visits its points in the
   * order of the whole. If points are so far apart that cells between them do not fit,
   * only slabs of space with points are numbered. If millions of points are each far
   * from all others, even these numbers take more than the 64 bits of a key: then cells
   * grow, and a part may visit points in another order. */
  PointGrid(const XYZView& points, float cell, unsigned threads = 1);

  /** \brief visit(index, squared distance) for the points nearer than the radius. */
  template <typename Visit>
  void
  forEachWithin(const Eigen::Vector3f& center, float radius, const Visit& visit) const
  {
    const float r2 = radius * radius;
    // Local: what is written might be a member.
    const Eigen::Vector3f middle = center;
    const Eigen::Vector3f* const positions = positions_.data();
    const std::uint32_t* const indices = indices_.data();
    forEachRangeWithin(
        middle, radius, [=, &visit](std::uint32_t begin, std::uint32_t end) {
          for (std::uint32_t i = begin; i < end; ++i) {
            const float d2 = (positions[i] - middle).squaredNorm();
            if (d2 < r2)
              visit(indices[i], d2);
          }
        });
  }

  /** \brief Whether is(index, position) for one of the points nearer than the radius;
   * those after it are not asked. */
  template <typename Is>
  bool
  anyWithin(const Eigen::Vector3f& center, float radius, const Is& is) const
  {
    const float r2 = radius * radius;
    return anyRangeWithin(center, radius, [&](std::uint32_t begin, std::uint32_t end) {
      for (std::uint32_t i = begin; i < end; ++i)
        if ((positions_[i] - center).squaredNorm() < r2 &&
            is(indices_[i], positions_[i]))
          return true;
      return false;
    });
  }

  /** \brief visit(begin, end) for ranges of order() that hold all points nearer than
   * the radius, and others; in the order of forEachWithin(). */
  template <typename Visit>
  void
  forEachRangeWithin(const Eigen::Vector3f& center,
                     float radius,
                     const Visit& visit) const
  {
    anyRangeWithin(center, radius, [&](std::uint32_t begin, std::uint32_t end) {
      visit(begin, end);
      return false;
    });
  }

  /** \brief The indices of the points, cell by cell. */
  const std::vector<std::uint32_t>&
  order() const
  {
    return indices_;
  }

  /** \brief The grid of the points in their order(), made of this one. */
  PointGrid
  renumbered() &&
  {
    std::iota(indices_.begin(), indices_.end(), 0U);
    return std::move(*this);
  }

private:
  struct CellBox {
    Eigen::Array3i low, high; ///< low above high if there is no cell with points
  };

  template <typename Is>
  bool
  anyRangeWithin(const Eigen::Vector3f& center, float radius, const Is& is) const
  {
    const auto& [low, high] = cellsAround(center, radius);
    if (low.x() > high.x())
      return false;
    for (int z = low.z(); z <= high.z(); ++z)
      for (int y = low.y(); y <= high.y(); ++y) {
        const CellRange cells = cellsOf(low.x(), high.x(), y, z);
        if (cells.begin < cells.end && is(begins_[cells.begin], begins_[cells.end]))
          return true;
      }
    return false;
  }

  std::uint64_t
  keyOf(int x, int y, int z) const
  {
    return (static_cast<std::uint64_t>(z) << z_shift_) |
           (static_cast<std::uint64_t>(y) << y_shift_) | static_cast<std::uint64_t>(x);
  }

  /** \return whether the box has few enough cells */
  bool countCells(const Bounds& bounds);

  /** Let cells keep their size, however far apart points are.
   * \return whether that was possible */
  bool numberSlabs(const XYZView& points);

  /** The cell of a position: of a point, if slabs are numbered; otherwise of any, and
   * the nearest one if it is outside of the box. */
  Eigen::Array3i cellOf(const Eigen::Array3f& position) const;

  CellBox cellsAround(const Eigen::Vector3f& center, float radius) const;

  struct CellRange {
    std::size_t begin, end;
  };

  /** The cells with points from one x to another. */
  CellRange
  cellsOf(int low_x, int high_x, int y, int z) const
  {
    CellRange cells{0, keys_.size()};
    if (!rows_.empty()) {
      if (z < first_row_[1] || z > last_row_[1] || y < first_row_[0] ||
          y > last_row_[0])
        return {0, 0};
      const std::size_t row = rowOf(y, z);
      cells = {rows_[row], rows_[row + 1]};
    }
    if (cells.begin == cells.end)
      return cells;
    const std::size_t low = firstFrom(keyOf(low_x, y, z), cells);
    const std::uint64_t last_key = keyOf(high_x, y, z);
    std::size_t high = low; // mostly few cells later
    while (high < cells.end && keys_[high] <= last_key)
      ++high;
    return {low, high};
  }

  /** The first cell of some with this key or a larger one. As keys are integers in
   * ascending order, only as many cells come into question as keys are left out. */
  std::size_t
  firstFrom(std::uint64_t key, const CellRange& cells) const
  {
    const std::uint64_t first_key = keys_[cells.begin], last_key = keys_[cells.end - 1];
    if (key <= first_key)
      return cells.begin;
    if (key > last_key)
      return cells.end;
    const std::uint64_t last = cells.end - 1 - cells.begin;
    std::uint64_t low = last - std::min(last, last_key - key);
    std::uint64_t count = std::min(last, key - first_key) - low;
    while (count > 0) { // no branch waits for a key
      const std::uint64_t half = (count + 1) / 2;
      low += keys_[cells.begin + low + half - 1] < key ? half : 0;
      count -= half;
    }
    return cells.begin + low;
  }

  /** The place of a row of cells among those from the first to the last with points. */
  std::size_t
  rowOf(int y, int z) const
  {
    return static_cast<std::size_t>(z - first_row_[1]) * row_count_ +
           static_cast<std::size_t>(y - first_row_[0]);
  }

  void findRows();

  Eigen::Array3f first_ = Eigen::Array3f::Zero(); ///< cell, from that at the origin
  Eigen::Array3f last_ = Eigen::Array3f::Zero();  ///< cell, from the first
  float cell_ = 1.0f;
  std::array<std::vector<float>, 3> slabs_; ///< those with points, if far apart
  int y_shift_ = 21, z_shift_ = 42;         ///< in the key of a cell
  std::vector<std::uint64_t> keys_;         ///< of the cells with points, ascending
  std::vector<std::uint32_t> rows_; ///< the first cell of each row, unless too many
  std::size_t row_count_ = 0;       ///< for each z
  std::array<int, 2> first_row_{}, last_row_{}; ///< y and z of cells with points
  std::vector<std::uint32_t> begins_;  ///< of each cell in positions_, and the end
  std::vector<std::uint32_t> indices_; ///< of the points, cell by cell
  std::vector<Eigen::Vector3f> positions_;
};

/** \brief The view of the `position` of each item; nothing is copied. */
template <typename Item>
XYZView
positionsOf(const std::vector<Item>& items)
{
  return {items.empty() ? nullptr : items[0].position.data(),
          sizeof(Item) / sizeof(float),
          items.size()};
}

inline Eigen::Vector3f
positionOf(const XYZView& points, std::size_t i)
{
  return Eigen::Map<const Eigen::Vector3f>(points[i]);
}

} // namespace pcl::segmentation
