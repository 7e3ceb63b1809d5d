// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Two creases close to each other stay two.

#include "segmentation/detection_scenes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

// Two parallel creases that are near each other must stay two.
namespace {

using namespace pcl;
using namespace pcl::test;
using Lines = std::vector<CreaseLine>;

constexpr double degree = pi / 180;
constexpr double spacing = 0.01; // mean distance of points; half of the method's d

/** \brief Flat strips side by side along x, from 0 to 1, each as wide as its part of a
 * polygon in the plane of y and z. */
class Strips {
public:
  explicit Strips(std::vector<Eigen::Vector2d> corners) : corners_(std::move(corners))
  {
    for (std::size_t i = 0; i + 1 < corners_.size(); ++i)
      length_ += width(i);
  }

  std::size_t
  points() const
  {
    return static_cast<std::size_t>(length_ / (spacing * spacing));
  }

  SurfacePoint
  operator()(Random& random) const
  {
    double along = random.uniform() * length_;
    std::size_t i = 0;
    while (i + 2 < corners_.size() && along > width(i))
      along -= width(i++);
    const Eigen::Vector2d direction = (corners_[i + 1] - corners_[i]).normalized();
    const Eigen::Vector2d p = corners_[i] + along * direction;
    return {{random.uniform(), p.x(), p.y()}, {0.0, -direction.y(), direction.x()}};
  }

private:
  double
  width(std::size_t i) const
  {
    return (corners_[i + 1] - corners_[i]).norm();
  }

