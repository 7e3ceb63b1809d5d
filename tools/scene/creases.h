// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// The lines of a scene where surfaces meet and a camera sees both.

#pragma once

#include "scene/curve.h"
#include "scene/worlds/world.h"

#include <vector>

namespace pcl::scene {

/** \brief The creases that a camera can see.
 *
 * A crease is a line where two faces meet: an edge or a rim of an object, whether the
 * second face is the object's own, another object's or the table. It counts where the
 * camera sees two of its faces beside the line; where only one is seen the line is a
 * silhouette. Round objects that touch along a line (a cylinder on its side, say) do so
 * at an angle of zero, where the faces beside the line always hide it: they make no
 * crease. The rim of an upright bowl is too thin to be a crease (see thinPlaces). */
class Creases {
public:
  Creases(const World& world, const Observer& observer);

  /** \brief Those of which each face is seen by one of the observers.
   * \param[in] step meters between the places where visibility is looked up */
  Creases(const World& world, const std::vector<Observer>& observers, double step);

  /** \brief Distance from a point to the nearest crease, at most `cap`, in meters. */
  double distance(const Vec3& point, double cap) const;

  /** \brief The visible parts, straight and circular. */
  const std::vector<Curve>&
  parts() const
  {
    return parts_;
  }

private:
  std::vector<Curve> parts_;
  std::vector<Sphere> bounds_;
};

/** \brief Edges and rims of a solid, visible or not. */
std::vector<Curve> edges(const Solid& solid);

/** \brief Lines and points of an object where a smooth surface ends without a crease: a
 * bowl's rim, a cone's apex (a curve of no length), the seams of a part. */
std::vector<Curve> thinPlaces(const Solid& solid);

/** \brief The thin places of all objects of a world. */
class ThinPlaces {
public:
  explicit ThinPlaces(const World& world);

  /** \brief True if one of the object's own is nearer than a distance in meters. */
  bool areNear(const Sight& sight, double distance) const;

private:
  std::vector<std::vector<Curve>> places_;
};

} // namespace pcl::scene
