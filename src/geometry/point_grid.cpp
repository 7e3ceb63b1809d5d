// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Points in cells of space, to visit those around a place.

#include "geometry/point_grid.h"

#include "common/finite.h"
#include "geometry/cell_loop.h"
#include "geometry/point_choice.h"

#include <cmath>
#include <limits>

namespace pcl::segmentation {
namespace {

constexpr float max_cells = 0x1p20f;      // in each direction: a key has 21 bits for it
constexpr std::size_t max_rows = 1 << 16; // and one for each point: little memory

/** The numbers of the slabs of space across an axis that have points, ascending. */
std::vector<float>
slabsOf(const XYZView& points, std::size_t axis, float cell)
{
  constexpr auto middle = static_cast<std::size_t>(max_cells);
  std::vector<bool> is_used(2 * middle); // near the origin, where most points are
  std::vector<float> slabs;
  for (std::size_t i = 0; i < points.size; ++i)
    if (kernels::isFinite(points[i])) {
      const float slab = std::floor(points[i][axis] / cell);
      if (std::abs(slab) < max_cells)
        is_used[static_cast<std::size_t>(slab + max_cells)] = true;
      else
        slabs.push_back(slab);
    }
  for (std::size_t s = 0; s < is_used.size(); ++s)
    if (is_used[s])
      slabs.push_back(static_cast<float>(s) - max_cells);
  std::sort(slabs.begin(), slabs.end());
  slabs.erase(std::unique(slabs.begin(), slabs.end()), slabs.end());
  return slabs;
}

int
bitsOf(std::size_t count)
{
  int bits = 0;
  for (; count > 0; count >>= 1)
    ++bits;
  return bits;
}

} // namespace

Bounds
Bounds::of(const XYZView& points)
{
  Eigen::Array3f low = Eigen::Array3f::Constant(std::numeric_limits<float>::infinity());
  Eigen::Array3f high = -low;
  for (std::size_t i = 0; i < points.size; ++i) {
    if (kernels::isFinite(points[i])) {
      low = low.min(positionOf(points, i).array());
      high = high.max(positionOf(points, i).array());
    }
  }
  return {low, high};
}

PointGrid::PointGrid(const XYZView& points, float cell, unsigned threads) : cell_(cell)
{
  begins_.push_back(0);
  const Bounds bounds = Bounds::of(points);
  if (!(bounds.low <= bounds.high).all())
    return;
  if (!countCells(bounds) && !numberSlabs(points)) {
    // Halves: the difference of two floats may be beyond all floats.
    const float half_extent = (0.5f * bounds.high - 0.5f * bounds.low).maxCoeff();
    cell_ = half_extent > 0.0f ? half_extent / (0.25f * max_cells) : 1.0f;
    countCells(bounds);
  }

  std::vector<CellPoint> sorted =
      sortedByCell(points, threads, [&](const float* p) -> Cell {
        const Eigen::Array3i c = cellOf(Eigen::Map<const Eigen::Array3f>(p));
        return {c.z(), c.y(), c.x()};
      });
  const std::vector<std::size_t> begins = beginsOfCells(sorted, threads);
  const std::size_t cells = begins.size() - 1;
  keys_.resize(cells);
  begins_.assign(begins.begin(), begins.end());
  indices_.resize(sorted.size());
  positions_.resize(sorted.size());
  forEachCell(
      sorted, begins, threads, [&](const auto begin, const auto end, std::size_t k) {
        std::sort(begin, end, [&](const CellPoint& a, const CellPoint& b) {
          return isBefore(points, a.point, b.point);
        });
        keys_[k] = keyOf(begin->cell[2], begin->cell[1], begin->cell[0]);
        for (auto at = begin; at != end; ++at) {
          const auto i = static_cast<std::size_t>(at - sorted.begin());
          indices_[i] = at->point;
          positions_[i] = positionOf(points, at->point);
        }
      });
  findRows();
}

bool
PointGrid::countCells(const Bounds& bounds)
{
  first_ = (bounds.low / cell_).floor();
  last_ = (bounds.high / cell_).floor() - first_;
  return (last_ < max_cells).all(); // and none is NaN
}

bool
PointGrid::numberSlabs(const XYZView& points)
{
  if (!(cell_ > 0.0f))
    return false;
  // From zero, where floats are finest. The cell of a point is the same in each part of
  // a cloud; its number tells how many slabs before it have points.
  std::array<int, 3> bits{};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    slabs_[axis] = slabsOf(points, axis, cell_);
    bits[axis] = bitsOf(slabs_[axis].size());
  }
  constexpr int key_bits = 64; // more: millions of points, each far from all others
  if (bits[0] + bits[1] + bits[2] > key_bits) {
    slabs_ = {};
    return false;
  }
  y_shift_ = bits[0];
  z_shift_ = bits[0] + bits[1];
  return true;
}

Eigen::Array3i
PointGrid::cellOf(const Eigen::Array3f& position) const
{
  if (!slabs_[0].empty())
    return cellsAround(position, 0.0f).low;
  const Eigen::Array3f cell = (position / cell_).floor() - first_;
  return cell.max(0.0f).min(last_).cast<int>();
}

PointGrid::CellBox
PointGrid::cellsAround(const Eigen::Vector3f& center, float radius) const
{
  const Eigen::Array3f low = center.array() - radius, high = center.array() + radius;
  if (slabs_[0].empty())
    return {cellOf(low), cellOf(high)};
  CellBox cells;
  for (int axis = 0; axis < 3; ++axis) {
    const std::vector<float>& slabs = slabs_[static_cast<std::size_t>(axis)];
    const auto first =
        std::lower_bound(slabs.begin(), slabs.end(), std::floor(low[axis] / cell_));
    const auto end =
        std::upper_bound(first, slabs.end(), std::floor(high[axis] / cell_));
    cells.low[axis] = static_cast<int>(first - slabs.begin());
    cells.high[axis] = static_cast<int>(end - slabs.begin()) - 1;
  }
  return cells;
}

void
PointGrid::findRows()
{
  if (keys_.empty())
    return;
  const auto yz = [&](std::size_t c) {
    return std::array<int, 2>{
        static_cast<int>((keys_[c] >> y_shift_) &
                         ((std::uint64_t{1} << (z_shift_ - y_shift_)) - 1)),
        static_cast<int>(keys_[c] >> z_shift_)};
  };
  first_row_ = last_row_ = yz(0);
  for (std::size_t c = 0; c < keys_.size(); ++c)
    for (std::size_t axis = 0; axis < 2; ++axis) {
      first_row_[axis] = std::min(first_row_[axis], yz(c)[axis]);
      last_row_[axis] = std::max(last_row_[axis], yz(c)[axis]);
    }
  row_count_ = static_cast<std::size_t>(last_row_[0] - first_row_[0]) + 1;
  const std::size_t rows =
      row_count_ * (static_cast<std::size_t>(last_row_[1] - first_row_[1]) + 1);
  if (rows > max_rows + indices_.size())
    return;
  rows_.reserve(rows + 1);
  for (std::size_t c = 0; c < keys_.size(); ++c) {
    const auto [y, z] = yz(c);
    while (rows_.size() <= rowOf(y, z))
      rows_.push_back(static_cast<std::uint32_t>(c));
  }
  rows_.resize(rows + 1, static_cast<std::uint32_t>(keys_.size()));
}

} // namespace pcl::segmentation
