// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Objects of random size and pose, and the data to place them without collisions.

#pragma once

#include "scene/random.h"
#include "scene/vec.h"
#include "scene/worlds/footprint.h"
#include "scene/worlds/world.h"

#include <vector>

namespace pcl::scene {

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
