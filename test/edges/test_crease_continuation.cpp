// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Creases where they are faint: what continues a clear one counts, and nothing else.

#include "edges/crease_continuation.h"
#include "segmentation/detection_scenes.h"
#include "segmentation/field_of.h"
#include "segmentation/measured_numbers.h"

#include <pcl/segmentation/cloud_reach.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

namespace {

using namespace pcl;
using namespace pcl::test;
using segmentation::Agreement;

constexpr float needed = 10.0f, faint = 4.0f;

/** A place x spacings along the x axis, y beside it; the spacing is 1. */
Agreement
place(float evidence, float x, float y = 0.0f)
{
  Agreement place;
  place.point = {{x, y, 0.0f}, {1.0f, 0.0f, 0.0f}, 1.0f, 1.0f};
  place.evidence = evidence;
  return place;
}

/** Which of the places count. */
std::vector<bool>
continued(std::vector<Agreement> places)
{
  segmentation::continueCreases(needed, faint, 1.0f, 1, places);
  std::vector<bool> counts;
  for (const Agreement& agreement : places)
    counts.push_back(agreement.evidence > needed);
  return counts;
}

TEST(CreaseContinuation, FollowsACreaseStepByStep)
{
  const float step = 1.9f;
  const auto steps =
      static_cast<std::size_t>(segmentation::continuationSpacings() / step);
  std::vector<Agreement> places{place(11.0f, 0.0f)};
  for (std::size_t k = 1; k <= steps + 1; ++k)
    places.push_back(place(5.0f, static_cast<float>(k) * step));
  std::vector<bool> expected(places.size(), true);
  expected.back() = false;
  EXPECT_EQ(expected, continued(places));

  places[1].evidence = 3.0f; // a gap
  expected.assign(places.size(), false);
  expected[0] = true;
  EXPECT_EQ(expected, continued(places));
}

TEST(CreaseContinuation, KeepsToTheCreasesLineDirectionAndAngle)
{
  Agreement across = place(5.0f, 1.0f), flat = place(5.0f, 1.0f),
            smooth = place(5.0f, 1.0f);
  across.point.direction = {0.0f, 1.0f, 0.0f};
  flat.point.angle = 0.4f;
  smooth.fit = -0.1f;
  const Agreement clear = place(11.0f, 0.0f), aside = place(5.0f, 1.0f, 0.7f);
  EXPECT_EQ((std::vector<bool>{true, true}),
            continued({clear, place(5.0f, -1.0f, 0.5f)}));
  for (const Agreement& other : {aside, across, flat, smooth})
    EXPECT_EQ((std::vector<bool>{true, false}), continued({clear, other}));
}

TEST(CreaseContinuation, IsNeverClearerThanACrease)
{
  std::vector<Agreement> places{place(10.1f, 0.0f), place(9.9f, 1.0f)};
  segmentation::continueCreases(needed, faint, 1.0f, 1, places);
  EXPECT_GT(places[1].evidence, needed);
  EXPECT_LT(places[1].evidence, places[0].evidence);
}

TEST(CreaseContinuation, NeedsAClearPlace)
{
  EXPECT_EQ((std::vector<bool>{false, false}),
            continued({place(9.9f, 0.0f), place(9.9f, 1.0f)}));
}

/** A ridge along x whose angle falls evenly from the first to the last one, in radians,
 * over 200 distances between points. */
struct FallingRidge {
  static constexpr int length = 200, half_width = 15;
  static constexpr double first = 1.0, last = 0.2, distance = 0.001;

  static double
  angleAt(double x)
  {
    return first + (last - first) * x / length;
  }

  explicit FallingRidge(double noise, unsigned seed)
  {
    Random random(seed);
    for (int i = 0; i < length; ++i)
      for (int j = -half_width; j < half_width; ++j) {
        const double x = i + random.uniform(), y = j + random.uniform();
        const double z = -std::abs(y) * std::tan(angleAt(x) / 2.0);
        const Eigen::Vector3d p =
            distance * (Eigen::Vector3d(x, y, z) +
                        noise * Eigen::Vector3d(
                                    random.normal(), random.normal(), random.normal()));
        cloud->emplace_back(static_cast<float>(p.x()),
                            static_cast<float>(p.y()),
                            static_cast<float>(p.z()));
        angles.push_back(angleAt(x));
        aside.push_back(std::abs(y));
      }
  }

  Cloud::Ptr cloud = make_shared<Cloud>();
  std::vector<double> angles; ///< of the ridge beside each point
  std::vector<double> aside;  ///< from the ridge, in distances
};

TEST(CreaseContinuation, FollowsARidgeWhoseAngleFalls)
{
  for (const double noise : {0.0, 0.15}) {
    SCOPED_TRACE("noise " + std::to_string(noise));
    double near = 0, found = 0, apart = 0, called = 0, smooth = 0, false_alarms = 0;
    for (const unsigned seed : {1U, 2U, 3U, 4U}) {
      const FallingRidge ridge(noise, seed);
      const std::vector<float> edges = edgesOf(ridge.cloud);
      for (std::size_t i = 0; i < edges.size(); ++i) {
        const bool is_edge = edges[i] > 0.5f;
        if (ridge.aside[i] < 1.0 && ridge.angles[i] > 0.5 && ridge.angles[i] < 0.65) {
          near += 1;
          found += is_edge ? 1 : 0;
        }
        if (ridge.aside[i] < 1.0 && ridge.angles[i] < 0.35) {
          smooth += 1;
          false_alarms += is_edge ? 1 : 0;
        }
        if (ridge.aside[i] > 5.0) {
          apart += 1;
          called += is_edge ? 1 : 0;
        }
      }
    }
    EXPECT_GT(found / near, 0.8);
    EXPECT_LT(called / apart, 0.001);
    EXPECT_LT(false_alarms / smooth, 0.05);
  }
}

TEST(CreaseContinuation, IsTheSameInPartsWithTheirHalo)
{
  const Cloud::Ptr cloud = FallingRidge(0.15, 1).cloud;
  const CloudNumbers numbers = measuredNumbers(*cloud);
  const auto halo =
      static_cast<float>(reachOf(numbers, ShapeModel::defaultEdges()).edges);
  const ShapeField whole = edgeFieldOf(cloud);
  const auto just_enough = [](float likelihood) {
    return likelihood > 0.5f && likelihood < 0.5005f;
  };
  constexpr float width = 0.005f; // of strips across the ridge, meters
  std::size_t compared = 0, followed = 0;
  for (float low = 0.05f; low < 0.15f; low += width) {
    const auto near = make_shared<Cloud>();
    std::vector<float> expected;
    for (std::size_t i = 0; i < cloud->size(); ++i)
      if ((*cloud)[i].x > low - halo && (*cloud)[i].x < low + width + halo) {
        near->push_back((*cloud)[i]);
        expected.push_back(whole.edge_likelihood[i]);
      }
    ASSERT_LT(near->size(), cloud->size());
    const ShapeField part = edgeFieldOf(near, numbers);
    for (std::size_t k = 0; k < near->size(); ++k) {
      if ((*near)[k].x < low || (*near)[k].x > low + width)
        continue;
      ASSERT_EQ(expected[k], part.edge_likelihood[k]);
      ++compared;
      followed += just_enough(expected[k]) ? 1 : 0;
    }
  }
  EXPECT_GT(compared, 2500U);
  EXPECT_GT(followed, 10U);
}

} // namespace
