// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Scans of generated streets: beams, truth, noise and bad options.

#include "scene/sensors/lidar.h"
#include "scene/worlds/street.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <tuple>

using namespace pcl::scene;

namespace {

LidarOptions
exact(std::uint64_t seed, unsigned beams = 16)
{
  LidarOptions options;
  options.seed = seed;
  options.beams = beams;
  options.sigma = 0.0;
  options.drop_outs = false;
  return options;
}

Vec3
pointOf(const LidarScan& scan, std::size_t i)
{
  return {scan.xyz[3 * i], scan.xyz[3 * i + 1], scan.xyz[3 * i + 2]};
}

double
degreesUp(const Vec3& p)
{
  return std::asin(p.z / norm(p)) * 180.0 / std::acos(-1.0);
}

std::string
refusal(const LidarOptions& options)
{
  try {
    scanStreet(options);
  }
  catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "none";
}

} // namespace

TEST(Lidar, BeamsAreThoseOfTheDataSheets)
{
  const std::vector<double> many = beamElevations(64), few = beamElevations(16);
  ASSERT_EQ(many.size(), 64U);
  ASSERT_EQ(few.size(), 16U);
  EXPECT_NEAR(many.front(), -24.33, 0.01);
  EXPECT_NEAR(many[31], -8.83, 0.01);
  EXPECT_NEAR(many[32], -8.33, 0.01);
  EXPECT_DOUBLE_EQ(many.back(), 2.0);
  EXPECT_DOUBLE_EQ(few.front(), -15.0);
  EXPECT_DOUBLE_EQ(few.back(), 15.0);
  EXPECT_TRUE(std::is_sorted(many.begin(), many.end()));
  EXPECT_TRUE(std::is_sorted(few.begin(), few.end()));
}

TEST(Lidar, PointsLieOnTheirBeamsAndWithinReach)
{
  for (const unsigned beams : {16U, 64U}) {
    const std::vector<double> elevations = beamElevations(beams);
    const LidarScan scan = scanStreet(exact(41, beams));
    EXPECT_GT(scan.size(), beams * 1000U);
    for (std::size_t i = 0; i < scan.size(); ++i) {
      const Vec3 p = pointOf(scan, i);
      ASSERT_NEAR(degreesUp(p), elevations[scan.ring[i]], 1e-3);
      ASSERT_LE(norm(p), scan.ground[i] == GroundTrue ? 50.001 : 120.001);
    }
  }
}

TEST(Lidar, TruthIsWhatTheRayMet)
{
  for (std::uint64_t seed = 42; seed < 45; ++seed) {
    const Street street = randomStreet(seed);
    const LidarScan scan = scanStreet(exact(seed));
    ASSERT_EQ(scan.objects, street.objects);
    std::size_t curbs = 0;
    for (std::size_t i = 0; i < scan.size(); ++i) {
      const Vec3 p = pointOf(scan, i);
      const StreetPoint at = street.ground.toStreet(p.x, p.y);
      const double above = p.z - street.ground.height(at);
      if (scan.ground[i] == GroundTrue) {
        ASSERT_NEAR(above, 0.0, 1e-3);
        ASSERT_EQ(scan.instance[i], 0U);
        ASSERT_GT(scan.normals[3 * i + 2], 0.9F);
      }
      else if (scan.ground[i] == GroundVoid) {
        ++curbs;
        ASSERT_NEAR(std::abs(at.t), street.ground.profile.half_width, 1e-3);
        ASSERT_EQ(scan.normals[3 * i + 2], 0.0F);
      }
      else {
        ASSERT_GT(above, -1e-3);
        bool is_on_one = false;
        for (std::size_t s = 0; s < street.solids.size(); ++s)
          is_on_one = is_on_one || (street.instances[s] == scan.instance[i] &&
                                    !facesAt(street.solids[s], p, 1e-3).empty());
        ASSERT_TRUE(is_on_one) << i;
      }
      const Vec3 normal{
          scan.normals[3 * i], scan.normals[3 * i + 1], scan.normals[3 * i + 2]};
      ASSERT_LE(dot(normal, p), 1e-6);
    }
    EXPECT_GT(curbs, 0U);
  }
}

