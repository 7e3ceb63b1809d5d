// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Scans of generated rooms: what they meet, how dense they are, and their truth.

#include "scene/checksum.h"
#include "scene/sensors/station_scan.h"
#include "scene/vector_at.h"
#include "scene/worlds/place.h"
#include "support/errors.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

using namespace pcl::scene;
using pcl_shape_test::vectorAt;

namespace {

constexpr double pi = 3.14159265358979323846;

StationOptions
coarse(std::uint64_t seed, unsigned stations = 1)
{
  StationOptions options;
  options.seed = seed;
  options.stations = stations;
  options.step = 1.5;
  options.sigma = 0.0;
  return options;
}

std::string
refusal(const StationOptions& options)
{
  return pcl::test::exceptionOf<std::invalid_argument>([&] { scanPlace(options); });
}

} // namespace

TEST(StationScan, PointsAreOnTheSurfacesOfTheRoom)
{
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    const Place room = randomRoom(seed);
    const Scene scene = scanPlace(coarse(seed, 2));
    EXPECT_EQ(scene.width, 2U * 240U * 100U) << "a room is closed: all rays return";
    for (std::size_t i = 0; i < scene.width; i += 3) {
      const Vec3 p = vectorAt(scene.xyz, i) + room.stations.front();
      bool is_on_one = false;
      for (std::size_t s = 0; s < room.world.solids.size() && !is_on_one; ++s)
        for (const FaceAt& at : facesAt(room.world.solids[s], p, 1e-5))
          is_on_one = is_on_one || norm(at.normal - vectorAt(scene.normals, i)) < 1e-5;
      ASSERT_TRUE(is_on_one) << "seed " << seed << " point " << i;
      const bool is_shell =
          std::abs(p.x) < 1e-5 || std::abs(p.y) < 1e-5 || std::abs(p.z) < 1e-5 ||
          std::abs(p.x - room.length) < 1e-5 || std::abs(p.y - room.width) < 1e-5;
      ASSERT_TRUE(!is_shell || scene.instance[i] == 0 || scene.edge[i] != EdgeNot);
    }
  }
}

TEST(StationScan, TheCornersOfTheRoomAreCreases)
{
  // Far from furniture the nearest crease of a point of the ceiling is where it meets a
  // wall, or the molding there.
  std::size_t compared = 0;
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    const Place room = randomRoom(seed);
    const Scene scene = scanPlace(coarse(seed));
    for (std::size_t i = 0; i < scene.width; ++i) {
      const Vec3 p = vectorAt(scene.xyz, i) + room.stations.front();
      if (scene.normals[3 * i + 2] > -0.9F || scene.instance[i] != 0 || p.z < 2.0)
        continue;
      const double to_wall = std::min({p.x, room.length - p.x, p.y, room.width - p.y});
      ASSERT_LE(scene.crease_mm[i], 1000.0 * std::min(0.5, to_wall) + 15.0);
      if (scene.edge[i] == EdgeNot && scene.crease_mm[i] < 499.0F)
        compared += std::abs(scene.crease_mm[i] - 1000.0 * to_wall) < 1.0;
    }
  }
  EXPECT_GT(compared, 1000U);
}

TEST(StationScan, NothingWithinAFaceIsACrease)
{
  std::size_t edges = 0;
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    const Place room = randomRoom(seed);
    StationOptions options = coarse(seed);
    options.step = 0.5;
    const Scene scene = scanPlace(options);
    for (std::size_t i = 0; i < scene.width; ++i) {
      if (scene.edge[i] != EdgeCrease)
        continue;
      ++edges;
      // Within its band, 1.5 rays or 5 mm, is a face of another direction.
      const Vec3 seen = vectorAt(scene.xyz, i), normal = vectorAt(scene.normals, i);
      const double range = norm(seen),
                   cosine = std::max(0.3, -dot(seen, normal) / range);
      const double ray = range * options.step * pi / 180.0 / std::sqrt(cosine);
      const double band = std::max(0.005, 1.5 * ray) + 1e-5;
      const Vec3 p = seen + room.stations.front();
      bool has_other = false;
      for (const Solid& solid : room.world.solids)
        for (const FaceAt& at : facesAt(solid, p, band))
          has_other = has_other || std::abs(dot(at.normal, normal)) < 0.9;
      ASSERT_TRUE(has_other) << "seed " << seed << " point " << i;
    }
  }
  EXPECT_GT(edges, 10000U);
}

