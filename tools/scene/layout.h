// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Puts objects on a table: alone, on, against or in each other, without overlap.

#pragma once

#include "scene/body.h"

namespace pcl::scene {

/** \brief The ground, z = 0, where objects' centers may be: ahead (+y) of a camera at
 * x = y = 0, in its field of view. Meters. */
struct Ground {
  double near = 0.42, far = 0.92; /**< y */
  double spread = 0.4;            /**< |x| <= spread * y */
  double half_width = 0.34;       /**< |x| <= half_width */
};

/** \brief Put `count` objects on the ground, one after the other. Where it is too small
 * for them they become smaller.
 * \param[in] kinds in turn; none: all, so that at least 30 % of the objects touch
 * another one (if there are two or more) */
std::vector<Body> randomLayout(const Ground& ground,
                               unsigned count,
                               const std::vector<Shape>& kinds,
                               Random& random);

} // namespace pcl::scene
