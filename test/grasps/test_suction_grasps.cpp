// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Suction grasps on shapes whose answer is known, and refused input.

#include "grasp_surfaces.h"
#include "support/errors.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace {

using namespace pcl;
using namespace pcl::test;
using Eigen::Vector3f;

bool
areSame(const Grasps& one, const Grasps& other)
{
  return std::equal(one.begin(),
                    one.end(),
                    other.begin(),
                    other.end(),
                    [](const SuctionGrasp& a, const SuctionGrasp& b) {
                      return a.position == b.position && a.approach == b.approach &&
                             a.score == b.score && a.problems == b.problems &&
                             a.iterations == b.iterations;
                    });
}

ShapeField::Ptr
fieldOf(const Cloud::Ptr& cloud)
{
  ShapeFieldEstimation<PointXYZ> estimation;
  estimation.setInputCloud(cloud);
  const auto field = make_shared<ShapeField>();
  EXPECT_TRUE(estimation.compute(*field));
  return field;
}

TEST(SuctionGrasps, OfAPlaneAreOnItAndPointAgainstItsNormal)
{
  Random random(901);
  const Grasps grasps = graspsOn(sheet({0, 0, 0.3}, 0.1, 0.08, random));
  ASSERT_GT(grasps.size(), 3U);
  for (const SuctionGrasp& grasp : grasps) {
    ASSERT_TRUE(grasp.seals()) << "the mode moves to where the cup fits";
    EXPECT_NEAR(grasp.position.z(), 0.3f, 1e-5f);
    EXPECT_LT((grasp.approach - Vector3f(0, 0, -1)).norm(), 1e-3f);
    EXPECT_EQ(grasp.surface, 1U);
    EXPECT_TRUE(grasp.converged);
    for (const int axis : {0, 1}) {
      EXPECT_GE(grasp.position[axis], cup_radius);
      EXPECT_LE(grasp.position[axis], (axis == 0 ? 0.1f : 0.08f) - cup_radius);
    }
  }
}

TEST(SuctionGrasps, ClimbToTheMiddleOfASmallFace)
{
  Random random(914);
  constexpr double radius = 0.02;
  const auto count = static_cast<std::size_t>(pi * radius * radius / (0.001 * 0.001));
  const Surface disc = sampled(count, random, [](Random& r) {
    const double turn = r.uniform(0, 2 * pi), out = radius * std::sqrt(r.uniform());
    return SurfacePoint{{out * std::cos(turn), out * std::sin(turn), 0}, {0, 0, 1}};
  });
  const Grasps grasps = graspsOn(disc);
  ASSERT_EQ(grasps.size(), 1U) << "all starts climb to it";
  EXPECT_TRUE(grasps[0].seals());
  EXPECT_TRUE(grasps[0].converged);
  EXPECT_GE(grasps[0].starts, 3U);
  EXPECT_LT(grasps[0].position.norm(), 0.15f * cup_radius);
  EXPECT_LT(grasps[0].moved, 0.15f * cup_radius) << "the mode was there";
  // Where h is twice the spread of (1 - r^2 / h^2) over the disc; a little more, as
  // points at the rim, with neighbors on one side only, count for more area
  EXPECT_NEAR(grasps[0].bandwidth, 1.315 * radius, 0.06 * radius);
}

TEST(SuctionGrasps, AreRankedWithThoseThatSealFirst)
{
  Random random(902);
  Surface surface = sheet({0, 0, 0}, 0.06, 0.06, random);
  surface.append(sheet({0.1, 0, 0}, 0.015, 0.06, random)); // narrower than the cup
  const Grasps grasps = graspsOn(surface);
  ASSERT_GE(grasps.size(), 2U);
  EXPECT_TRUE(grasps.front().seals());
  EXPECT_FALSE(grasps.back().seals());
  for (std::size_t g = 0; g < grasps.size(); ++g) {
    EXPECT_EQ(grasps[g].score > 0.5f, grasps[g].seals());
    EXPECT_LE(grasps[g].score, g == 0 ? 1.0f : grasps[g - 1].score);
  }
}

TEST(SuctionGrasps, DoNotDependOnThreadsOrderOrUnknownPoints)
{
  Random random(910);
  Surface scene = mixedScene(15000, random); // all count for its noise
  scene.addNoise(0.0003, random);
  const Cloud::Ptr cloud = toCloud<PointXYZ>(scene);
  Estimation estimation;
  estimation.setInputCloud(cloud);
  estimation.setNumberOfThreads(1);
  const Grasps one = graspsOf(estimation);
  ASSERT_GT(one.size(), 5U);
  estimation.setNumberOfThreads(3);
  EXPECT_TRUE(areSame(one, graspsOf(estimation)));

  const auto changed = make_shared<Cloud>();
  constexpr float nan = std::numeric_limits<float>::quiet_NaN();
  for (std::size_t i = cloud->size(); i-- > 0;) {
    changed->push_back((*cloud)[i]);
    if (i % 100 == 0)
      changed->emplace_back(nan, nan, nan);
  }
  changed->is_dense = false;
  estimation.setInputCloud(changed);
  EXPECT_TRUE(areSame(one, graspsOf(estimation)));
}

