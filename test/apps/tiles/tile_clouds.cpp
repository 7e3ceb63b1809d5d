// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Clouds of surfaces with strays, equal points and NaN, for tests of tiles.

#include "tile_clouds.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numeric>
#include <random>

namespace pcl_shape_test {
namespace {

/** Numbers that are the same with every standard library. */
class Random {
public:
  explicit Random(unsigned seed) : engine_(seed) {}

  double
  operator()(double low, double high)
  {
    return low + (high - low) * static_cast<double>(engine_()) / 4294967296.0;
  }

  /** Nearly normal, of mean 0 and deviation 1. */
  double
  normal()
  {
    double sum = 0.0;
    for (int i = 0; i < 12; ++i)
      sum += (*this)(-0.5, 0.5);
    return sum;
  }

  std::uint32_t
  below(std::uint32_t end)
  {
    return static_cast<std::uint32_t>(engine_()) % end;
  }

private:
  std::mt19937 engine_;
};

/** A rectangle, or a part of a cylinder around an upright axis. */
struct Patch {
  TilePoint corner, u, v;
  double radius = 0.0;

  double
  area() const
  {
    const auto length = [](const TilePoint& a) {
      return std::sqrt(a[0] * a[0] + a[1] * a[1] + a[2] * a[2]);
    };
    return radius > 0.0 ? 2.0 * 3.14159265 * radius * length(v) : length(u) * length(v);
  }

