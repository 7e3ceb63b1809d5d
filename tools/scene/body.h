// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Objects of random size and pose, what they cover, and how far apart they are.

#pragma once

#include "scene/random.h"
#include "scene/vec.h"
#include "scene/world.h"

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

/** \brief A solid with what is needed to place it without collision. World frame. */
struct Body {
  Solid solid;
  Footprint footprint;
  Vec3 center;             /**< of the footprint, z = 0 */
  double low = 0.0;        /**< height of its lowest point */
  double high = 0.0;       /**< height of its highest point */
  double widest_low = 0.0; /**< between these heights its section is the footprint */
  double widest_high = 0.0;
  bool carries = false;             /**< has a flat and level top */
  bool open = false;                /**< is a bowl that a ball may lie in */
  std::vector<std::size_t> touches; /**< indices of other bodies */

  bool isTouching(std::size_t other) const;

  Vec3
  topCenter() const
  {
    return {center.x, center.y, high};
  }
};

/** \brief A level unit vector. */
Vec3 randomHeading(Random& random);

/** \brief A body of random size and pose that rests on z = 0 with its footprint around
 * x = y = 0.
 * \param[in] scale of its lengths, 1 for household objects of 5 to 20 cm
 * \param[in] heading level unit vector, the direction of its longer side */
Body randomBody(Shape shape, double scale, const Vec3& heading, Random& random);

/** \brief A thin box with its lower edge on z = 0 that leans on the upper edge of a
 * box.
 *
 * \param[in] support a box that stands on z = 0
 * \param[in] outward unit normal of the upright face of the support that it leans on */
Body randomLeaningBox(const Body& support,
                      const Vec3& outward,
                      double scale,
                      Random& random);

/** \brief A ball that lies on the bottom of an upright bowl. */
Body randomBallInBowl(const Body& bowl, Random& random);

Body moved(Body body, const Vec3& by);

} // namespace pcl::scene
