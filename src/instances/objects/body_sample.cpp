// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// What walls and floors a body has, by some of its points.

#include "instances/objects/body_sample.h"

#include "common/statistics.h"
#include "geometry/point_grid.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace pcl::segmentation {
namespace {

using detail::InstanceInput;
using Eigen::Vector3f;

constexpr std::size_t max_points = 500; // of a body: more change little

BodySample
sampleOf(const InstanceInput& input,
         const std::vector<std::uint32_t>& members,
         const Vector3f& up)
{
  const std::size_t step = (members.size() + max_points - 1) / max_points;
  BodySample body;
  std::vector<float> heights, spacings;
  for (std::size_t k = 0; k < members.size(); k += step) {
    body.points.push_back(positionOf(input.points, members[k]));
    body.normals.push_back(normalOf(input, members[k]));
    body.middle += body.points.back();
    body.facing += body.normals.back();
    heights.push_back(up.dot(body.points.back()));
    spacings.push_back(input.spacings[members[k]]);
    const float rise = up.dot(body.normals.back());
    body.upright += std::abs(rise) < max_upright ? 1.0f : 0.0f;
    body.level += rise >= max_upright ? 1.0f : 0.0f;
  }
  if (body.points.empty())
    return body;
  const auto count = static_cast<float>(body.points.size());
  body.middle /= count;
  body.facing /= count;
  body.upright /= count;
  body.level /= count;
  body.spacing = median(std::move(spacings));
  std::sort(heights.begin(), heights.end());
  body.low = heights[heights.size() / 20];
  body.high = heights[heights.size() - 1 - heights.size() / 20];
  return body;
}

} // namespace

std::vector<BodySample>
bodySamples(const InstanceInput& input,
            const Vector3f& up,
            const Labels& bodies,
            std::size_t count)
{
  std::vector<BodySample> samples;
  samples.reserve(count);
  for (const auto& members : membersInOrder(input, bodies, count, [&](std::uint32_t i) {
         return normalOf(input, i).allFinite();
       }))
    samples.push_back(sampleOf(input, members, up));
  return samples;
}

} // namespace pcl::segmentation
