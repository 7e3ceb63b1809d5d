// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Straight lines and circles in space, or parts of them.

#pragma once

#include "scene/random.h"
#include "scene/vec.h"
#include "scene/worlds/world.h"

namespace pcl::scene {

/** \brief A straight line or a circle, or a part of it from one parameter to another;
 * parameters run from 0 to 1 over the whole. */
class Curve {
public:
  static Curve segment(const Vec3& begin, const Vec3& end);

  /** \param[in] u, v orthogonal unit vectors in its plane */
  static Curve circle(const Vec3& center, const Vec3& u, const Vec3& v, double radius);

  Curve part(double from, double to) const;

  /** \brief The curve of an object with this pose. */
  Curve placed(const Pose& pose) const;

  Vec3 point(double parameter) const;

  /** \brief Unit vector along the curve. */
  Vec3 tangent(double parameter) const;

  /** \brief Of the whole, in meters. */
  double length() const;

  /** \brief The parameter of a point of the part, 0 at its begin and 1 at its end. */
  double
  parameter(double fraction) const
  {
    return from_ + fraction * (to_ - from_);
  }

  /** \brief A sphere around the part. */
  Sphere bounds() const;

  /** \brief Exact distance to the part, in meters. */
  double distance(const Vec3& p) const;

private:
  bool round_ = false;
  double from_ = 0.0, to_ = 1.0;
  Vec3 begin_, end_;    // of a segment
  Vec3 center_, u_, v_; // of a circle
  double radius_ = 0.0;
};

} // namespace pcl::scene
