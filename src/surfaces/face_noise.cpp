// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// By how much the nodes of smooth faces are off them, place by place.

#include "surfaces/face_noise.h"

#include "common/statistics.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

namespace pcl::segmentation {
namespace {

// Cells this large are wider than most objects' faces, and 27 of them hold several; a
// depth camera's noise differs little across them. Larger windows need larger cells.
constexpr float cell_spacings = 24.0f;
constexpr float cells_per_node = 4.0f;
constexpr std::size_t min_residuals = 20; // of which a quartile is worth something
constexpr double share = 0.25;
// Where all faces are rough, or all are parts of one solid, the cloud's noise bounds
// it.
constexpr float least_of_cloud = 0.6f;
constexpr float most_of_cloud = 2.0f;

using Place = std::array<int, 3>;
using Residuals = std::map<Place, std::vector<float>>;

Place
placeOf(const Eigen::Vector3f& position, float cell)
{
  constexpr float far = 1 << 30;
  Place place;
  for (int axis = 0; axis < 3; ++axis)
    place[static_cast<std::size_t>(axis)] =
        static_cast<int>(std::clamp(std::floor(position[axis] / cell), -far, far));
  return place;
}

float
noiseAt(const Place& place, const Residuals& residuals, float of_cloud)
{
  std::vector<float> near;
  for (int x = -1; x <= 1; ++x)
    for (int y = -1; y <= 1; ++y)
      for (int z = -1; z <= 1; ++z) {
        const auto found = residuals.find({place[0] + x, place[1] + y, place[2] + z});
        if (found != residuals.end())
          near.insert(near.end(), found->second.begin(), found->second.end());
      }
  if (near.size() < min_residuals)
    return of_cloud;
  return std::clamp(quantile(std::move(near), share),
                    least_of_cloud * of_cloud,
                    most_of_cloud * of_cloud);
}

} // namespace

std::vector<float>
faceNoise(const FaceLevel& level,
          const std::vector<std::optional<FaceFit>>& fits,
          float spacing)
{
  const float cell = std::max(cell_spacings * spacing, cells_per_node * level.cell);
  Residuals residuals;
  std::vector<float> all;
  for (std::size_t i = 0; i < fits.size(); ++i)
    if (fits[i]) {
      residuals[placeOf(level.nodes[i].position, cell)].push_back(fits[i]->residual);
      all.push_back(fits[i]->residual);
    }
  const float of_cloud = all.empty() ? 0.0f : quantile(std::move(all), share);
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
