// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Why suction cups leak: each reason on a shape that has it.

#include "grasp_surfaces.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

// Where a suction cup seals, and why it does not elsewhere.
namespace {

using namespace pcl;
using namespace pcl::test;
using Eigen::Vector3d;
using Eigen::Vector3f;

bool
has(const SuctionGrasp& grasp, SealProblem problem)
{
  return std::find(grasp.problems.begin(), grasp.problems.end(), problem) !=
         grasp.problems.end();
}

/** What a camera above sees of a height over a rectangle, in pixels of 1 mm. It
 * averages its noise over several pixels, so that neighbors share it. */
template <typename Height>
Surface
seenByACamera(const Eigen::AlignedBox2d& area,
              double deviation,
              Random& random,
              const Height& height)
{
  constexpr double pixel = 0.001;
  constexpr int averaged = 2; // pixels to each side
  const auto columns = static_cast<int>(area.sizes().x() / pixel);
  const auto rows = static_cast<int>(area.sizes().y() / pixel);
  Eigen::MatrixXd white(rows + 2 * averaged, columns + 2 * averaged);
  std::generate_n(white.data(), white.size(), [&] { return random.normal(); });
  Surface surface;
  for (int row = 0; row < rows; ++row)
    for (int column = 0; column < columns; ++column) {
      constexpr int side = 2 * averaged + 1;
      const double noise = white.block(row, column, side, side).sum() / side;
      const Eigen::Vector2d p = area.min() + pixel * Eigen::Vector2d(column, row);
      surface.add({{p.x(), p.y(), height(p.x(), p.y()) + deviation * noise},
                   Vector3d::UnitZ()});
    }
  return surface;
}

/** The upper side of a tube along x. */
double
tube(double radius, double y)
{
  return std::sqrt(radius * radius - y * y) - radius;
}

TEST(SuctionGrasps, DoNotSealOnAStripNarrowerThanTheCup)
{
  Random random(903);
  const Grasps grasps = graspsOn(sheet({0, 0, 0}, 0.016, 0.08, random));
  ASSERT_FALSE(grasps.empty());
  for (const SuctionGrasp& grasp : grasps) {
    EXPECT_TRUE(has(grasp, SealProblem::Border));
    EXPECT_LT(grasp.covered, 1.0f);
    EXPECT_NEAR(grasp.border_distance, 0.008f, 0.003f);
  }
}

TEST(SuctionGrasps, AvoidAHole)
{
  Random random(904);
  Surface surface;
  const Surface whole = sheet({-0.03, -0.03, 0}, 0.06, 0.06, random);
  for (std::size_t i = 0; i < whole.size(); ++i)
    if (whole.position(i).norm() > 0.006)
      surface.add({whole.position(i), whole.normal(i)});
  const Grasps grasps = graspsOn(surface);
  ASSERT_FALSE(grasps.empty());
  EXPECT_TRUE(grasps.front().seals());
  for (const SuctionGrasp& grasp : grasps)
    EXPECT_TRUE(!grasp.seals() || grasp.position.norm() > 0.016f);
}

TEST(SuctionGrasps, KeepAwayFromACrease)
{
  Random random(905);
  Surface surface = dihedral(10000, 90, 0.1, random); // along the x axis
  Estimation estimation;
  estimation.setInputCloud(toCloud<PointXYZ>(surface));
  estimation.setViewPoint(0, 5, 5);
  const Grasps grasps = graspsOf(estimation);
  ASSERT_GE(grasps.size(), 2U);
  bool is_level = false, is_upright = false;
  for (const SuctionGrasp& grasp : grasps) {
    if (grasp.seals()) {
      EXPECT_GT(grasp.position.tail<2>().norm(), cup_radius);
      EXPECT_LT(grasp.position.tail<2>().minCoeff(), 1e-4f) << "on one of the planes";
      is_level = is_level || grasp.approach.z() < -0.99f;
      is_upright = is_upright || grasp.approach.y() < -0.99f;
    }
  }
  EXPECT_TRUE(is_level && is_upright) << "both faces are graspable";
}

TEST(SuctionGrasps, DoNotSealOverACrease)
{
  Random random(915);
  Estimation estimation;
  estimation.setInputCloud(toCloud<PointXYZ>(dihedral(1000, 90, 0.03, random)));
  estimation.setViewPoint(0, 5, 5);
  const Grasps grasps = graspsOf(estimation); // each face is 15 mm wide
  ASSERT_FALSE(grasps.empty());
  for (const SuctionGrasp& grasp : grasps) {
    EXPECT_TRUE(has(grasp, SealProblem::Edge));
    EXPECT_LT(grasp.edge_distance, cup_radius);
  }
}

TEST(SuctionGrasps, BendWithinTheComplianceOnly)
{
  Random random(906);
  for (const double radius : {0.04, 0.016}) {
    const double area = 2 * pi * radius * 0.1;
    const Surface tube = cylinder(
        static_cast<std::size_t>(area / (0.0015 * 0.0015)), radius, 0.1, random);
    Surface upper;
    for (std::size_t i = 0; i < tube.size(); ++i)
      if (tube.normal(i).y() > 0)
        upper.add({tube.position(i), tube.normal(i)});
    Estimation estimation;
    estimation.setInputCloud(toCloud<PointXYZ>(upper));
    estimation.setViewPoint(0, 5, 0);
    estimation.setSurface(Estimation::CURVED);
    const Grasps grasps = graspsOf(estimation);
    ASSERT_FALSE(grasps.empty());
    const SuctionGrasp& first = grasps.front();
    EXPECT_EQ(first.seals(), radius > 0.03);
    EXPECT_EQ(has(first, SealProblem::Bent), radius < 0.03);
    const auto sag = static_cast<float>(cup * cup / (2 * radius));
    EXPECT_NEAR(first.sag, sag, 0.2f * sag);
    EXPECT_EQ(first.surface, 2U);
    EXPECT_NEAR(first.position.head<2>().norm(), radius, 0.0003);
    const Vector3f outward(first.position.x(), first.position.y(), 0);
    EXPECT_LT((first.approach + outward.normalized()).norm(), 0.05f);
  }
}

TEST(SuctionGrasps, KeepAwayFromWhatStandsOnTheTarget)
{
  Random random(907);
  Surface surface = sheet({0, 0, 0}, 0.08, 0.04, random);
  const std::size_t own = surface.size();
  surface.append(sheet({0, 0, 0.015}, 0.04, 0.04, random)); // above the left half
  const Cloud::Ptr cloud = toCloud<PointXYZ>(surface);
  const auto target = make_shared<Indices>();
  for (std::size_t i = 0; i < own; ++i)
    target->push_back(static_cast<index_t>(i));
  Estimation estimation = seenFromAbove(cloud);
  estimation.setIndices(target);
  const Grasps grasps = graspsOf(estimation);
  ASSERT_FALSE(grasps.empty());
  EXPECT_TRUE(grasps.front().seals());
  for (const SuctionGrasp& grasp : grasps) {
    EXPECT_NEAR(grasp.position.z(), 0.0f, 1e-3f) << "on the target";
    EXPECT_EQ(has(grasp, SealProblem::Obstacle),
              grasp.position.x() < 0.04f + cup_radius + grasp.margin);
  }
}

TEST(SuctionGrasps, DoNotSealUnderSomethingElse)
{
  Random random(916);
  Surface surface = sheet({0, 0, 0}, 0.04, 0.04, random);
  const auto target = make_shared<Indices>();
  for (std::size_t i = 0; i < surface.size(); ++i)
    target->push_back(static_cast<index_t>(i));
  surface.append(sheet({0, 0, 0.015}, 0.04, 0.04, random));
  Estimation estimation = seenFromAbove(toCloud<PointXYZ>(surface));
  estimation.setIndices(target);
  const Grasps grasps = graspsOf(estimation);
  ASSERT_FALSE(grasps.empty());
  for (const SuctionGrasp& grasp : grasps)
    EXPECT_TRUE(has(grasp, SealProblem::Obstacle));
}

TEST(SuctionGrasps, EndWhereTheTargetEnds)
{
  Random random(908);
  const Cloud::Ptr cloud = toCloud<PointXYZ>(sheet({0, 0, 0}, 0.1, 0.06, random));
  const auto target = make_shared<Indices>();
  for (std::size_t i = 0; i < cloud->size(); ++i)
    if ((*cloud)[i].x < 0.05f)
      target->push_back(static_cast<index_t>(i));
  Estimation estimation = seenFromAbove(cloud);
  estimation.setIndices(target);
  const Grasps grasps = graspsOf(estimation);
  ASSERT_FALSE(grasps.empty());
  for (const SuctionGrasp& grasp : grasps)
    EXPECT_TRUE(!grasp.seals() || grasp.position.x() <= 0.05f - cup_radius);
}

TEST(SuctionGrasps, DoNotSealOnARoughSurface)
{
  Random random(909);
  Surface smooth = sheet({0, 0, 0}, 0.1, 0.06, random);
  Surface rough;
  for (std::size_t i = 0; i < smooth.size();
       ++i) { // one half has waves, less than the band
    Vector3d p = smooth.position(i);
    if (p.x() < 0.05)
      p.z() = 0.0009 * std::sin(2 * pi * p.x() / 0.0125);
    rough.add({p, smooth.normal(i)});
  }
  const Grasps grasps = graspsOn(rough);
  ASSERT_FALSE(grasps.empty());
  EXPECT_TRUE(grasps.front().seals());
  for (const SuctionGrasp& grasp : grasps)
    EXPECT_TRUE(!grasp.seals() || grasp.position.x() > 0.05f);
}

TEST(SuctionGrasps, SealWhereASoftBodyIsFlatEnough)
{
  // A ridge, where the likelihood has its mode, that is too narrow for the cup, between
  // flanks that are not.
  constexpr double ridge = 0.006, of_ridge = 1 / 0.016, of_flanks = 1 / 0.06;
  const auto height = [=](double, double y) {
    const double on_ridge = std::min(std::abs(y), ridge);
    const double beyond = std::abs(y) - on_ridge;
    return -of_ridge * on_ridge * (on_ridge / 2 + beyond) -
           of_flanks * beyond * beyond / 2;
  };
  for (const std::uint64_t seed : {920U, 921U, 922U}) {
    Random random(seed);
    Estimation estimation = seenFromAbove(toCloud<PointXYZ>(
        seenByACamera({Eigen::Vector2d(-0.018, -0.024), Eigen::Vector2d(0.018, 0.024)},
                      0.0003,
                      random,
                      height)));
    estimation.setSurface(Estimation::CURVED);
    const Grasps grasps = graspsOf(estimation);
    ASSERT_FALSE(grasps.empty());
    const SuctionGrasp& first = grasps.front();
    EXPECT_TRUE(first.seals()) << seed;
    const double y = first.position.y(); // across the cup, from rim to rim
    const Vector3d outward(0, height(0, y - cup) - height(0, y + cup), 2 * cup);
    const Vector3d approach = first.approach.cast<double>();
    constexpr double within = 0.0872; // 5 degrees
    EXPECT_LT((approach + outward.normalized()).norm(), within) << seed;
  }
}

TEST(SuctionGrasps, SealWithNoiseWhereTheyWouldWithout)
{
  // A tube as narrow as the cup allows.
  double sealing = 0, all = 0;
  for (const std::uint64_t seed : {930U, 931U}) {
    Random random(seed);
    const Surface body =
        seenByACamera({Eigen::Vector2d(0, -0.02), Eigen::Vector2d(0.2, 0.02)},
                      0.0003,
                      random,
                      [](double, double y) { return tube(0.025, y); });
    for (const SuctionGrasp& grasp : graspsOn(body))
      if (std::abs(grasp.position.x() - 0.1f) < 0.085f) {
        all += 1;
        sealing += grasp.seals() ? 1 : 0;
      }
  }
  EXPECT_GE(all, 8);
  EXPECT_GE(sealing, 0.8 * all);
}

} // namespace
