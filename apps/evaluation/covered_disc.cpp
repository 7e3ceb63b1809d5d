// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Looks for the nearest points in the cells of a grid.

#include "evaluation/covered_disc.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace pcl::app {
namespace {

using Eigen::Vector2d;
using Places = std::vector<Vector2d>;

constexpr double hole_spacings = 2.0;
constexpr double max_steps = 200.0; // across a disc; usually half spacings

/** The mean distance between points: the median over some of them, by the area that the
 * six nearest ones of each take. */
double
spacingOf(const Places& places)
{
  constexpr std::size_t nearest = 6, max_looked_at = 50;
  constexpr double pi = 3.14159265358979323846;
  const std::size_t step = (places.size() + max_looked_at - 1) / max_looked_at;
  std::vector<double> spacings, squares;
  for (std::size_t i = 0; i < places.size(); i += step) {
    squares.clear();
    for (const Vector2d& place : places)
      squares.push_back((place - places[i]).squaredNorm());
    std::nth_element(squares.begin(), squares.begin() + nearest, squares.end());
    spacings.push_back(std::sqrt(squares[nearest] * pi / nearest));
  }
  const auto middle =
      spacings.begin() + static_cast<std::ptrdiff_t>(spacings.size() / 2);
  std::nth_element(spacings.begin(), middle, spacings.end());
  return *middle;
}

/** Places sorted by square cells. */
class PlaceGrid {
public:
  /** \param[in] cell as large as the reach of hasNear() or larger */
  PlaceGrid(const Places& places, double cell) : cell_(cell)
  {
    Eigen::AlignedBox2d box;
    for (const Vector2d& place : places)
      box.extend(place);
    low_ = box.min();
    columns_ = columnOf(box.max().x()) + 1;
    rows_ = rowOf(box.max().y()) + 1;
    cells_.resize(static_cast<std::size_t>(columns_ * rows_));
    for (const Vector2d& place : places)
      cells_[indexOf(columnOf(place.x()), rowOf(place.y()))].push_back(place);
  }

  bool
  hasNear(const Vector2d& at, double reach) const
  {
    const std::ptrdiff_t column = columnOf(at.x()), row = rowOf(at.y());
    for (auto r = std::max<std::ptrdiff_t>(row - 1, 0);
         r <= std::min(row + 1, rows_ - 1);
         ++r)
      for (auto c = std::max<std::ptrdiff_t>(column - 1, 0);
           c <= std::min(column + 1, columns_ - 1);
           ++c)
        for (const Vector2d& place : cells_[indexOf(c, r)])
          if ((place - at).squaredNorm() < reach * reach)
            return true;
    return false;
  }

private:
  std::ptrdiff_t
  columnOf(double x) const
  {
    return static_cast<std::ptrdiff_t>(std::floor((x - low_.x()) / cell_));
  }

  std::ptrdiff_t
  rowOf(double y) const
  {
    return static_cast<std::ptrdiff_t>(std::floor((y - low_.y()) / cell_));
  }

  std::size_t
  indexOf(std::ptrdiff_t column, std::ptrdiff_t row) const
  {
    return static_cast<std::size_t>(row * columns_ + column);
  }

  double cell_;
  Vector2d low_;
  std::ptrdiff_t columns_ = 0, rows_ = 0;
  std::vector<Places> cells_;
};

} // namespace

bool
isCovered(const Places& places, double radius)
{
  if (places.size() < min_covering)
    return false;
  const double spacing = spacingOf(places);
  const double reach = hole_spacings * spacing;
  const double step = std::max(0.5 * spacing, 2.0 * radius / max_steps);
  // A little wider than the reach, whatever is rounded; no more cells than steps.
  const PlaceGrid grid(places, std::max(1.001 * reach, step));
  for (double x = -radius; x <= radius; x += step)
    for (double y = -radius; y <= radius; y += step)
      if (x * x + y * y <= radius * radius && !grid.hasNear({x, y}, reach))
        return false;
  return true;
}

} // namespace pcl::app
