// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// PURPOSE

#pragma once

#include <vector>

namespace pcl::scene {

struct Point2 {
  double x = 0.0, y = 0.0;
};

/** \brief What an object covers when seen from above: a convex polygon
 * (counter-clockwise; one corner is enough for a disc), grown by a radius. */
struct Footprint {
  std::vector<Point2> corners;
  double radius = 0.0;
};

Footprint disc(Point2 centre, double radius);

/** \brief A rectangle around a centre; direction is a unit vector along its length. */
Footprint rectangle(Point2 centre, Point2 direction, double length, double width);

Footprint moved(const Footprint& footprint, Point2 by);

/** \brief Distance between two footprints, 0 or less where they overlap. */
double distance(const Footprint& a, const Footprint& b);

/** \brief How far `mover` has to go along a unit direction from where it overlaps
 * `other` until they just touch, to 1e-12 m. */
double slideToContact(const Footprint& mover, Point2 direction, const Footprint& other);

} // namespace pcl::scene