TEST(Lidar, StreetsHaveCurbsSlopesAndThings)
{
  double min_grade = 1.0, max_grade = -1.0;
  for (std::uint64_t seed = 50; seed < 80; ++seed) {
    const Street street = randomStreet(seed);
    const StreetProfile& profile = street.ground.profile;
    min_grade = std::min(min_grade, profile.grade);
    max_grade = std::max(max_grade, profile.grade);
    const double edge = profile.half_width;
    const double step =
        street.ground.height({3.0, edge + 1e-9}) - street.ground.height({3.0, edge});
    EXPECT_NEAR(step, profile.curb, 1e-6);
    EXPECT_GT(street.objects, 20U);
    const StreetPoint below = street.ground.toStreet(0.0, 0.0);
    EXPECT_NEAR(street.ground.height(below), -profile.height, 1e-9);
  }
  EXPECT_LT(min_grade, -0.02);
  EXPECT_GT(max_grade, 0.02);
}

TEST(Lidar, NoiseIsAlongTheRay)
{
  const LidarScan truth = scanStreet(exact(61));
  LidarOptions noisy = exact(61);
  noisy.sigma = 0.03;
  const LidarScan scan = scanStreet(noisy);
  ASSERT_EQ(scan.size(), truth.size());
  double sum = 0.0;
  for (std::size_t i = 0; i < scan.size(); ++i) {
    const Vec3 p = pointOf(scan, i), q = pointOf(truth, i);
    ASSERT_NEAR(dot(p, q), norm(p) * norm(q), 1e-6 * dot(q, q));
    sum += (norm(p) - norm(q)) * (norm(p) - norm(q));
  }
  EXPECT_NEAR(std::sqrt(sum / static_cast<double>(scan.size())), 0.03, 0.001);
}

TEST(Lidar, SeedsDecide)
{
  LidarOptions options;
  options.beams = 16;
  options.seed = 62;
  const LidarScan scan = scanStreet(options), again = scanStreet(options);
  EXPECT_EQ(scan.xyz, again.xyz);
  EXPECT_EQ(scan.ground, again.ground);
  options.seed = 63;
  EXPECT_NE(scan.xyz, scanStreet(options).xyz);
  EXPECT_LT(scan.size(), scanStreet(exact(62)).size()) << "some returns get lost";
}

TEST(Lidar, RosettesLookForwardOnly)
{
  for (const auto& [pattern, width, height] :
       {std::make_tuple(LidarPattern::Rosette70, 70.4, 77.2),
        std::make_tuple(LidarPattern::Rosette120, 120.0, 25.0)}) {
    LidarOptions options = exact(64);
    options.pattern = pattern;
    const LidarScan scan = scanStreet(options);
    EXPECT_GT(scan.size(), 5000U);
    for (std::size_t i = 0; i < scan.size(); ++i) {
      const Vec3 p = pointOf(scan, i);
      ASSERT_LE(std::abs(degreesUp(p)), 0.5 * height + 1e-3);
      ASSERT_LE(std::abs(std::atan2(p.y, p.x)) * 180.0 / std::acos(-1.0),
                0.5 * width + 1e-3);
    }
  }
}

TEST(Lidar, FillersStandForRaysThatDoNotReturn)
{
  LidarOptions options = exact(65);
  const LidarScan without = scanStreet(options);
  options.fillers = true;
  const LidarScan with = scanStreet(options);
  EXPECT_EQ(with.size(), 16U * 1800U);
  std::size_t fillers = 0;
  for (std::size_t i = 0; i < with.size(); ++i) {
    const bool is_filler = squaredNorm(pointOf(with, i)) == 0.0;
    fillers += is_filler;
    ASSERT_TRUE(!is_filler || with.ground[i] == GroundNot);
  }
  EXPECT_EQ(with.size() - fillers, without.size());
}

