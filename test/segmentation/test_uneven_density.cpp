// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// A crease is found all along where one part of a cloud is sampled more finely.

#include "common/statistics.h"
#include "features/spacing/even_sampling.h"
#include "field_of.h"
#include "geometry/voxel_means.h"
#include "segmentation/field_of_points.h"
#include "support/bits.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <random>
#include <vector>

namespace {

using namespace pcl;
using test::edgeFieldOf;

using Cloud = PointCloud<PointXYZ>;

constexpr float spacing = 0.03f; // the mean distance between points
constexpr float stripe_from = 0.4f, stripe_to = 0.6f;

/** A floor and a wall of one by one meter, which meet along x at y = 1. A stripe of the
 * floor is sampled `times` as finely. */
Cloud::Ptr
floorWithStripe(float times, std::mt19937& random)
{
  const auto cloud = pcl::make_shared<Cloud>();
  const auto add = [&](float from, float to, float step, bool is_wall) {
    std::uniform_real_distribution<float> x(from, to), other(0.0f, 1.0f);
    const auto count = static_cast<int>((to - from) / (step * step));
    for (int i = 0; i < count; ++i)
      cloud->push_back(is_wall ? PointXYZ(x(random), 1.0f, other(random))
                               : PointXYZ(x(random), other(random), 0.0f));
  };
  add(0.0f, 1.0f, spacing, true);
  add(0.0f, stripe_from, spacing, false);
  add(stripe_to, 1.0f, spacing, false);
  add(stripe_from, stripe_to, spacing / times, false);
  return cloud;
}

bool
hasCreaseNear(const ShapeField& field, float x)
{
  return std::any_of(
      field.creases.begin(), field.creases.end(), [x](const CreasePoint& crease) {
        const auto& p = crease.position;
        return std::abs(p[0] - x) < spacing && std::abs(p[1] - 1.0f) < spacing &&
               std::abs(p[2]) < spacing;
      });
}

class UnevenDensity : public testing::TestWithParam<float> {};

TEST_P(UnevenDensity, TheCreaseIsFoundAllAlong)
{
  std::mt19937 random(5);
  const Cloud::Ptr cloud = floorWithStripe(GetParam(), random);
  const ShapeField field = edgeFieldOf(cloud);
  for (float x = 0.05f; x < 0.96f; x += 0.05f)
    EXPECT_TRUE(hasCreaseNear(field, x)) << x;
  const auto unknown =
      std::count_if(field.edge_likelihood.begin(),
                    field.edge_likelihood.end(),
                    [](float likelihood) { return std::isnan(likelihood); });
  EXPECT_LE(100 * unknown, static_cast<std::ptrdiff_t>(cloud->size()));
}

TEST_P(UnevenDensity, TheResultDependsOnNeitherOrderNorThreads)
{
  std::mt19937 random(6);
  const Cloud::Ptr cloud = floorWithStripe(GetParam(), random);
  const ShapeField expected = edgeFieldOf(cloud, 0.0, 1);
  pcl::Indices order(cloud->size());
  for (std::size_t i = 0; i < order.size(); ++i)
    order[i] = static_cast<pcl::index_t>(i);
  std::shuffle(order.begin(), order.end(), random);
  const ShapeField field = edgeFieldOf(pcl::make_shared<Cloud>(*cloud, order), 0.0, 3);
  for (std::size_t i = 0; i < order.size(); ++i) {
    const float was = expected.edge_likelihood[static_cast<std::size_t>(order[i])];
    ASSERT_TRUE(field.edge_likelihood[i] == was ||
                (std::isnan(field.edge_likelihood[i]) && std::isnan(was)))
        << i;
  }
}

TEST_P(UnevenDensity, ClassesAreThoseOfWholeFacesWhateverOrderAndThreads)
{
  std::mt19937 random(7);
  const Cloud::Ptr cloud = floorWithStripe(GetParam(), random);
  cloud->push_back({std::numeric_limits<float>::quiet_NaN(), 0.0f, 0.0f});
  const ShapeField expected = test::fieldOf(cloud, 1);
  ASSERT_EQ(expected.classes.size(), expected.likelihoods.size());
  const std::vector<float>& planar = expected.likelihoods.at(0);
  ASSERT_EQ(planar.size(), cloud->size());
  EXPECT_TRUE(std::isnan(planar.back()));
  const auto right = std::count_if(
      planar.begin(), planar.end(), [](float likelihood) { return likelihood > 0.5f; });
  EXPECT_GT(100 * right, 99 * static_cast<std::ptrdiff_t>(cloud->size()));
  pcl::Indices order(cloud->size());
  std::iota(order.begin(), order.end(), 0);
  std::shuffle(order.begin(), order.end(), random);
  const ShapeField field = test::fieldOf(pcl::make_shared<Cloud>(*cloud, order), 3);
  std::vector<float> in_order;
  for (const pcl::index_t i : order)
    in_order.push_back(planar[static_cast<std::size_t>(i)]);
  EXPECT_TRUE(test::sameBits(in_order, field.likelihoods.at(0)));
}

INSTANTIATE_TEST_SUITE_P(Times, UnevenDensity, testing::Values(3.0f, 5.0f));

TEST(EvenSampling, KeepsWhatIsEvenAndThinsWhatIsDenseBesideIt)
{
  std::vector<float> points, spacings;
  for (int i = 0; i < 40; ++i) { // far from the rest, as dense as what is thinned
    points.insert(points.end(), {100.0f + 0.01f * static_cast<float>(i), 0.0f, 0.0f});
    spacings.push_back(0.01f);
  }
  for (int i = 0; i < 40; ++i) {
    points.insert(points.end(), {0.1f * static_cast<float>(i), 0.0f, 0.0f});
    spacings.push_back(0.1f);
  }
  const std::size_t kept = points.size();
  for (int i = 0; i < 400; ++i) {
    points.insert(points.end(), {0.01f * static_cast<float>(i), 0.05f, 0.0f});
    spacings.push_back(0.01f);
  }
  const std::vector<float> even =
      detail::evenSampling({points.data(), 3, points.size() / 3}, spacings);
  ASSERT_GT(even.size(), kept);
  EXPECT_TRUE(std::equal(points.begin(), points.begin() + 240, even.begin()));
  const std::size_t thinned = (even.size() - kept) / 3;
  EXPECT_GT(thinned, 40u);
  EXPECT_LT(thinned, 160u);
}

/** Rows of five points whose spacing grows by a factor from each row to the next. */
std::vector<float>
growingSpacings(float factor, std::vector<float>& points)
{
  std::vector<float> spacings;
  float x = 0.0f;
  for (float d = 0.001f; d < 0.02f; d *= factor) {
    for (const float y : {-2.0f, -1.0f, 0.0f, 1.0f, 2.0f}) {
      points.insert(points.end(), {x, y * d, 0.0f});
      spacings.push_back(d);
    }
    x += d;
  }
  return spacings;
}

TEST(EvenSampling, LeavesASlowChangeAsItIsAndGradesAQuickOne)
{
  // As on a table that a camera sees at a small angle: twice in 35 spacings.
  std::vector<float> slow;
  const std::vector<float> slow_spacings = growingSpacings(1.02f, slow);
  EXPECT_EQ(detail::evenSampling({slow.data(), 3, slow.size() / 3}, slow_spacings),
            slow);
  // Twice in 4 spacings: thinned, but by no more than the change over its neighborhood.
  std::vector<float> quick;
  const std::vector<float> quick_spacings = growingSpacings(1.2f, quick);
  const std::vector<float> even =
      detail::evenSampling({quick.data(), 3, quick.size() / 3}, quick_spacings);
  EXPECT_LT(even.size(), quick.size());
  EXPECT_GT(even.size(), quick.size() / 3);
}

TEST(UnevenField, DensePointsKeepTheirSpacingAndSparseOnesHaveTheirs)
{
  std::mt19937 random(7);
  const float times = 5.0f;
  const Cloud::Ptr cloud = floorWithStripe(times, random);
  const ShapeField field = edgeFieldOf(cloud);
  std::size_t dense = 0, coarse = 0, sparse = 0, fine = 0;
  for (std::size_t i = 0; i < cloud->size(); ++i) {
    const PointXYZ& p = (*cloud)[i];
    if (p.z > 0.0f || p.y > 0.8f) // the floor, away from the wall
      continue;
    if (p.x > stripe_from + spacing && p.x < stripe_to - spacing) {
      ++dense; // the distance to the 12th neighbor is two mean distances
      coarse += field.spacings[i] > 3.0f * spacing / times ? 1 : 0;
    }
    else if (p.x < stripe_from - 3.0f * spacing) {
      ++sparse;
      fine += field.spacings[i] < 1.2f * spacing ? 1 : 0;
    }
  }
  ASSERT_GT(dense, 1000u);
  ASSERT_GT(sparse, 100u);
  EXPECT_LT(100 * coarse, dense);
  EXPECT_LT(100 * fine, sparse);
}

bool
areSame(const Eigen::Vector3f& a, const Eigen::Vector3f& b)
{
  return a == b || (a.hasNaN() && b.hasNaN());
}

bool
areSame(float a, float b)
{
  return a == b || (std::isnan(a) && std::isnan(b));
}

TEST(FieldStages, NoOtherPointsAreNotThoseOfTheSurface)
{
  std::mt19937 random(9);
  const Cloud::Ptr cloud = floorWithStripe(1.0f, random);
  detail::FieldRequest request;
  request.surface = request.input = detail::xyzOf(*cloud);
  EXPECT_EQ(cloud->size(), detail::neighborhoodsOf(request).input().size);
  EXPECT_EQ(0u, detail::neighborhoodsOf(request, {}).input().size);
}

/** Sparse points beside the stripe see its dense points: means are too coarse there. */
TEST(UnevenField, PointsHaveTheEdgesOfAllPointsOrThoseOfMeans)
{
  std::mt19937 random(8);
  const float times = 5.0f;
  const Cloud::Ptr cloud = floorWithStripe(times, random);
  detail::FieldRequest request;
  request.surface = request.input = detail::xyzOf(*cloud);
  request.edge_model = ShapeModel::defaultEdges();
  request.edges_only = true;
  request.threads = 2;
  const detail::Neighborhoods neighborhoods = detail::neighborhoodsOf(request);
  const std::vector<float> spacings =
      detail::evenSpacingsOf(detail::distancesToTwelfth(neighborhoods));
  detail::NoiseLevel noise;
  detail::Conditions conditions;
  conditions.to_edges = [&](const detail::MeasuredCloud& means, const ShapeField&) {
    noise = means.noise;
    return true;
  };
  const std::vector<float> even = detail::evenSampling(request.surface, spacings);
  const ShapeField means = detail::fieldOf(request,
                                           nullptr,
                                           detail::neighborhoodsOf(request, even),
                                           {true, nullptr},
                                           conditions);
  const auto stands_for =
      detail::representatives(request.surface, means.points, means.spacings, 2);
  CloudNumbers numbers;
  numbers.spacing = segmentation::medianSpacing(spacings);
  numbers.distance = static_cast<double>(numbers.spacing);
  numbers.noise = means.noise;
  detail::setNoiseLevel(noise, numbers);
  detail::FieldRequest of_all = request;
  of_all.of_cloud = numbers;
  const ShapeField all =
      detail::fieldOf(of_all, nullptr, neighborhoods, {true, &spacings});
  const ShapeField field =
      detail::fieldOfPoints(request, [](const auto&, const auto&) { return true; });
  std::size_t beside = 0;
  for (std::size_t i = 0; i < cloud->size(); ++i) {
    ASSERT_GE(stands_for[i], 0) << i;
    const auto mean = static_cast<std::size_t>(stands_for[i]);
    const bool is_own = areSame(field.normals[i], all.normals[i]);
    ASSERT_TRUE(areSame(field.edge_likelihood[i], all.edge_likelihood[i]) ||
                areSame(field.edge_likelihood[i], means.edge_likelihood[mean]))
        << i; // the likelihood of a mean at a crease raises that of a point
    if (means.spacings[mean] > 1.5f * spacings[i] &&
        !std::isnan(all.edge_likelihood[i])) {
      ASSERT_TRUE(is_own) << i;
      const PointXYZ& p = (*cloud)[i];
      const bool is_dense = p.z == 0.0f && p.x >= stripe_from && p.x <= stripe_to;
      beside += is_dense ? 0 : 1;
    }
    else
      ASSERT_TRUE(is_own || areSame(field.normals[i], means.normals[mean])) << i;
  }
  EXPECT_GT(beside, 0u);
}

} // namespace
