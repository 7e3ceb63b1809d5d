// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// What a suction cup would touch at a place: borders, edges and obstacles around it.

#include "grasps/cup_map.h"

#include "geometry/distance_map.h"

#include <cmath>
#include <limits>

namespace pcl::segmentation {
namespace {

using Eigen::Vector2f;
using Eigen::Vector3f;

// Half the image, in radii, beside margin and hole: the clearance around each place
// within a radius.
constexpr float half_width = 3.0f;
constexpr float max_clearance = 2.0f; // in radii: more does not matter
constexpr float free_way = 2.0f;      // before the surface, in radii: the cup's way
constexpr float cells_per_spacing = 2.0f;
constexpr float max_cells = 16.0f;      // in a radius: bounds the image
constexpr float min_hole = 2.0f;        // cells: more than a gap between points
constexpr float margin_spacings = 1.0f; // by which a depth camera's outlines are ragged

} // namespace

CupMap::CupMap(const TargetSurface& surface, const SurfaceFit& fit, float radius)
: radius_(radius)
, margin_(margin_spacings * fit.spacing)
, cell_(std::max(fit.spacing / cells_per_spacing, radius / max_cells))
{
  // Where no point is nearer than the spacing, the surface has ended: a disc of this
  // radius has 12 points on average, and none by chance once in 160,000 times.
  const float hole = std::max(fit.spacing, min_hole * cell_);
  half_ = static_cast<int>(std::ceil((half_width * radius + margin_ + hole) / cell_));
  side_ = 2 * half_ + 1;
  const Marks marks = marksOf(surface, fit);
  std::vector<char> is_hole;
  for (const float cells : distancesTo(marks.surface, side_))
    is_hole.push_back(cells * cell_ > hole ? 1 : 0);
  border_ = distancesTo(is_hole, side_);
  edge_ = distancesTo(marks.edge, side_);
  obstacle_ = distancesTo(marks.obstacle, side_);
  const float limit = max_clearance * radius_ + margin_;
  for (float& distance : border_)
    distance = std::clamp(distance * cell_ - hole, 0.0f, limit);
  for (auto* distances : {&edge_, &obstacle_})
    for (float& distance : *distances)
      distance = std::min(distance * cell_, limit);
  // Where the cup leaks anyway, small holes do not matter.
  const Clearance here = at(0.0f, 0.0f);
  if (here.smallest(margin_) >= radius_)
    addGaps(gapsWithin(radius_ + margin_, pointsOf(surface, fit), fit.spacing));
}

std::vector<Vector2f>
CupMap::pointsOf(const TargetSurface& surface, const SurfaceFit& fit) const
{
  constexpr float beyond = 3.0f; // spacings around the cup, see gapsWithin()
  const float reach = radius_ + margin_ + beyond * fit.spacing;
  const float band = toleranceOf(surface.noise(), fit.spacing, radius_).band;
  std::vector<Vector2f> points;
  surface.forEachWithin(
      fit.origin, std::hypot(reach, reach), [&](std::uint32_t i, float) {
        const Vector3f local = fit.toLocal(surface.points()[i].position);
        const Vector2f place = local.head<2>();
        const float away = place.norm();
        const float above = local.z() - fit.height(place.x(), place.y());
        if (away <= reach && !(std::abs(above) > band * std::max(1.0f, away / radius_)))
          points.push_back(place);
      });
  return points;
}

void
CupMap::addGaps(const std::vector<Gap>& gaps)
{
  if (gaps.empty())
    return;
  float nearest = std::numeric_limits<float>::infinity();
  std::vector<char> is_gap(border_.size(), 0);
  for (const Gap& gap : gaps) {
    nearest = std::min(nearest, gap.distance());
    for (float y = -gap.radius; y <= gap.radius; y += cell_)
      for (float x = -gap.radius; x <= gap.radius; x += cell_)
        if (const auto cell = cellOf(gap.center.x() + x, gap.center.y() + y))
          if (std::hypot(x, y) <= gap.radius)
            is_gap[*cell] = 1;
    if (const auto cell = cellOf(gap.center.x(), gap.center.y()))
      is_gap[*cell] = 1;
  }
  float& here = border_[*cellOf(0.0f, 0.0f)]; // better known than to a cell
  const float exact = std::clamp(nearest, 0.0f, here);
  const std::vector<float> cells = distancesTo(is_gap, side_);
  for (std::size_t i = 0; i < border_.size(); ++i)
    border_[i] = std::min(border_[i], cells[i] * cell_);
  here = exact;
}

std::optional<std::size_t>
CupMap::cellOf(float x, float y) const
{
  const float width = (static_cast<float>(half_) + 0.5f) * cell_;
  if (!(std::abs(x) < width && std::abs(y) < width))
    return std::nullopt;
  const auto column = static_cast<std::size_t>((x + width) / cell_);
  const auto row = static_cast<std::size_t>((y + width) / cell_);
  const auto last = static_cast<std::size_t>(side_ - 1);
  return std::min(row, last) * static_cast<std::size_t>(side_) + std::min(column, last);
}

CupMap::Marks
CupMap::marksOf(const TargetSurface& surface, const SurfaceFit& fit) const
{
  const std::vector<char> none(
      static_cast<std::size_t>(side_) * static_cast<std::size_t>(side_), 0);
  Marks marks{none, none, none};
  const float width = (static_cast<float>(half_) + 0.5f) * cell_;
  const float reach = std::hypot(width, free_way * radius_);
  const float band = toleranceOf(surface.noise(), fit.spacing, radius_).band;
  const auto mark = [&](const Vector3f& position, bool is_target, bool is_edge) {
    const Vector3f local = fit.toLocal(position);
    const auto cell = cellOf(local.x(), local.y());
    if (!cell)
      return;
    const float above = local.z() - fit.height(local.x(), local.y());
    const float band_there = band * std::max(1.0f, local.head<2>().norm() / radius_);
    if (above > band_there && above < free_way * radius_)
      marks.obstacle[*cell] = 1;
    if (is_target && !(std::abs(above) > band_there)) {
      marks.surface[*cell] = 1;
      if (is_edge)
        marks.edge[*cell] = 1;
    }
  };
  surface.forEachWithin(fit.origin, reach, [&](std::uint32_t i, float) {
    mark(surface.points()[i].position, true, surface.points()[i].is_edge);
  });
  surface.forEachOther(fit.origin, reach, [&](const Vector3f& position) {
    mark(position, false, false);
  });
  return marks;
}

Clearance
CupMap::at(float x, float y) const
{
  const auto cell = cellOf(x, y);
  return cell ? Clearance{border_[*cell], edge_[*cell], obstacle_[*cell]} : Clearance{};
}

Vector2f
CupMap::clearestPlace() const
{
  const int reach = static_cast<int>(radius_ / cell_);
  float best = at(0.0f, 0.0f).smallest(margin_) + cell_;
  Vector2f place = Vector2f::Zero();
  bool is_moved = false;
  for (int row = half_ - reach; row <= half_ + reach; ++row)
    for (int column = half_ - reach; column <= half_ + reach; ++column) {
      const Vector2f candidate(center(column), center(row));
      if (candidate.norm() > radius_)
        continue;
      const float clearance = at(candidate.x(), candidate.y()).smallest(margin_);
      const bool is_nearer = is_moved && clearance == best &&
                             candidate.squaredNorm() < place.squaredNorm();
      if (clearance > best || is_nearer) {
        best = clearance;
        place = candidate;
        is_moved = true;
      }
    }
  return place;
}

float
CupMap::covered(float radius) const
{
  std::size_t inside = 0, free = 0;
  for (int row = 0; row < side_; ++row)
    for (int column = 0; column < side_; ++column)
      if (std::hypot(center(column), center(row)) <= radius) {
        ++inside;
        free += at(center(column), center(row)).border > 0.0f ? 1 : 0;
      }
  return static_cast<float>(free) / static_cast<float>(inside);
}

} // namespace pcl::segmentation