TEST(Lidar, WetGroundShowsWhatIsBehindBelowIt)
{
  LidarOptions options = exact(66, 64);
  options.mirrors = true;
  const LidarScan scan = scanStreet(options);
  const Street street = randomStreet(66);
  std::size_t below = 0;
  for (std::size_t i = 0; i < scan.size(); ++i) {
    const Vec3 p = pointOf(scan, i);
    const bool is_below =
        p.z < street.ground.height(street.ground.toStreet(p.x, p.y)) - 0.1;
    below += is_below;
    ASSERT_TRUE(!is_below || scan.ground[i] != GroundTrue);
  }
  EXPECT_GT(below, 20U);
  EXPECT_LT(below, scan.size() / 50);
}

TEST(Lidar, AMovingScannerSeesEachRayFromWhereItIs)
{
  LidarOptions options = exact(68);
  options.speed = 20.0;
  options.yaw_rate = 45.0;
  const LidarScan scan = scanStreet(options);
  const StreetGround ground = randomStreet(68).ground;
  const double pi = std::acos(-1.0);
  std::size_t on_road = 0, off_in_one_frame = 0;
  for (std::size_t i = 0; i < scan.size(); ++i) {
    const Vec3 p = pointOf(scan, i);
    if (scan.ground[i] != GroundTrue || norm(p) > 20.0)
      continue;
    // Columns are fired clockwise, all in a tenth of a second.
    double angle = std::atan2(-p.y, p.x) / (2.0 * pi);
    angle = angle < 0.0 ? angle + 1.0 : angle;
    const double time = std::round(angle * 1800.0 - 0.5) / 1800.0;
    const double yaw = 4.5 * time * pi / 180.0, way = 2.0 * time;
    const double c = std::cos(yaw), s = std::sin(yaw);
    const Vec3 at{way * std::cos(0.5 * yaw), way * std::sin(0.5 * yaw), 0.0};
    const double x = at.x + c * p.x - s * p.y, y = at.y + s * p.x + c * p.y;
    const double z =
        p.z + ground.height(ground.toStreet(at.x, at.y)) + ground.profile.height;
    ASSERT_NEAR(ground.height(ground.toStreet(x, y)), z, 2e-3);
    ++on_road;
    off_in_one_frame += std::abs(ground.height(ground.toStreet(p.x, p.y)) - p.z) > 0.01;
  }
  EXPECT_GT(on_road, 5000U);
  EXPECT_GT(off_in_one_frame, on_road / 20);
}

TEST(Lidar, PlacesHaveCeilingsAndFields)
{
  for (const StreetPlace place : {StreetPlace::Garage,
                                  StreetPlace::Tunnel,
                                  StreetPlace::Corridor,
                                  StreetPlace::Hall}) {
    LidarOptions options = exact(67);
    options.place = place;
    const LidarScan scan = scanStreet(options);
    std::size_t ceiling = 0;
    for (std::size_t i = 0; i < scan.size(); ++i)
      ceiling += scan.normals[3 * i + 2] < -0.9F && pointOf(scan, i).z > 0.0;
    EXPECT_GT(ceiling, 100U) << static_cast<int>(place);
  }
  const Street fields = randomStreet(67, StreetPlace::Country);
  const double edge = fields.ground.profile.half_width;
  EXPECT_GT(fields.ground.profile.grass, 0.0);
  EXPECT_NEAR(
      fields.ground.height({0.0, edge + 1e-9}), fields.ground.height({0.0, edge}), 1e-6)
      << "no curb";
  const Street deck = randomStreet(67, StreetPlace::Deck);
  EXPECT_LT(deck.ground.height({0.0, 12.0}), deck.ground.height({0.0, 0.0}) - 2.0);
}

TEST(Lidar, RefusesBadOptions)
{
  LidarOptions options;
  options.beams = 33;
  EXPECT_EQ(refusal(options), "beams must be 16, 32, 64 or 128, not 33");
  options = {};
  for (const double sigma : {-0.001, 0.2, std::nan("")}) {
    options.sigma = sigma;
    EXPECT_NE(refusal(options).find("must be 0 to 0.1 m, not "), std::string::npos);
  }
  options = {};
  options.speed = -1.0;
  EXPECT_EQ(refusal(options), "speed must be 0 to 60 m/s, not -1");
  options = {};
  options.yaw_rate = 200.0;
  EXPECT_EQ(refusal(options),
            "yaw_rate must be -180 to 180 degrees per second, not 200");
}
