// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// By how much the nodes of smooth faces are off them, place by place.

#include "surfaces/face_noise.h"

#include "common/statistics.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>

namespace pcl::segmentation {
namespace {

constexpr std::size_t min_residuals = 20; // of which a quartile is worth something
constexpr double share = 0.25;
// Where all faces are rough, or all are parts of one solid, the cloud's noise bounds
// it.
constexpr float min_of_cloud = 0.6f;
constexpr float max_of_cloud = 2.0f;

using Place = std::array<int, 3>;
using Residuals = std::map<Place, std::vector<float>>;

Place
placeOf(const Eigen::Vector3f& position, float cell)
{
  constexpr float far = 0x1p30f;
  Place place;
  for (int axis = 0; axis < 3; ++axis)
    place[static_cast<std::size_t>(axis)] =
        static_cast<int>(std::clamp(std::floor(position[axis] / cell), -far, far));
  return place;
}

template <typename Visit>
void
forEachAround(const Place& place, const Visit& visit)
{
  for (int x = -1; x <= 1; ++x)
    for (int y = -1; y <= 1; ++y)
      for (int z = -1; z <= 1; ++z)
        visit(Place{place[0] + x, place[1] + y, place[2] + z});
}

float
noiseAt(const Place& place, const Residuals& residuals, float of_cloud)
{
  std::vector<float> near;
  forEachAround(place, [&](const Place& around) {
    const auto found = residuals.find(around);
    if (found != residuals.end())
      near.insert(near.end(), found->second.begin(), found->second.end());
  });
  if (near.size() < min_residuals)
    return of_cloud;
  return std::clamp(quantile(std::move(near), share),
                    min_of_cloud * of_cloud,
                    max_of_cloud * of_cloud);
}

} // namespace

double
noiseCell(double cell, double spacing)
{
  return std::max(noise_cell_spacings * spacing, noise_cells_per_node * cell);
}

std::uint64_t
rankOfNoise(std::uint64_t residuals)
{
  return static_cast<std::uint64_t>(share * static_cast<double>(residuals));
}

float
noiseOfCloud(const FaceFits& fits)
{
  std::vector<float> all;
  for (const std::optional<FaceFit>& fit : fits)
    if (fit)
      all.push_back(fit->residual);
  return all.empty() ? 0.0f : quantile(std::move(all), share);
}

std::vector<bool>
nodesAround(const FaceLevel& level, const std::vector<bool>& chosen, float spacing)
{
  const auto cell = static_cast<float>(noiseCell(level.cell, spacing));
  std::set<Place> of_chosen, places;
  for (std::size_t i = 0; i < chosen.size(); ++i)
    if (chosen[i])
      of_chosen.insert(placeOf(level.nodes[i].position, cell));
  for (const Place& place : of_chosen)
    forEachAround(place, [&](const Place& around) { places.insert(around); });
  std::vector<bool> around(chosen.size());
  for (std::size_t i = 0; i < chosen.size(); ++i)
    around[i] = places.count(placeOf(level.nodes[i].position, cell)) > 0;
  return around;
}

std::vector<float>
faceNoise(const FaceLevel& level, const FaceFits& fits, float spacing, float of_cloud)
{
  const auto cell = static_cast<float>(noiseCell(level.cell, spacing));
  Residuals residuals;
  for (std::size_t i = 0; i < fits.size(); ++i)
    if (fits[i])
      residuals[placeOf(level.nodes[i].position, cell)].push_back(fits[i]->residual);
  std::map<Place, float> known;
  std::vector<float> noise;
  noise.reserve(fits.size());
  for (const FaceNode& node : level.nodes) {
    const Place place = placeOf(node.position, cell);
    auto found = known.find(place);
    if (found == known.end())
      found = known.emplace(place, noiseAt(place, residuals, of_cloud)).first;
    noise.push_back(found->second);
  }
  return noise;
}

} // namespace pcl::segmentation
