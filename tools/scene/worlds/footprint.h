// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// The areas that objects cover when seen from above, and the distances between them.

#pragma once

#include "scene/vec.h"

#include <vector>

namespace pcl::scene {

/** \brief What an object covers when seen from above: a convex polygon in the plane
 * z = 0 (counter-clockwise; one corner is enough for a disc), grown by a radius. */
struct Footprint {
  std::vector<Vec3> corners;
  double radius = 0.0;
};

/** \brief A rectangle around a center; direction is a level unit vector along its
 * length. */
Footprint
rectangle(const Vec3& center, const Vec3& direction, double length, double width);

/** \brief Only in the plane. */
Footprint moved(Footprint footprint, const Vec3& by);

/** \brief Distance between two footprints, 0 or less where they overlap. */
double distance(const Footprint& a, const Footprint& b);

/** \brief How far `mover` has to go along a level unit direction from where it overlaps
 * `other` until they just touch, to 1e-12 m. */
double
slideToContact(const Footprint& mover, const Vec3& direction, const Footprint& other);

} // namespace pcl::scene
