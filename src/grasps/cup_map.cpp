// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// PURPOSE

#include "grasps/cup_map.h"

#include "geometry/distance_map.h"

#include <algorithm>
#include <cmath>

namespace pcl::segmentation {
namespace {

using Eigen::Vector2f;
using Eigen::Vector3f;

// doc/grasps.md has the reason of each number.
constexpr float half_width = 3.0f;     // of the image, in radii, beside margin and hole
constexpr float most_clearance = 2.0f; // in radii
constexpr float free_way = 2.0f;       // before the surface, in radii
constexpr float cells_per_spacing = 2.0f;
constexpr float most_cells = 16.0f; // in a radius
constexpr float least_hole = 2.0f;  // cells
constexpr float margin_spacings = 1.0f;

} // namespace

float
Clearance::least(float margin) const
{
  return std::min({border - margin, edge, obstacle - margin});
}

CupMap::CupMap(const TargetSurface& surface, const SurfaceFit& fit, float radius)
: radius_(radius)
, margin_(margin_spacings * fit.spacing)
, cell_(std::max(fit.spacing / cells_per_spacing, radius / most_cells))
, hole_(std::max(fit.spacing, least_hole * cell_))
, band_(toleranceOf(surface.noise(), fit.spacing, radius).band)
, half_(static_cast<int>(std::ceil((half_width * radius + margin_ + hole_) / cell_)))
, side_(2 * half_ + 1)
{
  const auto cells = static_cast<std::size_t>(side_) * static_cast<std::size_t>(side_);
  is_surface_.resize(cells);
  is_edge_.resize(cells);
  is_obstacle_.resize(cells);
  mark(surface, fit);
  measure();
}

bool
CupMap::cellOf(float x, float y, std::size_t& cell) const
{
  const float width = (static_cast<float>(half_) + 0.5f) * cell_;
  if (!(std::abs(x) < width && std::abs(y) < width))
    return false;
  const auto column = static_cast<std::size_t>((x + width) / cell_);
  const auto row = static_cast<std::size_t>((y + width) / cell_);
  const auto last = static_cast<std::size_t>(side_ - 1);
  cell = std::min(row, last) * static_cast<std::size_t>(side_) + std::min(column, last);
  return true;
}

void
CupMap::mark(const TargetSurface& surface, const SurfaceFit& fit)
{
  const float width = (static_cast<float>(half_) + 0.5f) * cell_;
  const float reach = std::hypot(width, free_way * radius_);
  std::size_t cell = 0;
  const auto above = [&](const Vector3f& local) {
    return local.z() - fit.height(local.x(), local.y());
  };
  const auto bandAt = [&](const Vector3f& local) {
    return band_ * std::max(1.0f, local.head<2>().norm() / radius_);
  };
  const auto markObstacle = [&](const Vector3f& local) {
    const float height = above(local);
    if (height > bandAt(local) && height < free_way * radius_)
      is_obstacle_[cell] = 1;
  };
  surface.forEachWithin(fit.origin, reach, [&](std::uint32_t i, float) {
    const auto& point = surface.points()[i];
    const Vector3f local = fit.toLocal(point.position);
    if (!cellOf(local.x(), local.y(), cell))
      return;
    if (std::abs(above(local)) > bandAt(local)) {
      markObstacle(local);
      return;
    }
    is_surface_[cell] = 1;
    if (point.is_edge)
      is_edge_[cell] = 1;
  });
  surface.forEachOther(fit.origin, reach, [&](const Vector3f& position) {
    const Vector3f local = fit.toLocal(position);
    if (cellOf(local.x(), local.y(), cell))
      markObstacle(local);
  });
}

void
CupMap::measure()
{
  const std::vector<float> to_surface = distancesTo(is_surface_, side_);
  std::vector<char> is_hole;
  is_hole.reserve(to_surface.size());
  for (const float cells : to_surface)
    is_hole.push_back(cells * cell_ > hole_ ? 1 : 0);
  border_ = distancesTo(is_hole, side_);
  edge_ = distancesTo(is_edge_, side_);
  obstacle_ = distancesTo(is_obstacle_, side_);
  const float most = most_clearance * radius_ + margin_;
  for (float& distance : border_)
    distance = std::clamp(distance * cell_ - hole_, 0.0f, most);
  for (auto* distances : {&edge_, &obstacle_})
    for (float& distance : *distances)
      distance = std::min(distance * cell_, most);
}

Clearance
CupMap::at(float x, float y) const
{
  std::size_t cell = 0;
  return cellOf(x, y, cell) ? Clearance{border_[cell], edge_[cell], obstacle_[cell]}
                            : Clearance{};
}

Vector2f
CupMap::clearestPlace() const
{
  const int reach = static_cast<int>(radius_ / cell_);
  float best = at(0.0f, 0.0f).least(margin_) + cell_;
  Vector2f place = Vector2f::Zero();
  bool is_moved = false;
  for (int row = half_ - reach; row <= half_ + reach; ++row)
    for (int column = half_ - reach; column <= half_ + reach; ++column) {
      const Vector2f candidate(center(column), center(row));
      if (candidate.norm() > radius_)
        continue;
      const float clearance = at(candidate.x(), candidate.y()).least(margin_);
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
