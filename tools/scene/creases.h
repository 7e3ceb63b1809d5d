// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// The lines where surfaces meet and a camera sees both, and the labels beside them.

#pragma once

#include "scene/curve.h"
#include "scene/world.h"

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

constexpr double crease_band = 0.010; /**< meters; nearer than that surface is Crease */
constexpr double edge_band = 0.005;   /**< meters; nearer than that edge is Crease */
constexpr double crease_cap = 0.050;  /**< meters; crease_mm is never larger */
constexpr double silhouette_band = 3.5; /**< pixels of a picture 640 wide, void */

/** \brief Marks pixels whose neighbor belongs to a surface that it does not meet there:
 * one is in front of the other. The rim of the table is none of them. */
std::vector<char> silhouettes(const World& world, const View& view);

/** \brief Marks all pixels within a radius in pixels of a marked one. */
std::vector<char>
dilated(const std::vector<char>& marks, unsigned width, unsigned height, double radius);

/** \brief Adds surface, edge, instance, face and crease_mm of what is seen to a scene.
 *
 * \param[in] beside_gap marks pixels that are void because a silhouette or missing
 * depth is near, unless a crease is near as well */
void label(const World& world,
           const View& view,
           const Creases& creases,
           const std::vector<char>& beside_gap,
           Scene& scene);

} // namespace pcl::scene
