/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * Point Cloud Library (PCL) - www.pointclouds.org
 * Copyright (c) 2026, pcl_shape contributors
 *
 * All rights reserved
 */

#include "solid.h"

#include <algorithm>
#include <cmath>

namespace pcl::scene {
namespace {

double
lengthXY(const Vec3& p)
{
  return std::sqrt(p.x * p.x + p.y * p.y);
}

bool
within(double value, double low, double high, double tolerance)
{
  return value >= low - tolerance && value <= high + tolerance;
}

std::vector<FaceAt>
boxFacesAt(const Solid& box, const Vec3& p, double tolerance)
{
  const std::array<double, 3> position{p.x, p.y, p.z};
  std::array<bool, 3> inside{};
  for (std::size_t i = 0; i < 3; ++i)
    inside[i] = std::abs(position[i]) <= 0.5 * box.size[i] + tolerance;
  std::vector<FaceAt> faces;
  for (std::size_t i = 0; i < 3; ++i)
    for (const int side : {-1, 1}) {
      const bool on_plane =
          std::abs(side * position[i] - 0.5 * box.size[i]) <= tolerance;
      if (on_plane && inside[(i + 1) % 3] && inside[(i + 2) % 3])
        faces.push_back(
            {static_cast<int>(2 * i) + (side > 0), box.pose.axes[i] * side});
    }
  return faces;
}

std::vector<FaceAt>
cylinderFacesAt(const Solid& cylinder, const Vec3& p, double tolerance)
{
  const double radius = cylinder.size[0], height = cylinder.size[1];
  const double rho = lengthXY(p);
  const Vec3& axis = cylinder.pose.axes[2];
  std::vector<FaceAt> faces;
  if (std::abs(rho - radius) <= tolerance && within(p.z, 0.0, height, tolerance))
    faces.push_back(
        {SideFace, cylinder.pose.directionToWorld({p.x / rho, p.y / rho, 0.0})});
  if (std::abs(p.z) <= tolerance && rho <= radius + tolerance)
    faces.push_back({BaseFace, -axis});
  if (std::abs(p.z - height) <= tolerance && rho <= radius + tolerance)
    faces.push_back({TopFace, axis});
  return faces;
}

std::vector<FaceAt>
coneFacesAt(const Solid& cone, const Vec3& p, double tolerance)
{
  const double radius = cone.size[0], height = cone.size[1];
  const double rho = lengthXY(p);
  const double slant = std::sqrt(radius * radius + height * height);
  const double distance = (rho * height - radius * (height - p.z)) / slant;
  std::vector<FaceAt> faces;
  if (std::abs(distance) <= tolerance && rho > 0.0 &&
      within(p.z, 0.0, height, tolerance)) {
    const double outward = height / slant / rho;
    faces.push_back(
        {SideFace,
         cone.pose.directionToWorld({p.x * outward, p.y * outward, radius / slant})});
  }
  if (std::abs(p.z) <= tolerance && rho <= radius + tolerance)
    faces.push_back({BaseFace, -cone.pose.axes[2]});
  return faces;
}

std::vector<FaceAt>
bowlFacesAt(const Solid& bowl, const Vec3& p, double tolerance)
{
  const double radius = bowl.size[0], height = bowl.size[1], wall = bowl.size[2];
  const Vec3 from_centre = p - Vec3{0.0, 0.0, radius};
  const double distance = norm(from_centre);
  const Vec3 outward = bowl.pose.directionToWorld(from_centre * (1.0 / distance));
  std::vector<FaceAt> faces;
  if (p.z <= height + tolerance) {
    if (std::abs(distance - radius) <= tolerance)
      faces.push_back({BowlOutside, outward});
    if (std::abs(distance - (radius - wall)) <= tolerance)
      faces.push_back({BowlInside, -outward});
  }
  const BowlOpening opening = bowlOpening(bowl);
  if (std::abs(p.z - height) <= tolerance &&
      within(lengthXY(p), opening.inner, opening.outer, tolerance))
    faces.push_back({BowlRim, bowl.pose.axes[2]});
  return faces;
}

} // namespace

const char*
name(Shape shape)
{
  switch (shape) {
  case Shape::Box:
    return "box";
  case Shape::Cylinder:
    return "cylinder";
  case Shape::Sphere:
    return "sphere";
  case Shape::Bowl:
    return "bowl";
  case Shape::Cone:
    return "cone";
  }
  return "";
}

BowlOpening
bowlOpening(const Solid& bowl)
{
  const double radius = bowl.size[0], height = bowl.size[1], wall = bowl.size[2];
  const double up = height - radius;
  const auto atHeight = [up](double r) { return std::sqrt(r * r - up * up); };
  return {atHeight(radius - wall), atHeight(radius)};
}

Sphere
boundingSphere(const Solid& solid)
{
  const auto [a, b, c] = solid.size;
  const Vec3& up = solid.pose.axes[2];
  switch (solid.shape) {
  case Shape::Box:
    return {solid.pose.origin, 0.5 * std::sqrt(a * a + b * b + c * c)};
  case Shape::Cylinder:
  case Shape::Cone:
    return {solid.pose.origin + up * (0.5 * b), std::sqrt(a * a + 0.25 * b * b)};
  case Shape::Sphere:
    return {solid.pose.origin, a};
  case Shape::Bowl:
    return {solid.pose.origin + up * a, a};
  }
  return {};
}

std::vector<FaceAt>
facesAt(const Solid& solid, const Vec3& point, double tolerance)
{
  const Vec3 local = solid.pose.toLocal(point);
  switch (solid.shape) {
  case Shape::Box:
    return boxFacesAt(solid, local, tolerance);
  case Shape::Cylinder:
    return cylinderFacesAt(solid, local, tolerance);
  case Shape::Cone:
    return coneFacesAt(solid, local, tolerance);
  case Shape::Bowl:
    return bowlFacesAt(solid, local, tolerance);
  case Shape::Sphere: {
    const double distance = norm(local);
    if (std::abs(distance - solid.size[0]) > tolerance)
      return {};
    return {{SideFace, solid.pose.directionToWorld(local * (1.0 / distance))}};
  }
  }
  return {};
}

bool
isCurved(Shape shape, int face)
{
  switch (shape) {
  case Shape::Box:
    return false;
  case Shape::Sphere:
    return true;
  case Shape::Cylinder:
  case Shape::Cone:
    return face == SideFace;
  case Shape::Bowl:
    return face != BowlRim;
  }
  return false;
}

} // namespace pcl::scene
