// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Crease lines on analytic creases: their number, length, angle and ends.

#include "segmentation/detection_scenes.h"
#include "support/errors.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace {

using namespace pcl;
using namespace pcl::test;
using Lines = std::vector<CreaseLine>;

constexpr double degree = pi / 180;

Lines
linesIn(const Cloud::Ptr& cloud, unsigned threads = 0)
{
  return creaseLines(detectedIn(cloud, threads).creases);
}

/** \brief Crease points along a line: at(0) to at(1), four in each spacing of 1 cm. */
template <typename At>
std::vector<CreasePoint>
pointsAlong(double length, const At& at)
{
  constexpr double spacing = 0.01, step = 1e-4;
  std::vector<CreasePoint> points;
  const auto count = static_cast<std::size_t>(4 * length / spacing);
  for (std::size_t i = 0; i <= count; ++i) {
    const double t = static_cast<double>(i) / static_cast<double>(count);
    const Eigen::Vector3f p = at(t).template cast<float>();
    const Eigen::Vector3f d =
        (at(t + step) - at(t - step)).normalized().template cast<float>();
    points.push_back({{p.x(), p.y(), p.z()}, {d.x(), d.y(), d.z()}, 1.0f, 0.01f});
  }
  return points;
}

std::vector<CreasePoint>
straight(double length)
{
  return pointsAlong(length,
                     [=](double t) { return Eigen::Vector3d(length * t, 1, 2); });
}

bool
areSame(const Lines& a, const Lines& b)
{
  return std::equal(
      a.begin(), a.end(), b.begin(), b.end(), [](const auto& one, const auto& other) {
        return one.points == other.points && one.length == other.length &&
               one.angle == other.angle && one.closed == other.closed;
      });
}

TEST(CreaseLines, TheEdgesOfACube)
{
  Random random(81);
  Surface cube = sampled(30000, random, onCube);
  cube.addNoise(0.002, random);
  const Lines lines = linesIn(toCloud<PointXYZ>(cube));
  ASSERT_EQ(12U, lines.size());
  for (const CreaseLine& line : lines) {
    // At either end, up to 3 spacings where three faces meet are no crease of two.
    EXPECT_GE(line.length, 1.0 - 6 * line.spacing);
    EXPECT_LE(line.length, 1.0 + line.spacing);
    EXPECT_NEAR(line.angle, pi / 2, 2 * degree);
    EXPECT_LE(line.points.size(), 4U);
    EXPECT_FALSE(line.closed);
  }
}

TEST(CreaseLines, TheFoldOfASheet)
{
  for (const double between_faces : {60.0, 90.0, 120.0}) {
    Random random(84);
    Surface sheet = dihedral(10000, between_faces, 1.0, random);
    sheet.addNoise(0.002, random);
    const Lines lines = linesIn(toCloud<PointXYZ>(sheet));
    ASSERT_EQ(1U, lines.size()) << between_faces;
    EXPECT_NEAR(lines[0].length, 1.0, 6 * lines[0].spacing);
    EXPECT_NEAR(lines[0].angle, pi - between_faces * degree, 3 * degree);
    for (const auto& p : lines[0].points)
      EXPECT_LE(std::hypot(p[1], p[2]), 0.5 * lines[0].spacing);
  }
}

TEST(CreaseLines, ACircleIsClosed)
{
  constexpr double radius = 0.2; // 20 spacings
  const Lines lines = creaseLines(pointsAlong(2 * pi * radius, [](double t) {
    return Eigen::Vector3d(
        radius * std::cos(2 * pi * t), radius * std::sin(2 * pi * t), 0);
  }));
  ASSERT_EQ(1U, lines.size());
  EXPECT_TRUE(lines[0].closed);
  EXPECT_EQ(lines[0].points.front(), lines[0].points.back());
  // Chords that leave a circle by half a spacing are shorter by 2 %.
  EXPECT_NEAR(lines[0].length, 2 * pi * radius, 0.02 * 2 * pi * radius);
  EXPECT_LT(lines[0].points.size(), 40U);
}

TEST(CreaseLines, ShortOnesAreLeftOutAndGapsAreBridged)
{
  EXPECT_TRUE(creaseLines({}).empty());
  EXPECT_TRUE(creaseLines(straight(0.045)).empty());
  EXPECT_EQ(1U, creaseLines(straight(0.07)).size());
  const auto withGap = [](double gap) {
    auto points = straight(0.6);
    points.erase(std::remove_if(points.begin(),
                                points.end(),
                                [gap](const CreasePoint& p) {
                                  return p.position[0] > 0.3 &&
                                         p.position[0] < 0.3 + gap;
                                }),
                 points.end());
    return creaseLines(points);
  };
  EXPECT_EQ(1U, withGap(0.04).size());
  EXPECT_EQ(2U, withGap(0.08).size());
}

TEST(CreaseLines, ARightAngleIsTwoLines)
{
  auto points = straight(0.3);
  const auto other =
      pointsAlong(0.2, [](double t) { return Eigen::Vector3d(0.3, 1 + 0.2 * t, 2); });
  points.insert(points.end(), other.begin(), other.end());
  const Lines lines = creaseLines(points);
  ASSERT_EQ(2U, lines.size());
  EXPECT_NEAR(lines[0].length, 0.3, 0.005);
  EXPECT_NEAR(lines[1].length, 0.2, 0.005);
}

TEST(CreaseLines, ThreadsAndOrderDoNotMatter)
{
  const auto cloud = cloudOf(sampledScene(24));
  const Lines expected = linesIn(cloud, 1);
  ASSERT_FALSE(expected.empty());
  EXPECT_TRUE(areSame(expected, linesIn(cloud, 3)));
  auto creases = detectedIn(cloud).creases;
  std::reverse(creases.begin(), creases.end());
  EXPECT_TRUE(areSame(expected, creaseLines(creases)));
}

TEST(CreaseLines, BadCreasePointsAreRefused)
{
  const auto refuse = [](const auto& spoil, const std::vector<std::string>& parts) {
    auto points = straight(0.3);
    spoil(points[7]);
    expectParts(exceptionOf<std::invalid_argument>([&] { creaseLines(points); }),
                parts);
    Edges edges;
    edges.creases = points;
    ShapeEdgeDetection<PointXYZ> detection;
    Lines lines;
    const std::string error = errorsOf([&] { lines = detection.linesOf(edges); });
    expectParts(error, {"linesOf", "crease point 7", "must be"});
    EXPECT_TRUE(lines.empty());
  };
  refuse([](auto& p) { p.position[1] = NAN; },
         {"crease point 7", "position", "finite"});
  refuse([](auto& p) { p.direction[0] = 0.5f; }, {"crease point 7", "0.5", "1"});
  refuse([](auto& p) { p.angle = -0.25f; }, {"angle", "-0.25", "0 to pi"});
  refuse([](auto& p) { p.spacing = 0.0f; }, {"spacing", "0.0", "positive"});
}

} // namespace
