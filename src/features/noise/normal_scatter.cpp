// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// How far normals differ around some points of a cloud.

#include "features/noise/normal_scatter.h"

#include "common/gathered.h"
#include "common/statistics.h"
#include "features/spacing/local_spacing.h"

#include <algorithm>
#include <utility>

namespace pcl::detail {

using namespace segmentation;

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
  const double reach = *std::max_element(reaches.begin(), reaches.end());
  near_.emplace(neighborhoods.input(), chosen_, reach, 1, threads);
  grid_.emplace(near_->view(), median(std::move(reaches)), threads);
}

std::vector<float>
NormalScatter::operator()(double normal_radius, double radius) const
{
  if (chosen_.empty())
    return {};
  const std::vector<float> radii = radiiOf(chosen_, radius);
  const auto [needed, chosen] = neededFor(radii);
  const std::vector<float> normals = normalsWithCurvature(
      neighborhoods_.among(needed), radiiOf(needed, normal_radius));
  std::vector<float> mu_sigma(2 * chosen.size());
  const std::vector<float> positions = positionsAt(neighborhoods_.input(), needed);
  const XYZView cloud = viewOfPositions(positions);
  constexpr unsigned threads = 1; // for few points
  Neighborhoods(cloud, cloud, chosen, threads)
      .computeINAD(NeighborhoodSize::ofRadii(radii.data()),
                   {normals.data(), 4, needed.size()},
                   0.0,
                   mu_sigma.data());
  std::vector<float> mu;
  for (std::size_t k = 0; k < chosen.size(); ++k)
    mu.push_back(mu_sigma[2 * k]);
  return mu;
}

/** The chosen points, and those that their INAD needs the normals of. */
NormalScatter::Needed
NormalScatter::neededFor(const std::vector<float>& radii) const
{
  constexpr float rounding = 1.001f; // does not decide whose normals are needed
  const XYZView places = near_->view();
  std::vector<bool> is_needed(places.size, false);
  for (std::size_t k = 0; k < radii.size(); ++k) {
    const auto at = static_cast<std::size_t>(near_->some()[k]);
    is_needed[at] = true; // even if squares of the radii are 0
    grid_->forEachWithin(positionOf(places, at),
                         rounding * radii[k],
                         [&](std::uint32_t i, float) { is_needed[i] = true; });
  }
  Needed needed;
  for (std::size_t i = 0; i < places.size; ++i) {
    const std::size_t next = needed.chosen.size();
    if (next < radii.size() && near_->some()[next] == static_cast<pcl::index_t>(i))
      needed.chosen.push_back(static_cast<pcl::index_t>(needed.points.size()));
    if (is_needed[i])
      needed.points.push_back(near_->indices()[i]);
  }
  return needed;
}

std::vector<float>
NormalScatter::radiiOf(const pcl::Indices& points, double count) const
{
  return times(count, gathered(spacings_, points));
}

} // namespace pcl::detail