  TilePoint
  at(double s, double t, double off) const
  {
    TilePoint p;
    for (std::size_t i = 0; i < 3; ++i)
      p[i] = corner[i] + s * u[i] + t * v[i] + off;
    if (radius > 0.0) {
      const double turn = 2.0 * 3.14159265 * s;
      p = {corner[0] + (radius + off) * std::cos(turn),
           corner[1] + (radius + off) * std::sin(turn),
           corner[2] + t * v[2]};
    }
    return p;
  }
};

TilePointCloud
sampled(const std::vector<Patch>& patches, std::size_t points, double noise)
{
  Random random(7);
  double area = 0.0;
  for (const Patch& patch : patches)
    area += patch.area();
  TilePointCloud cloud;
  for (const Patch& patch : patches)
    for (double left = static_cast<double>(points) * patch.area() / area; left > 0.0;
         left -= 1.0)
      cloud.push_back(
          patch.at(random(0.0, 1.0), random(0.0, 1.0), noise * random.normal()));
  return cloud;
}

void
addBox(const TilePoint& low, const TilePoint& size, std::vector<Patch>& patches)
{
  const auto [x, y, z] = low;
  const auto [a, b, c] = size;
  patches.push_back({{x, y, z + c}, {a, 0, 0}, {0, b, 0}});
  patches.push_back({{x, y, z}, {a, 0, 0}, {0, 0, c}});
  patches.push_back({{x, y + b, z}, {a, 0, 0}, {0, 0, c}});
  patches.push_back({{x, y, z}, {0, b, 0}, {0, 0, c}});
  patches.push_back({{x + a, y, z}, {0, b, 0}, {0, 0, c}});
}

constexpr int half_corner = 110; // pixels

/** Where two walls meet, in a column of a Kinect's image at a distance in meters. */
void
addCornerOfKinect(double distance, int middle, Random& random, TilePointCloud& cloud)
{
  constexpr double focal_length = 575.0;     // pixels
  constexpr double disparity_step = 0.00287; // 35 mm at 3.5 m
  for (int row = -half_corner; row < half_corner; ++row)
    for (int column = -half_corner; column < half_corner; ++column) {
      const double x = column / focal_length, y = row / focal_length;
      const double range =
          std::min(distance / (1.0 - 0.6 * x), distance / (1.0 + 1.2 * x));
      const double steps = 1.0 / (range * disparity_step) + random(-0.2, 0.2);
      const double z = 1.0 / (disparity_step * std::round(steps));
      cloud.push_back({(x + middle / focal_length) * z, y * z, z});
    }
}

} // namespace

TilePointCloud
roomCloud(std::size_t points)
{
  std::vector<Patch> patches{{{0, 0, 0}, {6, 0, 0}, {0, 5, 0}},
                             {{0, 0, 2.5}, {6, 0, 0}, {0, 5, 0}},
                             {{0, 0, 0}, {6, 0, 0}, {0, 0, 2.5}},
                             {{0, 5, 0}, {6, 0, 0}, {0, 0, 2.5}},
                             {{0, 0, 0}, {0, 5, 0}, {0, 0, 2.5}},
                             {{6, 0, 0}, {0, 5, 0}, {0, 0, 2.5}}};
  addBox({2, 2, 0}, {1.5, 0.9, 0.7}, patches);
  patches.push_back({{4.8, 3.5, 0}, {0, 0, 0}, {0, 0, 2.5}, 0.3});
  return sampled(patches, points, 0.003);
}

TilePointCloud
streetCloud(std::size_t points)
{
  std::vector<Patch> patches{{{0, -3, 0}, {60, 0, 0}, {0, 6, 0}},
                             {{0, 3, 0}, {60, 0, 0}, {0, 0, 0.15}},
                             {{0, 3, 0.15}, {60, 0, 0}, {0, 2, 0}},
                             {{0, -3, 0}, {60, 0, 0}, {0, 0, 0.15}},
                             {{0, -5, 0.15}, {60, 0, 0}, {0, 2, 0}},
                             {{0, 5, 0.15}, {60, 0, 0}, {0, 0, 6}},
                             {{0, -5, 0.15}, {40, 0, 0}, {0, 0, 6}}};
  for (double x = 5.0; x < 60.0; x += 12.0)
    patches.push_back({{x, 4, 0.15}, {0, 0, 0}, {0, 0, 4}, 0.15});
  addBox({20, -2.5, 0}, {4, 1.8, 1.4}, patches);
  TilePointCloud cloud = sampled(patches, points * 2, 0.002);
  Random random(8);
  TilePointCloud denser;
  for (const TilePoint& p : cloud)
    if (random(0.0, 1.0) < 1.0 / (1.0 + 0.02 * std::abs(p[0] - 30.0)))
      denser.push_back(p);
  return denser;
}

TilePointCloud
sheetCloud(std::size_t points)
{
  Random random(9);
  TilePointCloud cloud;
  for (std::size_t i = 0; i < points; ++i) {
    const double x = random(-10.0, 10.0), y = random(-10.0, 10.0);
    cloud.push_back({x, y, 0.5 * std::sin(0.8 * x) * std::cos(0.6 * y)});
  }
  return cloud;
}

TilePointCloud
pathCloud(std::size_t points)
{
  Random random(11);
  TilePointCloud cloud;
  for (std::size_t i = 0; i < points; ++i) {
    const double x = random(0.0, 75.0), y = random(0.0, 4.0);
    const double wave = x < 40.0 ? 0.4 * std::sin(1.7 * y) : 0.0;
    const double roof = std::abs(x - 60.0); // its ridge is an edge
    cloud.push_back({x + 0.004 * random.normal(),
                     y + 0.004 * random.normal(),
                     wave + roof + 0.004 * random.normal()});
  }
  return cloud;
}

TilePointCloud
stepsCloud()
{
  constexpr int side = 160;
  constexpr double spacing = 0.01, step = 0.04;
  Random random(12);
  TilePointCloud cloud;
  for (int i = 0; i < side; ++i)
    for (int j = 0; j < side; ++j) {
      const double x = spacing * (i + random(-0.3, 0.3));
      const double y = spacing * (j + random(-0.3, 0.3));
      const double height = -std::abs(x - 0.5 * spacing * side);
      cloud.push_back({x, y, step * std::round(height / step)});
    }
  return cloud;
}

TilePointCloud
widerStepsCloud()
{
  Random random(14);
  TilePointCloud cloud;
  addCornerOfKinect(3.5, 0, random, cloud);
  return cloud;
}

TilePointCloud
nearAndFarCloud()
{
  Random random(16);
  TilePointCloud cloud;
  addCornerOfKinect(1.1, -2 * half_corner, random, cloud);
  addCornerOfKinect(3.5, 0, random, cloud);
  addCornerOfKinect(3.5, 2 * half_corner, random, cloud);
  return cloud;
}

TilePointCloud
plateCloud()
{
  constexpr double length = 0.3, width = 0.2, thickness = 0.009;
  std::vector<Patch> patches{{{0, 0, 0}, {length, 0, 0}, {0, width, 0}}};
  addBox({0, 0, 0}, {length, width, thickness}, patches);
  constexpr std::size_t points = 24000; // 2.3 mm apart
  return sampled(patches, points, 0.0003);
}

TilePointCloud
wavyTableCloud()
{
  constexpr double length = 1.2, width = 0.4, spacing = 0.0025, turn = 6.2831853;
  Random random(13);
  struct Wave {
    double along_x, along_y, phase;
  };
  std::array<Wave, 16> waves{};
  for (Wave& wave : waves) {
    const double direction = random(0.0, turn), number = turn / random(0.045, 0.07);
    wave = {
        number * std::cos(direction), number * std::sin(direction), random(0.0, turn)};
  }
  const double height = 0.002 * std::sqrt(2.0 / static_cast<double>(waves.size()));
  TilePointCloud cloud;
  for (double u = 0.0; u < length; u += spacing)
    for (double v = 0.0; v < width; v += spacing) {
      const double x = u + spacing * random(-0.3, 0.3);
      const double y = v + spacing * random(-0.3, 0.3);
      double sum = 0.0;
      for (const Wave& wave : waves)
        sum += std::sin(wave.along_x * x + wave.along_y * y + wave.phase);
      cloud.push_back({x, y, 1.0 + height * sum + 0.0003 * random.normal()});
    }
  return cloud;
}

TilePointCloud
withTrouble(TilePointCloud points)
{
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  Random random(10);
  const std::size_t size = points.size();
  for (int i = 0; i < 8; ++i)
    points.push_back({random(-50, 90), random(-60, 60), random(-30, 40)});
  for (std::size_t i = 0; i < size / 50; ++i) {
    const TilePoint copy = points[random.below(static_cast<std::uint32_t>(size))];
    points.push_back(copy);
  }
  for (std::size_t i = 0; i < size / 200; ++i)
    points.push_back({nan, 1.0, 2.0});
  points.push_back({1.0, std::numeric_limits<double>::infinity(), 2.0});
  points.push_back({1.0, 2.0, 1e300}); // finite, but not as float
  return points;
}

std::vector<std::size_t>
shuffled(std::size_t size, unsigned seed)
{
  std::vector<std::size_t> order(size);
  std::iota(order.begin(), order.end(), std::size_t{0});
  Random random(seed);
  for (std::size_t i = size; i > 1; --i)
    std::swap(order[i - 1], order[random.below(static_cast<std::uint32_t>(i))]);
  return order;
}

std::string
tileCloudFile(const TilePointCloud& points,
              const std::vector<std::size_t>& order,
              bool is_double)
{
  const std::string size = is_double ? "8" : "4", count = std::to_string(order.size());
  std::string file = "VERSION 0.7\nFIELDS x y z id\nSIZE " + size + ' ' + size + ' ' +
                     size + " 4\nTYPE F F F U\nCOUNT 1 1 1 1\nWIDTH " + count +
                     "\nHEIGHT 1\nVIEWPOINT 3 2 1.5 1 0 0 0\nPOINTS " + count +
                     "\nDATA binary\n";
  const auto put = [&](auto value) {
    file.append(reinterpret_cast<const char*>(&value), sizeof value);
  };
  for (const std::size_t i : order) {
    for (const double coordinate : points[i])
      if (is_double)
        put(coordinate);
      else
        put(static_cast<float>(coordinate));
    put(static_cast<std::uint32_t>(i));
  }
  return file;
}

} // namespace pcl_shape_test
