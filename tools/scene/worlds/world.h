// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Solids, a table and a camera, and what rays and the camera meet.

#pragma once

#include "scene/scene.h"
#include "scene/vec.h"

#include <algorithm>
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

/** \brief The visible part of the plane z = 0, facing +z: a rectangle without edges of
 * its own, as a table whose surroundings were cut away. */
struct Table {
  Vec3 center;
  Vec3 along{1, 0, 0};                          /**< unit, in the plane */
  Vec3 across{0, 1, 0};                         /**< unit, in the plane */
  double half_length = -1.0, half_width = -1.0; /**< negative: there is none */

  bool contains(const Vec3& p) const;
};

/** \brief Camera frame: x right, y down, z forward. */
struct Camera {
  unsigned width = 0, height = 0;
  double focal = 0.0; /**< pixels */
  Pose pose;

  /** \brief Camera-frame direction through a pixel's center, with z = 1. Pixels are
   * counted row by row. */
  Vec3
  direction(std::size_t pixel) const
  {
    const auto u = static_cast<double>(pixel % width);
    const auto v = static_cast<double>(pixel / width);
    return {(u - 0.5 * (width - 1.0)) / focal, (v - 0.5 * (height - 1.0)) / focal, 1.0};
  }
};

/** \brief Table, objects and camera in a frame with z up and the table at z = 0. */
struct World {
  Table table;
  std::vector<Solid> solids;
  Camera camera;
};

constexpr int nothing = -1;
constexpr int table_index = 0; /**< solids are 1 and up */

/** \brief What is seen in a pixel. Points and normals in the world's frame. */
struct Sight {
  int object = nothing; /**< nothing, table_index, or 1 + index of a solid */
  int face = 0;
  double depth = 0.0; /**< z in the camera's frame */
  Vec3 point;
  Vec3 normal; /**< unit, outwards */
};

/** \brief One Sight a pixel, row by row. */
struct View {
  unsigned width = 0, height = 0;
  std::vector<Sight> sights;
};

/** \brief depthOf(pixel, sight) of each pixel, all asked in turn; NaN where nothing is
 * seen. */
template <typename DepthOf>
std::vector<double>
depthsOf(const View& view, const DepthOf& depthOf)
{
  std::vector<double> depths;
  depths.reserve(view.sights.size());
  for (std::size_t i = 0; i < view.sights.size(); ++i) {
    const double depth = depthOf(i, view.sights[i]);
    depths.push_back(view.sights[i].object == nothing
                         ? std::numeric_limits<double>::quiet_NaN()
                         : depth);
  }
  return depths;
}

/** \brief visit(pixel, squared distance in pixels) for those in a square around one.
 * \param[in] reach half the square's side, pixels */
template <typename Visit>
void
forEachAround(
    std::size_t pixel, unsigned width, unsigned height, int reach, const Visit& visit)
{
  const int w = static_cast<int>(width), h = static_cast<int>(height);
  const int u = static_cast<int>(pixel) % w, v = static_cast<int>(pixel) / w;
  for (int y = std::max(0, v - reach); y <= std::min(h - 1, v + reach); ++y)
    for (int x = std::max(0, u - reach); x <= std::min(w - 1, u + reach); ++x)
      visit(static_cast<std::size_t>(y * w + x), (x - u) * (x - u) + (y - v) * (y - v));
}

/** \brief What has to see a point for it to be measured. */
struct Observer {
  std::vector<Vec3> eyes;  /**< positions outside all solids */
  double min_cosine = 0.0; /**< of the angle of incidence */
};

/** \brief Casts rays at everything in a world. */
class RayCaster {
public:
  explicit RayCaster(const World& world);

  /** \brief The first thing that a ray meets; depth is in lengths of the direction. */
  Sight cast(const Ray& ray) const;

  /** \brief True if every eye of an observer sees a point on a surface: it faces them,
   * and no solid is between. */
  bool seen(const Observer& observer, const Vec3& point, const Vec3& normal) const;

private:
  bool mayHit(std::size_t solid, const Ray& ray) const;

  const World& world_;
  std::vector<Sphere> bounds_;
};

/** \brief What the world's camera sees. */
View look(const World& world);

/** \brief True where a face of an object of the world is round. */
bool isCurved(const World& world, const Sight& sight);

} // namespace pcl::scene