TEST(SuctionGrasps, UseSurfacesThatAreKnown)
{
  Random random(917);
  const Cloud::Ptr cloud = toCloud<PointXYZ>(sheet({0, 0, 0}, 0.08, 0.06, random));
  const auto target = make_shared<Indices>();
  for (std::size_t i = 0; i < cloud->size(); ++i)
    if ((*cloud)[i].x < 0.04f)
      target->push_back(static_cast<index_t>(i));
  Estimation estimation = seenFromAbove(cloud);
  estimation.setIndices(target);
  const Grasps grasps = graspsOf(estimation);
  const auto field = fieldOf(cloud);
  estimation.setShapeField(field);
  EXPECT_FALSE(grasps.empty());
  EXPECT_TRUE(areSame(grasps, graspsOf(estimation)));

  const auto curved = make_shared<ShapeField>(*field);
  std::swap(curved->likelihoods[0], curved->likelihoods[1]);
  estimation.setShapeField(curved);
  const Grasps others = graspsOf(estimation);
  ASSERT_FALSE(others.empty());
  EXPECT_EQ(others[0].surface, 2U) << "they are used";
}

TEST(SuctionGrasps, PointsOfWhichNothingIsKnownDoNotCount)
{
  Random random(912);
  const Cloud::Ptr cloud = toCloud<PointXYZ>(sheet({0, 0, 0}, 0.08, 0.06, random));
  const std::size_t known = cloud->size();
  for (std::size_t i = 0; i < 2 * known; ++i)
    cloud->push_back(PointXYZ(0.3f, 0.001f * static_cast<float>(i), 0.0f));
  const auto field = fieldOf(cloud);
  constexpr float nan = std::numeric_limits<float>::quiet_NaN();
  for (std::size_t i = known; i < cloud->size(); ++i) {
    field->likelihoods[0][i] = field->likelihoods[1][i] = nan;
    field->edge_likelihood[i] = field->spacings[i] = nan;
    field->normals[i].setConstant(nan);
  }
  Estimation estimation = seenFromAbove(cloud);
  estimation.setShapeField(field);
  const Grasps grasps = graspsOf(estimation);
  ASSERT_FALSE(grasps.empty());
  for (const SuctionGrasp& grasp : grasps)
    EXPECT_LT(grasp.position.x(), 0.1f);
}

TEST(SuctionGrasps, ScaleWithTheCloud)
{
  Random random(911);
  const Cloud::Ptr cloud = toCloud<PointXYZ>(sheet({0, 0, 0}, 0.08, 0.08, random));
  Estimation estimation = seenFromAbove(cloud);
  const Grasps small = graspsOf(estimation);
  for (PointXYZ& point : *cloud)
    point.getVector3fMap() *= 1024.0f;
  estimation.setViewPoint(0, 0, 5120);
  estimation.setCupRadius(1024 * cup);
  const Grasps large = graspsOf(estimation);
  ASSERT_EQ(small.size(), large.size());
  for (std::size_t g = 0; g < small.size(); ++g) {
    EXPECT_LT((1024.0f * small[g].position - large[g].position).norm(), 1.0f);
    EXPECT_NEAR(small[g].score, large[g].score, 1e-3f);
  }
}

TEST(SuctionGrasps, OfOneClassOnlyAndNoMoreThanAskedFor)
{
  Random random(912);
  Estimation estimation =
      seenFromAbove(toCloud<PointXYZ>(sheet({0, 0, 0}, 0.08, 0.08, random)));
  estimation.setMaximumGrasps(2);
  EXPECT_EQ(graspsOf(estimation).size(), 2U);
  estimation.setSurface(Estimation::CURVED);
  EXPECT_TRUE(graspsOf(estimation).empty()) << "nothing is curved";
}

TEST(SuctionGrasps, RefuseWhatCannotBeUsed)
{
  Random random(913);
  const Cloud::Ptr cloud = toCloud<PointXYZ>(sheet({0, 0, 0}, 0.04, 0.04, random));
  const auto refused = [&](const std::string& word, const auto& change) {
    Estimation estimation = seenFromAbove(cloud);
    change(estimation);
    Grasps grasps(1);
    const std::string error =
        errorsOf([&] { EXPECT_FALSE(estimation.compute(grasps)); });
    EXPECT_NE(error.find(word), std::string::npos) << error;
    EXPECT_NE(error.find("SuctionGraspEstimation"), std::string::npos) << error;
    EXPECT_TRUE(grasps.empty());
  };
  refused("cup radius", [](Estimation& e) { e.setCupRadius(0); });
  refused("cup radius", [](Estimation& e) { e.setCupRadius(-1); });
  refused("cup radius", [](Estimation& e) {
    e.setCupRadius(std::numeric_limits<double>::infinity());
  });
  refused("too sparse", [](Estimation& e) { e.setCupRadius(1e-4); });
  refused("compliance", [](Estimation& e) { e.setCompliance(1.5); });
  refused("index 5000", [](Estimation& e) { e.setIndices(indicesOf({0, 5000})); });
  refused("the shape field is of another cloud",
          [](Estimation& e) { e.setShapeField(make_shared<const ShapeField>()); });
  refused("no input cloud", [](Estimation& e) { e.setInputCloud(nullptr); });
}

} // namespace
