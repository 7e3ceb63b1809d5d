// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Evidence averaged over a few points, beside the same in double.

#include "common/statistics.h"
#include "geometry/point_choice.h"
#include "geometry/point_grid.h"
#include "support/bits.h"
#include "support/shapes.h"
#include "surfaces/evidence_averaging.h"

#include <pcl/features/impl/neighborhoods.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace {

using namespace pcl;
using namespace pcl::test;
using namespace pcl::segmentation;
using Eigen::Vector3f;

/** A floor and a wall; points near where they meet are edges. */
class EvidenceAveraging : public testing::Test {
protected:
  EvidenceAveraging()
  {
    Random random(43);
    surface = plane(3000, 0.2, random);
    Surface wall = plane(3000, 0.2, random);
    Eigen::Isometry3d upright = Eigen::Isometry3d::Identity();
    upright.rotate(Eigen::AngleAxisd(-pi / 2, Eigen::Vector3d::UnitY()));
    wall.move(upright);
    surface.append(wall);
    for (std::size_t i = 0; i < surface.size(); ++i) {
      const Eigen::Vector3d p = surface.position(i);
      edges.normals.push_back(surface.normal(i).cast<float>());
      edges.edge_likelihood.push_back(p.x() < 0.01 && p.z() < 0.01 ? 1.0f : 0.0f);
      edges.spacings.push_back(0.007f + 0.01f * static_cast<float>(p.y()));
      is_known.push_back(i % 11 != 0);
    }
  }

  const detail::Neighborhoods neighborhoods{{}, 1};
  Surface surface;
  ShapeField edges;
  std::vector<bool> is_known;
};

/** The weights of the method over the points nearest to the middles of cells, and their
 * sums in double. */
TEST_F(EvidenceAveraging, FourRoundsAreThoseInDouble)
{
  const detail::FieldInput input{neighborhoods, surface.points(), {}, 2};
  Random random(44);
  std::vector<float> evidence;
  for (std::size_t i = 0; i < surface.size(); ++i)
    for (int c = 0; c < 2; ++c)
      evidence.push_back(is_known[i] ? static_cast<float>(random.normal())
                                     : std::numeric_limits<float>::quiet_NaN());
  std::vector<std::uint32_t> known;
  for (std::uint32_t i = 0; i < surface.size(); ++i)
    if (is_known[i])
      known.push_back(i);
  std::vector<std::uint32_t> nodes =
      centralPoints(input.points, known, 1.5f * median(edges.spacings));
  std::sort(nodes.begin(), nodes.end());
  const pcl::Indices points = evidencePoints(input, edges, known);
  ASSERT_TRUE(std::equal(nodes.begin(), nodes.end(), points.begin(), points.end()));
  std::vector<float> of_points;
  for (const std::uint32_t node : nodes)
    of_points.insert(of_points.end(), {evidence[2 * node], evidence[2 * node + 1]});
  const std::vector<float> found =
      averageEvidence(input, edges, points, of_points, 2, known);
  ASSERT_GT(nodes.size(), 100U);
  ASSERT_LT(nodes.size(), surface.size() / 4);
  std::size_t weighted = 0;
  const auto weightOf = [&](std::size_t i, std::size_t j) {
    const float reach = 5.0f * edges.spacings[i];
    const Vector3f d = positionOf(input.points, j) - positionOf(input.points, i);
    if (!(d.x() * d.x() + (d.y() * d.y() + d.z() * d.z()) < reach * reach))
      return 0.0;
    ++weighted;
    const bool is_same = std::abs(surface.normal(i).dot(surface.normal(j))) > 0.7071;
    return (edges.edge_likelihood[j] > 0.5f ? 0.05 : 1.0) * (is_same ? 1.0 : 0.05);
  };
  const auto meanAt = [&](std::size_t i, const std::vector<double>& values) {
    double sum = 0.0, total = 0.0;
    for (std::size_t k = 0; k < nodes.size(); ++k) {
      const double weight = weightOf(i, nodes[k]);
      sum += weight * values[k];
      total += weight;
    }
    return sum / total;
  };
  for (std::size_t c = 0; c < 2; ++c) {
    std::vector<double> values;
    for (const std::uint32_t node : nodes)
      values.push_back(static_cast<double>(evidence[2 * node + c]));
    for (int round = 1; round < 4; ++round) {
      std::vector<double> next;
      for (const std::uint32_t node : nodes)
        next.push_back(meanAt(node, values));
      values = next;
    }
    for (std::size_t i = 0; i < surface.size(); ++i)
      if (is_known[i]) {
        EXPECT_NEAR(meanAt(i, values), static_cast<double>(found[2 * i + c]), 1e-5);
      }
      else {
        EXPECT_TRUE(std::isnan(found[2 * i + c]));
      }
  }
  EXPECT_GT(weighted, 1000U);
}

TEST_F(EvidenceAveraging, AveragesDependOnNeededPointsOnly)
{
  constexpr double inad_radius = 7.0;
  const detail::FieldInput input{neighborhoods, surface.points(), {}, 2};
  Random random(45);
  std::vector<std::uint32_t> known(surface.size());
  std::iota(known.begin(), known.end(), 0);
  const pcl::Indices points = evidencePoints(input, edges, known);
  std::vector<float> all, some(2 * points.size(), std::nanf(""));
  for (std::size_t k = 0; k < 2 * points.size(); ++k)
    all.push_back(static_cast<float>(random.normal()));
  std::vector<std::uint32_t> wanted;
  for (const std::uint32_t i : known)
    if (surface.position(i).y() < 0.02)
      wanted.push_back(i);
  const NeededPoints needed = neededPoints(input, edges, points, wanted, inad_radius);
  ASSERT_GT(needed.evidence.size(), wanted.size() / 8);
  ASSERT_LT(needed.evidence.size(), points.size());
  std::vector<bool> has_normal(points.size());
  for (const std::uint32_t k : needed.points)
    has_normal[k] = true;
  for (const pcl::index_t at : needed.evidence) {
    const std::uint32_t k = needed.points[static_cast<std::size_t>(at)];
    std::copy_n(&all[2 * k], 2, &some[2 * k]);
    const auto point = static_cast<std::size_t>(points[k]);
    const float radius = static_cast<float>(inad_radius) * edges.spacings[point];
    for (std::size_t other = 0; other < points.size(); ++other)
      if (const auto i = static_cast<std::size_t>(points[other]);
          (positionOf(input.points, i) - positionOf(input.points, point)).norm() <
          radius) {
        EXPECT_TRUE(has_normal[other]);
      }
  }
  EXPECT_TRUE(sameBits(averageEvidence(input, edges, points, all, 2, wanted),
                       averageEvidence(input, edges, points, some, 2, wanted)));
}

} // namespace
