// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// How far normals differ around some points of a cloud.

#include "features/normal_scatter.h"

#include "common/finite.h"
#include "common/parallel.h"
#include "common/statistics.h"
#include "geometry/cells_around.h"

#include <algorithm>
#include <utility>

namespace pcl::detail {
namespace {

using namespace segmentation;

constexpr float rounding =
    1.001f; // so that it does not decide whose normals are needed

/** The points that are nearer than a reach to chosen ones, and others. */
pcl::Indices
pointsNear(const pcl::Indices& chosen,
           const XYZView& points,
           float reach,
           unsigned threads)
{
  CellsAround cells(reach);
  for (const pcl::index_t i : chosen)
    cells.add(positionOf(points, static_cast<std::size_t>(i)));
  return kernels::collectForEach<pcl::index_t>(
      static_cast<std::uint32_t>(points.size),
      threads,
      [&](std::uint32_t i, pcl::Indices& near) {
        if (kernels::isFinite(points[i]) && cells.mayHold(positionOf(points, i)))
          near.push_back(static_cast<pcl::index_t>(i));
      });
}

} // namespace

NormalScatter::NormalScatter(const Neighborhoods& neighborhoods,
                             const std::vector<float>& spacings,
                             pcl::Indices chosen,
                             double most_radius,
                             unsigned threads)
: neighborhoods_(neighborhoods)
, spacings_(spacings)
, chosen_(std::move(chosen))
{
  if (chosen_.empty())
    return;
  std::vector<float> reaches = radiiOf(chosen_, most_radius);
  near_ = pointsNear(chosen_,
                     neighborhoods.input(),
                     rounding * *std::max_element(reaches.begin(), reaches.end()),
                     threads);
  places_ = placesOf(near_);
  chosen_among_near_ = positionsAmong(near_);
  const float cell = median(std::move(reaches));
  grid_.emplace(XYZView{places_.data()->data(), 3, places_.size()}, cell);
}

std::vector<float>
NormalScatter::operator()(double normal_radius, double radius) const
{
  if (chosen_.empty())
    return {};
  const std::vector<float> radii = radiiOf(chosen_, radius);
  const pcl::Indices near = neighborsOf(radii);
  const std::vector<float> normal_radii = radiiOf(near, normal_radius);
  std::vector<float> normals(4 * near.size());
  neighborhoods_.among(near).computeNormals(
      NeighborhoodSize::ofRadii(normal_radii.data()),
      normals.data(),
      normals.data() + 3,
      4);
  std::vector<float> mu_sigma(2 * chosen_.size());
  const std::vector<Eigen::Vector3f> places = placesOf(near);
  const XYZView cloud{places.data()->data(), 3, places.size()};
  const pcl::Indices chosen = positionsAmong(near);
  constexpr unsigned threads = 1; // for few points
  Neighborhoods(cloud, cloud, chosen, threads)
      .computeINAD(NeighborhoodSize::ofRadii(radii.data()),
                   {normals.data(), 4, near.size()},
                   0.0,
                   mu_sigma.data());
  std::vector<float> mu;
  for (std::size_t k = 0; k < chosen_.size(); ++k)
    mu.push_back(mu_sigma[2 * k]);
  return mu;
}

/** The chosen points, and those that their INAD needs the normals of. */
pcl::Indices
NormalScatter::neighborsOf(const std::vector<float>& radii) const
{
  std::vector<bool> is_needed(near_.size(), false);
  for (std::size_t k = 0; k < radii.size(); ++k) {
    const auto at = static_cast<std::size_t>(chosen_among_near_[k]);
    is_needed[at] = true; // even if squares of the radii are 0
    grid_->forEachWithin(places_[at], rounding * radii[k], [&](std::uint32_t i, float) {
      is_needed[i] = true;
    });
  }
  pcl::Indices needed;
  for (std::size_t i = 0; i < near_.size(); ++i)
    if (is_needed[i])
      needed.push_back(near_[i]);
  return needed;
}

std::vector<Eigen::Vector3f>
NormalScatter::placesOf(const pcl::Indices& points) const
{
  std::vector<Eigen::Vector3f> places;
  places.reserve(points.size());
  for (const pcl::index_t i : points)
    places.push_back(positionOf(neighborhoods_.input(), static_cast<std::size_t>(i)));
  return places;
}

/** Where the chosen points are among others that hold them, in ascending order. */
pcl::Indices
NormalScatter::positionsAmong(const pcl::Indices& points) const
{
  pcl::Indices positions;
  positions.reserve(chosen_.size());
  for (const pcl::index_t i : chosen_)
    positions.push_back(static_cast<pcl::index_t>(
        std::lower_bound(points.begin(), points.end(), i) - points.begin()));
  return positions;
}

std::vector<float>
NormalScatter::radiiOf(const pcl::Indices& indices, double count) const
{
  std::vector<float> radii;
  radii.reserve(indices.size());
  for (const pcl::index_t i : indices)
    radii.push_back(static_cast<float>(count) * spacings_[static_cast<std::size_t>(i)]);
  return radii;
}

} // namespace pcl::detail