TEST(StationScan, HouseFrontsHaveTruth)
{
  std::size_t creases = 0, round = 0, on_front = 0;
  for (std::uint64_t seed = 3; seed <= 4; ++seed) {
    StationOptions options = coarse(seed);
    options.is_outdoors = true;
    options.step = 0.4;
    const Place place = randomFacade(seed);
    ASSERT_EQ(place.stations.size(), 4U);
    const Scene scene = scanPlace(options);
    for (std::size_t i = 0; i < scene.width; ++i) {
      const Vec3 p = vectorAt(scene.xyz, i) + place.stations.front();
      creases += scene.edge[i] == EdgeCrease;
      const float across = std::abs(scene.normals[3 * i + 1]);
      round += scene.normals[3 * i + 2] == 0.0F && across > 0.1F && across < 0.9F;
      ASSERT_TRUE(scene.surface[i] != SurfaceCurved || scene.instance[i] > 0 ||
                  p.z > 2.0)
          << "round are columns, the pipe, arches and the bay";
      if (scene.instance[i] == 0 && p.z > 1e-5 && std::abs(p.y) < 1e-5) {
        ++on_front;
        ASSERT_NEAR(scene.normals[3 * i + 1], -1.0, 1e-6) << "towards the street";
      }
      if (i % 10 == 0) {
        bool is_on_one = false;
        for (const Solid& solid : place.world.solids)
          is_on_one = is_on_one || !facesAt(solid, p, 1e-5).empty();
        ASSERT_TRUE(is_on_one) << "seed " << seed << " point " << i;
      }
    }
  }
  EXPECT_GT(on_front, 5000U);
  EXPECT_GT(creases, 1000U);
  EXPECT_GT(round, 300U);
}

TEST(StationScan, DensityVariesByMoreThanAFactorOf30)
{
  const StationOptions options = coarse(3);
  const Scene scene = scanPlace(options);
  std::vector<double> areas; // of surface for each ray
  for (std::size_t i = 0; i < scene.width; ++i) {
    const Vec3 p = vectorAt(scene.xyz, i);
    const double range = norm(p), cosine = -dot(vectorAt(scene.normals, i), p) / range;
    const double up = std::sqrt(1.0 - p.z * p.z / (range * range));
    areas.push_back(range * range * up / cosine);
  }
  std::sort(areas.begin(), areas.end());
  const auto part = [&](double share) {
    return areas[static_cast<std::size_t>(share * static_cast<double>(areas.size()))];
  };
  EXPECT_GT(part(0.95) / part(0.05), 30.0);
}

TEST(StationScan, SeveralStationsSeeMoreCreases)
{
  const auto edges = [](const Scene& scene, std::size_t count) {
    return std::count(scene.edge.begin(),
                      scene.edge.begin() + static_cast<std::ptrdiff_t>(count),
                      EdgeCrease);
  };
  const Scene one = scanPlace(coarse(5)), three = scanPlace(coarse(5, 3));
  ASSERT_EQ(three.width, 3 * one.width);
  EXPECT_TRUE(std::equal(one.xyz.begin(), one.xyz.end(), three.xyz.begin()));
  EXPECT_GT(edges(three, one.width), edges(one, one.width))
      << "of the same points more are beside a crease of which both faces are seen";
}

TEST(StationScan, NoiseIsAlongTheRay)
{
  StationOptions options = coarse(6);
  const Scene exact = scanPlace(options);
  options.sigma = 0.002;
  const Scene noisy = scanPlace(options);
  ASSERT_EQ(exact.edge, noisy.edge);
  double sum = 0.0;
  for (std::size_t i = 0; i < exact.width; ++i) {
    const Vec3 p = vectorAt(exact.xyz, i), q = vectorAt(noisy.xyz, i);
    ASSERT_NEAR(dot(p, q), norm(p) * norm(q), 1e-5);
    sum += (norm(p) - norm(q)) * (norm(p) - norm(q));
  }
  EXPECT_NEAR(std::sqrt(sum / exact.width), 0.002, 0.00005);
  EXPECT_EQ(noisy.xyz, scanPlace(options).xyz);
}

TEST(StationScan, SameOnEveryMachine)
{
  StationOptions options;
  options.seed = 9;
  options.step = 1.5;
  options.stations = 2;
  const Scene scene = scanPlace(options);
  EXPECT_EQ(pcl_shape_test::checksum(scene), 0x388fe629b098066bULL);
  EXPECT_NEAR(scene.xyz[30000], -0.91440868, 1e-6);
  EXPECT_NEAR(scene.xyz[30001], 1.63279414, 1e-6);
}

TEST(StationScan, BadOptions)
{
  StationOptions options;
  options.step = 3.0;
  EXPECT_EQ(refusal(options), "step must be 0.05 to 2 degrees, not 3");
  options = {};
  options.stations = 9;
  EXPECT_EQ(refusal(options), "stations must be 1 to 4, not 9");
  options.seed = 1483;
  options.stations = 3;
  EXPECT_EQ(refusal(options),
            "stations must be 1 to 2 in the room of seed 1483, not 3");
  options = {};
  options.sigma = 1.0;
  EXPECT_EQ(refusal(options), "sigma must be 0 to 0.1 m, not 1");
}