  std::vector<Eigen::Vector2d> corners_;
  double length_ = 0.0;
};

constexpr double d = 2 * spacing; // what the method measures lengths in

/** \brief Two creases `width` apart, of a right angle each. */
struct Pair {
  const char* name;
  std::vector<Eigen::Vector2d> corners;
  Eigen::Vector2d first, second; ///< where the creases are
};

std::vector<Pair>
pairs(double width)
{
  return {{"a step: one convex, one concave",
           {{-0.3, 0.0}, {0.0, 0.0}, {0.0, width}, {0.3, width}},
           {0.0, 0.0},
           {0.0, width}},
          {"a bar: both convex, or a groove from its other side",
           {{0.0, -0.3}, {0.0, 0.0}, {width, 0.0}, {width, -0.3}},
           {0.0, 0.0},
           {width, 0.0}}};
}

Surface
surfaceOf(const Pair& pair, double noise)
{
  const Strips strips(pair.corners);
  Random random(91);
  Surface surface = sampled(strips.points(), random, strips);
  surface.addNoise(noise, random);
  return surface;
}

double
farthest(const CreaseLine& line, const Eigen::Vector2d& crease)
{
  double farthest = 0.0;
  for (const auto& p : line.points)
    farthest = std::max(farthest, std::hypot(p[1] - crease.x(), p[2] - crease.y()));
  return farthest;
}

void
expectTwoLines(const Lines& lines, const Pair& pair)
{
  ASSERT_EQ(2U, lines.size());
  const std::size_t on_first =
      farthest(lines[0], pair.first) < farthest(lines[1], pair.first) ? 0 : 1;
  EXPECT_LE(farthest(lines[on_first], pair.first), 0.5 * d);
  EXPECT_LE(farthest(lines[1 - on_first], pair.second), 0.5 * d);
  for (const CreaseLine& line : lines) {
    EXPECT_NEAR(line.length, 1.0, 3 * d);
    EXPECT_NEAR(line.angle, pi / 2, 3 * degree);
    EXPECT_FALSE(line.closed);
  }
}

TEST(CloseCreases, AreTwoLines)
{
  const struct {
    double noise;
    std::vector<double> widths;
  } cases[] = {{0.0, {3 * d, 4 * d, 5 * d}},
               {0.05 * d, {4 * d, 5 * d}},
               {0.2 * d, {6 * d, 8 * d}}}; // as a Kinect's
  for (const auto& [noise, widths] : cases) {
    for (const double width : widths) {
      for (const Pair& pair : pairs(width)) {
        SCOPED_TRACE(pair.name + std::string(", noise and width in d: ") +
                     std::to_string(noise / d) + " " + std::to_string(width / d));
        const auto cloud = toCloud<PointXYZ>(surfaceOf(pair, noise));
        expectTwoLines(creaseLines(detectedIn(cloud).creases), pair);
      }
    }
  }
}

/** \brief Bars that are as wide as the gaps between them, up to 12 * width along y. */
Strips
ribs(double width)
{
  std::vector<Eigen::Vector2d> corners{{-0.1, 0.0}};
  for (int rib = 0; rib < 6; ++rib) {
    const double y = 2 * rib * width;
    corners.insert(corners.end(),
                   {{y, 0.0}, {y, width}, {y + width, width}, {y + width, 0.0}});
  }
  corners.emplace_back(12 * width, 0.0);
  return Strips(std::move(corners));
}

TEST(CloseCreases, OfRibsAreFoundInWhiteNoise)
{
  const double width = 4 * d;
  for (const double noise : {0.0, 0.07 * d, 0.15 * d}) {
    SCOPED_TRACE("noise in d: " + std::to_string(noise / d));
    const Strips strips = ribs(width);
    Random random(92);
    Surface surface = sampled(strips.points(), random, strips);
    const Surface exact = surface;
    surface.addNoise(noise, random);
    const std::vector<float> likelihood = edgesOf(toCloud<PointXYZ>(surface));
    double on = 0, found = 0, off = 0, false_alarms = 0;
    for (std::size_t i = 0; i < surface.size(); ++i) {
      const Eigen::Vector3d p = exact.position(i);
      const double across = std::abs(std::remainder(p.y(), width));
      const double up = std::min(p.z(), width - p.z());
      const bool is_rib = p.y() > -0.5 * d && p.y() < 11.5 * width;
      const bool is_on = is_rib && up < 0.5 * d && across < 0.5 * d;
      const bool is_off = is_rib && std::max(up, across) > 1.5 * d;
      const bool is_edge = likelihood[i] > 0.5f;
      on += is_on ? 1 : 0;
      found += is_on && is_edge ? 1 : 0;
      off += is_off ? 1 : 0;
      false_alarms += is_off && is_edge ? 1 : 0;
    }
    ASSERT_GT(on, 1000);
    ASSERT_GT(off, 1000);
    EXPECT_GE(found, 0.98 * on);
    if (noise == 0.0) { // with noise, bands are half as wide as the ribs
      EXPECT_LE(false_alarms, 0.01 * off);
    }
  }
}

TEST(CloseCreases, AreTwoBandsOfEdges)
{
  for (const Pair& pair : pairs(5 * d)) {
    SCOPED_TRACE(pair.name);
    const Surface surface = surfaceOf(pair, 0.0);
    const std::vector<float> likelihood = edgesOf(toCloud<PointXYZ>(surface));
    double on = 0, found = 0, between = 0, false_alarms = 0;
    for (std::size_t i = 0; i < surface.size(); ++i) {
      const Eigen::Vector3d p = surface.position(i);
      const double to_first = (p.tail<2>() - pair.first).norm();
      const double to_second = (p.tail<2>() - pair.second).norm();
      const double nearest = std::min(to_first, to_second);
      const bool is_edge = likelihood[i] > 0.5f;
      on += nearest < 0.5 * d ? 1 : 0;
      found += nearest < 0.5 * d && is_edge ? 1 : 0;
      const bool is_between =
          std::max(to_first, to_second) < 5 * d && nearest > 1.5 * d;
      between += is_between ? 1 : 0;
      false_alarms += is_between && is_edge ? 1 : 0;
    }
    ASSERT_GT(between, 300);
    EXPECT_GE(found, 0.97 * on);
    EXPECT_LE(false_alarms, 0.02 * between);
  }
}

} // namespace
