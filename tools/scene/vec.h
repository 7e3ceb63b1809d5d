// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Points and directions, and frames of them, with operations that are exact everywhere.

#pragma once

#include <array>
#include <cmath>
#include <vector>

namespace pcl::scene {

/** \brief A point or a direction, in meters. Only operations that IEEE 754 rounds
 * exactly (+ - * / sqrt) are used here, so that results are the same everywhere. */
struct Vec3 {
  double x = 0.0, y = 0.0, z = 0.0;
};

inline Vec3
operator+(const Vec3& a, const Vec3& b)
{
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}

inline Vec3
operator-(const Vec3& a, const Vec3& b)
{
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}

inline Vec3
operator-(const Vec3& a)
{
  return {-a.x, -a.y, -a.z};
}

inline Vec3
operator*(const Vec3& a, double s)
{
  return {a.x * s, a.y * s, a.z * s};
}

inline double
dot(const Vec3& a, const Vec3& b)
{
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

inline Vec3
cross(const Vec3& a, const Vec3& b)
{
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

inline double
squaredNorm(const Vec3& a)
{
  return dot(a, a);
}

inline double
norm(const Vec3& a)
{
  return std::sqrt(squaredNorm(a));
}

inline Vec3
normalized(const Vec3& a)
{
  return a * (1.0 / norm(a));
}

/** \brief Two unit vectors at right angles to a unit vector and to each other. */
inline std::array<Vec3, 2>
perpendiculars(const Vec3& a)
{
  const Vec3 aside = std::abs(a.x) < 0.5 ? Vec3{1, 0, 0} : Vec3{0, 1, 0};
  const Vec3 first = normalized(cross(a, aside));
  return {first, cross(a, first)};
}

/** \brief A level direction turned by 90 degrees to the left, seen from above. */
inline Vec3
leftOf(const Vec3& a)
{
  return {-a.y, a.x, 0.0};
}

inline void
append(const Vec3& a, std::vector<float>& values)
{
  for (const double value : {a.x, a.y, a.z})
    values.push_back(static_cast<float>(value));
}

/** \brief A right-handed orthonormal frame. */
struct Pose {
  std::array<Vec3, 3> axes{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  Vec3 origin;

  Vec3
  directionToLocal(const Vec3& d) const
  {
    return {dot(d, axes[0]), dot(d, axes[1]), dot(d, axes[2])};
  }

  Vec3
  toLocal(const Vec3& p) const
  {
    return directionToLocal(p - origin);
  }

  Vec3
  directionToWorld(const Vec3& d) const
  {
    return axes[0] * d.x + axes[1] * d.y + axes[2] * d.z;
  }

  Vec3
  toWorld(const Vec3& p) const
  {
    return origin + directionToWorld(p);
  }
};

} // namespace pcl::scene
