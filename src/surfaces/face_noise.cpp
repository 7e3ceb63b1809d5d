// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// By how much the nodes of smooth faces are off them, place by place.

#include "surfaces/face_noise.h"

#include "common/statistics.h"

#include <algorithm>
#include <cstddef>
#include <map>
#include <set>

namespace pcl::segmentation {
namespace {

constexpr std::size_t min_residuals = 20; // of which a quartile is worth something
constexpr double share = 0.25;
// Of the cloud fewer: where a solid is crowded, most large windows hold several faces,
// and those that hold one tell the noise.
constexpr double share_of_cloud = 0.1;
// The least of few residuals are so by chance.
constexpr std::uint64_t min_rank = 2;
// Where all faces are rough, or all are parts of one solid, the cloud's noise bounds
// it.
constexpr float min_of_cloud = 0.6f;
constexpr float max_of_cloud = 2.0f;

using Residuals = std::map<Cell, std::vector<float>>;

template <typename Visit>
void
forEachAround(const Cell& place, const Visit& visit)
{
  for (int x = -1; x <= 1; ++x)
    for (int y = -1; y <= 1; ++y)
      for (int z = -1; z <= 1; ++z)
        visit(Cell{place[0] + x, place[1] + y, place[2] + z});
}

float
noiseAt(const Cell& place, const Residuals& residuals, float of_cloud)
{
  std::vector<float> near;
  forEachAround(place, [&](const Cell& around) {
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
  const auto rank = [&](double of_all) {
    return static_cast<std::uint64_t>(of_all * static_cast<double>(residuals));
  };
  return std::max(rank(share_of_cloud), std::min(rank(share), min_rank));
}

float
noiseOfCloud(const FaceFits& fits)
{
  std::vector<float> all;
  for (const std::optional<FaceFit>& fit : fits)
    if (fit)
      all.push_back(fit->residual);
  if (all.empty())
    return 0.0f;
  const auto at = all.begin() + static_cast<std::ptrdiff_t>(rankOfNoise(all.size()));
  std::nth_element(all.begin(), at, all.end());
  return *at;
}

std::vector<bool>
nodesAround(const FaceLevel& level, const std::vector<bool>& chosen, float spacing)
{
  const auto cell = static_cast<float>(noiseCell(level.cell, spacing));
  std::set<Cell> of_chosen, places;
  for (std::size_t i = 0; i < chosen.size(); ++i)
    if (chosen[i])
      of_chosen.insert(cellOf(level.nodes[i].position.data(), cell));
  for (const Cell& place : of_chosen)
    forEachAround(place, [&](const Cell& around) { places.insert(around); });
  std::vector<bool> around(chosen.size());
  for (std::size_t i = 0; i < chosen.size(); ++i)
    around[i] = places.count(cellOf(level.nodes[i].position.data(), cell)) > 0;
  return around;
}

std::vector<float>
faceNoise(const FaceLevel& level, const FaceFits& fits, float spacing, float of_cloud)
{
  const auto cell = static_cast<float>(noiseCell(level.cell, spacing));
  Residuals residuals;
  for (std::size_t i = 0; i < fits.size(); ++i)
    if (fits[i])
      residuals[cellOf(level.nodes[i].position.data(), cell)].push_back(
          fits[i]->residual);
  std::map<Cell, float> known;
  std::vector<float> noise;
  noise.reserve(fits.size());
  for (const FaceNode& node : level.nodes) {
    const Cell place = cellOf(node.position.data(), cell);
    auto found = known.find(place);
    if (found == known.end())
      found = known.emplace(place, noiseAt(place, residuals, of_cloud)).first;
    noise.push_back(found->second);
  }
  return noise;
}

} // namespace pcl::segmentation
