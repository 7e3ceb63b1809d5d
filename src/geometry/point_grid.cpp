// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Points in cells of space, to visit those around a place.

#include "geometry/point_grid.h"

#include "common/finite.h"
#include "geometry/cell_order.h"
#include "geometry/point_choice.h"

#include <limits>

namespace pcl::segmentation {
namespace {

constexpr float max_cells = 0x1p20f;      // in each direction: a key has 21 bits for it
constexpr std::size_t max_rows = 1 << 16; // and one for each point: little memory

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

PointGrid::PointGrid(const XYZView& points, float cell, unsigned threads)
: PointGrid(points, cell, Bounds::of(points), threads)
{}

PointGrid::PointGrid(const XYZView& points,
                     float cell,
                     const Bounds& bounds,
                     unsigned threads)
: cell_(cell)
{
  const auto& [low, high] = bounds;
  begins_.push_back(0);
  if (!(low <= high).all())
    return;
  origin_ = low;
  // Halves: the difference of two floats may be beyond all floats.
  const Eigen::Array3f half_extent = 0.5f * high - 0.5f * low;
  cell_ = std::max(cell_, half_extent.maxCoeff() / (0.5f * max_cells));
  last_ = (half_extent / (0.5f * cell_)).floor();

  std::vector<CellPoint> sorted;
  sorted.reserve(points.size);
  for (std::size_t i = 0; i < points.size; ++i)
    if (kernels::isFinite(points[i])) {
      const Eigen::Array3i c = cellOf(positionOf(points, i).array());
      sorted.push_back({{c.z(), c.y(), c.x()}, static_cast<std::uint32_t>(i)});
    }
  sortByCell(sorted, threads);
  indices_.reserve(sorted.size());
  positions_.reserve(sorted.size());
  forEachCell(sorted, [&](const auto begin, const auto end) {
    std::sort(begin, end, [&](const CellPoint& a, const CellPoint& b) {
      return isBefore(points, a.point, b.point);
    });
    keys_.push_back(keyOf(begin->cell[2], begin->cell[1], begin->cell[0]));
    for (auto at = begin; at != end; ++at) {
      indices_.push_back(at->point);
      positions_.push_back(positionOf(points, at->point));
    }
    begins_.push_back(static_cast<std::uint32_t>(indices_.size()));
  });
  findRows();
}

Eigen::Array3i
PointGrid::cellOf(const Eigen::Array3f& position) const
{
  const Eigen::Array3f cell = ((position - origin_) / cell_).floor();
  return cell.max(0.0f).min(last_).cast<int>();
}

void
PointGrid::findRows()
{
  if (keys_.empty())
    return;
  const auto yz = [&](std::size_t c) {
    return std::array<int, 2>{
        static_cast<int>((keys_[c] >> axis_bits) & ((1U << axis_bits) - 1)),
        static_cast<int>(keys_[c] >> (2 * axis_bits))};
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
