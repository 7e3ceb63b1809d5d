// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// A search tree that counts its queries.

#pragma once

#include <pcl/point_types.h>
#include <pcl/search/kdtree.h>

#include <atomic>
#include <vector>

namespace pcl {
namespace test {

/** \brief A tree that counts what it is asked. */
class CountingSearch : public pcl::search::KdTree<pcl::PointXYZ> {
public:
  int
  nearestKSearch(const pcl::PointXYZ& point,
                 int k,
                 pcl::Indices& indices,
                 std::vector<float>& distances) const override
  {
    ++nearest_calls;
    return pcl::search::KdTree<pcl::PointXYZ>::nearestKSearch(
        point, k, indices, distances);
  }

  int
  radiusSearch(const pcl::PointXYZ& point,
               double radius,
               pcl::Indices& indices,
               std::vector<float>& distances,
               unsigned most) const override
  {
    ++radius_calls;
    return pcl::search::KdTree<pcl::PointXYZ>::radiusSearch(
        point, radius, indices, distances, most);
  }

  mutable std::atomic<std::size_t> nearest_calls{0};
  mutable std::atomic<std::size_t> radius_calls{0};
};

} // namespace test
} // namespace pcl
