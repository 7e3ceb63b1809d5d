// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// A laser scan ring by ring, with ground, walls and cars.

#include "clouds.h"

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double ground = -1.8; // the scanner is at the origin

struct House {
  Eigen::Array3d least, most; ///< or a car: a box along the axes
};

struct Trunk {
  double x, y, radius;
};

struct Street {
  std::vector<House> boxes;
  std::vector<Trunk> trunks;
};

Street
randomStreet(std::mt19937& random)
{
  const auto between = [&](double least, double most) {
    return std::uniform_real_distribution<double>(least, most)(random);
  };
  Street street;
  for (double x = -90.0; x < 90.0; x += between(12.0, 18.0)) {
    for (const double side : {-1.0, 1.0}) {
      const double front = side * between(9.0, 12.0), back = side * 22.0;
      street.boxes.push_back(
          {{x, std::min(front, back), ground},
           {x + between(8.0, 12.0), std::max(front, back), between(4.0, 12.0)}});
      const double y = side * between(4.0, 5.0);
      street.boxes.push_back(
          {{x + 2.0, y - 0.9, ground + 0.3}, {x + 6.2, y + 0.9, ground + 1.5}});
      street.trunks.push_back({x + between(7.0, 9.0), side * 7.0, between(0.1, 0.3)});
    }
  }
  return street;
}

/** \brief How far along a ray from the origin a box begins; infinity if it is missed.
 */
double
rangeOf(const House& box, const Eigen::Array3d& ray)
{
  const Eigen::Array3d a = box.least / ray, b = box.most / ray;
  const double enter = a.min(b).maxCoeff(), leave = a.max(b).minCoeff();
  return enter > 0.0 && enter < leave ? enter : infinity;
}

double
rangeOf(const Trunk& trunk, const Eigen::Array3d& ray)
{
  const double a = ray.x() * ray.x() + ray.y() * ray.y();
  const double b = ray.x() * trunk.x + ray.y() * trunk.y;
  const double c = trunk.x * trunk.x + trunk.y * trunk.y - trunk.radius * trunk.radius;
  const double under = b * b - a * c;
  return under > 0.0 && b > 0.0 ? (b - std::sqrt(under)) / a : infinity;
}

double
rangeIn(const Street& street, const Eigen::Array3d& ray)
{
  double range = ray.z() < 0.0 ? ground / ray.z() : infinity;
  for (const House& box : street.boxes)
    range = std::min(range, rangeOf(box, ray));
  for (const Trunk& trunk : street.trunks)
    range = std::min(range, rangeOf(trunk, ray));
  return range;
}

} // namespace

Cloud::Ptr
laserCloud()
{
  constexpr int rings = 64, steps = 3600;
  constexpr double lowest = -25.0, highest = 3.0; // degrees
  constexpr double noise = 0.01, furthest = 100.0;
  std::mt19937 random(1);
  const Street street = randomStreet(random);
  std::normal_distribution<double> error(0.0, noise);
  const auto cloud = pcl::make_shared<Cloud>();
  for (int ring = 0; ring < rings; ++ring) {
    const double up = (lowest + (highest - lowest) * ring / (rings - 1)) * M_PI / 180.0;
    for (int step = 0; step < steps; ++step) {
      const double turn = 2.0 * M_PI * (step + 0.5) / steps;
      const Eigen::Array3d ray(
          std::cos(up) * std::cos(turn), std::cos(up) * std::sin(turn), std::sin(up));
      const double range = rangeIn(street, ray);
      if (range < furthest) {
        const Eigen::Array3f p = (ray * (range + error(random))).cast<float>();
        cloud->emplace_back(p.x(), p.y(), p.z());
      }
    }
  }
  return cloud;
}
