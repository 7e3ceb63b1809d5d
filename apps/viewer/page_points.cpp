// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Chooses points by a hash of their values.

#include "viewer/page_points.h"

#include <pcl/common/point_tests.h>
#include <pcl/search/kdtree.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <tuple>
#include <utility>

namespace pcl::app {
namespace {

/** A bijection that scatters similar numbers (SplitMix64). */
std::uint64_t
mix(std::uint64_t value)
{
  value = (value ^ (value >> 30)) * 0xbf58476d1ce4e5b9U;
  value = (value ^ (value >> 27)) * 0x94d049bb133111ebU;
  return value ^ (value >> 31);
}

std::uint64_t
hashOf(const std::uint8_t* bytes, std::size_t size)
{
  constexpr std::uint64_t golden_ratio = 0x9e3779b97f4a7c15U;
  std::uint64_t hash = 0;
  for (std::size_t i = 0; i < size; ++i)
    hash = mix(hash + golden_ratio + bytes[i]);
  return hash;
}

/** The points, each place once. */
pcl::PointCloud<pcl::PointXYZ>::Ptr
placesOf(const pcl::PointCloud<pcl::PointXYZ>& points)
{
  const auto placeOf = [](const pcl::PointXYZ& point) {
    return std::tie(point.x, point.y, point.z);
  };
  auto places = points.makeShared();
  std::sort(places->begin(), places->end(), [&](const auto& a, const auto& b) {
    return placeOf(a) < placeOf(b);
  });
  const auto end =
      std::unique(places->begin(), places->end(), [&](const auto& a, const auto& b) {
        return placeOf(a) == placeOf(b);
      });
  places->resize(static_cast<std::size_t>(end - places->begin()));
  return places;
}

} // namespace

std::vector<std::size_t>
choosePoints(const CloudFile& cloud,
             const pcl::PointCloud<pcl::PointXYZ>& points,
             std::size_t max_points)
{
  // Points of one hash have the same values in all fields: which one comes first does
  // not show.
  std::vector<std::pair<std::uint64_t, std::size_t>> order;
  const std::size_t step = cloud.blob.point_step;
  for (std::size_t i = 0; i < points.size(); ++i)
    if (pcl::isXYZFinite(points[i]))
      order.emplace_back(hashOf(cloud.blob.data.data() + i * step, step), i);
  std::sort(order.begin(), order.end());
  order.resize(std::min(order.size(), max_points));
  std::vector<std::size_t> chosen;
  chosen.reserve(order.size());
  for (const auto& [hash, point] : order)
    chosen.push_back(point);
  return chosen;
}

float
spacingOf(const pcl::PointCloud<pcl::PointXYZ>& points)
{
  constexpr std::size_t max_samples = 400; // enough for a median
  const auto places = placesOf(points);
  if (places->size() < 2)
    return 1.0f;
  pcl::search::KdTree<pcl::PointXYZ> tree(false);
  tree.setInputCloud(places);
  std::vector<float> distances;
  pcl::Indices nearest;
  std::vector<float> squared;
  for (std::size_t i = 0; i < std::min(points.size(), max_samples); ++i) {
    tree.nearestKSearch(points[i], 2, nearest, squared);
    distances.push_back(std::sqrt(std::max(squared[0], squared[1])));
  }
  const auto middle =
      distances.begin() + static_cast<std::ptrdiff_t>(distances.size() / 2);
  std::nth_element(distances.begin(), middle, distances.end());
  return *middle;
}

} // namespace pcl::app
