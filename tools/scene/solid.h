// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// The primitives that scenes are made of, and rays that meet them.

#pragma once

#include "scene/scene.h"
#include "scene/vec.h"

#include <limits>
#include <memory>
#include <vector>

namespace pcl::scene {

class Part;

/** \brief Numbers of the faces of the solids. Those of a box are 0 to 5: -x, +x, -y,
 * +y, -z, +z. */
enum Face : int {
  SideFace = 0, /**< of cylinder, cone and sphere */
  BaseFace = 1, /**< of cylinder and cone */
  TopFace = 2,  /**< of a cylinder */
  BowlOutside = 0,
  BowlInside = 1,
  BowlRim = 2
};

/** \brief A primitive in its place. SceneObject tells what size and pose mean. */
struct Solid {
  Shape shape = Shape::Box;
  std::array<double, 3> size{};
  Pose pose;
  std::shared_ptr<const Part> part = nullptr; /**< of Shape::Part */
};

struct Sphere {
  Vec3 center;
  double radius = 0.0;
};

/** \brief A sphere around the whole solid. */
Sphere boundingSphere(const Solid& solid);

/** \brief A bowl's rim: radii of the inner and the outer circle at its height. */
struct BowlOpening {
  double inner = 0.0, outer = 0.0;
};

BowlOpening bowlOpening(const Solid& bowl);

struct Ray {
  Vec3 origin, direction;
};

/** \brief The first point where a ray enters a solid. */
struct Hit {
  double t =
      std::numeric_limits<double>::infinity(); /**< in lengths of the direction */
  int face = -1;
  Vec3 point;
  Vec3 normal; /**< unit, outwards */

  bool
  found() const
  {
    return t < std::numeric_limits<double>::infinity();
  }
};

/** \brief Exact intersection; the ray must start outside. */
Hit intersect(const Solid& solid, const Ray& ray);

struct FaceAt {
  int face = 0;
  Vec3 normal; /**< unit, outwards */
};

/** \brief The faces that a point lies on, within a tolerance in meters. */
std::vector<FaceAt> facesAt(const Solid& solid, const Vec3& point, double tolerance);

/** \brief True on the round faces, false on the flat ones. */
bool isCurved(const Solid& solid, int face);

} // namespace pcl::scene
