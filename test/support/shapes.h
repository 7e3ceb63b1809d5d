// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Points on exact surfaces with their true normals.

#pragma once

#include "support/random.h"

#include <pcl/features/neighborhood_sweep.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <cmath>
#include <string>
#include <vector>

namespace pcl {
namespace test {

constexpr double pi = 3.14159265358979323846;

struct SurfacePoint {
  Eigen::Vector3d position;
  Eigen::Vector3d normal;
};

/** \brief Points with the true normals of their surface, as the sweep takes them. */
struct Surface {
  std::vector<float> xyz;
  std::vector<float> normals;

  std::size_t
  size() const
  {
    return xyz.size() / 3;
  }

  XYZView
  points() const
  {
    return {xyz.data(), 3, size()};
  }

  XYZView
  trueNormals() const
  {
    return {normals.data(), 3, size()};
  }

  Eigen::Vector3d
  position(std::size_t i) const
  {
    return Eigen::Map<const Eigen::Vector3f>(&xyz[3 * i]).cast<double>();
  }

  Eigen::Vector3d
  normal(std::size_t i) const
  {
    return Eigen::Map<const Eigen::Vector3f>(&normals[3 * i]).cast<double>();
  }

  void
  add(const SurfacePoint& point)
  {
    for (int axis = 0; axis < 3; ++axis) {
      xyz.push_back(static_cast<float>(point.position[axis]));
      normals.push_back(static_cast<float>(point.normal[axis]));
    }
  }

  void
  append(const Surface& other)
  {
    xyz.insert(xyz.end(), other.xyz.begin(), other.xyz.end());
    normals.insert(normals.end(), other.normals.begin(), other.normals.end());
  }

  void
  move(const Eigen::Isometry3d& pose)
  {
    Surface moved;
    for (std::size_t i = 0; i < size(); ++i)
      moved.add({pose * position(i), pose.linear() * normal(i)});
    *this = moved;
  }

  void
  addNoise(double sigma, Random& random)
  {
    for (float& value : xyz)
      value += static_cast<float>(sigma * random.normal());
  }
};

/** \brief `count` samples of a surface: sample(random) gives one. */
template <typename Sample>
Surface
sampled(std::size_t count, Random& random, const Sample& sample)
{
  Surface surface;
  for (std::size_t i = 0; i < count; ++i)
    surface.add(sample(random));
  return surface;
}

inline Surface
plane(std::size_t count, double side, Random& random)
{
  return sampled(count, random, [side](Random& r) {
    const double x = r.uniform(0, side), y = r.uniform(0, side);
    return SurfacePoint{{x, y, 0}, {0, 0, 1}};
  });
}

inline Surface
sphere(std::size_t count, double radius, Random& random)
{
  return sampled(count, random, [radius](Random& r) {
    const double z = r.uniform(-1, 1), turn = r.uniform(0, 2 * pi);
    const double across = std::sqrt(1 - z * z);
    const Eigen::Vector3d n(across * std::cos(turn), across * std::sin(turn), z);
    return SurfacePoint{radius * n, n};
  });
}

/** \brief Around the z axis, z in [0, height]. */
inline Surface
cylinder(std::size_t count, double radius, double height, Random& random)
{
  return sampled(count, random, [=](Random& r) {
    const double turn = r.uniform(0, 2 * pi), z = r.uniform(0, height);
    const Eigen::Vector3d n(std::cos(turn), std::sin(turn), 0);
    return SurfacePoint{radius * n + Eigen::Vector3d(0, 0, z), n};
  });
}

/** \brief Two half planes with this angle between them that meet in the x axis. */
inline Surface
dihedral(std::size_t count, double degrees, double side, Random& random)
{
  const double angle = degrees * pi / 180;
  return sampled(count, random, [=](Random& r) {
    const double x = r.uniform(0, side), away = r.uniform(0, side / 2);
    const double turn = r.uniform() < 0.5 ? 0 : angle;
    return SurfacePoint{{x, away * std::cos(turn), away * std::sin(turn)},
                        {0, -std::sin(turn), std::cos(turn)}};
  });
}

/** \brief Apex at the origin, half angle 30 degrees, around the z axis. */
inline Surface
cone(std::size_t count, double height, Random& random)
{
  const double slope = pi / 6;
  return sampled(count, random, [=](Random& r) {
    const double z = height * std::sqrt(r.uniform()), turn = r.uniform(0, 2 * pi);
    const Eigen::Vector3d out(std::cos(turn), std::sin(turn), 0);
    const Eigen::Vector3d up(0, 0, 1);
    return SurfacePoint{z * (up + std::tan(slope) * out),
                        std::cos(slope) * out - std::sin(slope) * up};
  });
}

inline Surface
randomCloud(std::size_t count, double side, Random& random)
{
  return sampled(count, random, [side](Random& r) {
    const double x = r.uniform(0, side), y = r.uniform(0, side);
    return SurfacePoint{{x, y, r.uniform(0, side)}, {0, 0, 1}};
  });
}

/** \brief Regular grid of side x side points on the plane z = 0. */
inline Surface
grid(int side, double spacing)
{
  Surface surface;
  for (int i = 0; i < side * side; ++i)
    surface.add({{i % side * spacing, i / side * spacing, 0}, {0, 0, 1}});
  return surface;
}

/** \brief A pose without any symmetry, in front of a camera. */
inline Eigen::Isometry3d
tiltedPose()
{
  const Eigen::Vector3d axis = Eigen::Vector3d(0.3, 0.5, 0.7).normalized();
  return Eigen::Translation3d(0.1, -0.2, 0.8) * Eigen::AngleAxisd(0.9, axis);
}

/** \brief All kinds of surface at once: two planes at a right angle, a sphere and a
 * cylinder, about as dense as one another. */
inline Surface
mixedScene(std::size_t count, Random& random)
{
  Surface scene = dihedral(count / 3, 90, 0.2, random);
  Surface ball = sphere(count / 3, 0.05, random);
  ball.move(Eigen::Isometry3d(Eigen::Translation3d(0.3, 0, 0)));
  scene.append(ball);
  Surface tube = cylinder(count / 3, 0.04, 0.15, random);
  tube.move(Eigen::Isometry3d(Eigen::Translation3d(0, 0.3, 0)));
  scene.append(tube);
  scene.move(tiltedPose());
  return scene;
}

} // namespace test
} // namespace pcl
