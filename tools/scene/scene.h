// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// A scene on a table or in a bin as a depth camera sees it, with the truth about each
// pixel.

#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

namespace pcl::scene {

/** \brief Noise of the virtual depth camera. */
enum class Noise {
  None,   /**< exact ray casting, nothing missing but what the rays do not hit */
  White,  /**< independent normal deviates along the ray, same points as None */
  Kinect, /**< correlated, quantized disparity noise and missing depth */
  Stereo, /**< see depth_cameras.h for this and what follows */
  TimeOfFlight,
  Structured
};

/** \brief Noise that is the same nearby: a smooth random field over the picture. */
struct Waviness {
  double sigma = 0.0;   /**< meters, 0 to 0.01 */
  double length = 0.02; /**< meters from one bump to the next, 0.002 to 0.2: points that
                           are half as far apart are .7 correlated, from 1.5 lengths on
                           they are independent */
};

/** \brief Values of Scene::surface. */
enum Surface : std::uint32_t {
  SurfaceVoid = 0,
  SurfacePlanar = 1,
  SurfaceCurved = 2,
  SurfaceCrease = 3 /**< within 10 mm of a crease */
};

/** \brief Values of Scene::edge. */
enum Edge : std::uint32_t {
  EdgeNot = 0,
  EdgeCrease = 1, /**< within 5 mm of a crease */
  EdgeVoid = 255  /**< 5 to 10 mm from a crease, beside a silhouette, on a thin rim */
};

/** \throws std::invalid_argument unless the value is in the range */
void requireRange(
    const char* parameter, double value, double min, double max, const char* unit);

/** \brief The kinds of objects that a scene is made of. */
enum class Shape { Box, Cylinder, Sphere, Bowl, Cone, Part };

/** \brief A lower-case English name, e.g. "box". */
const char* name(Shape shape);

/** \brief What to generate. */
struct SceneOptions {
  std::uint64_t seed = 1;
  unsigned objects = 8;      /**< 0 to 30; many make each other smaller */
  std::vector<Shape> shapes; /**< of the objects, in turn; none: all */
  unsigned width = 640;      /**< pixels, 16 to 4096 */
  unsigned height = 480;     /**< pixels, 16 to 4096 */
  Noise noise = Noise::Kinect;
  double white_sigma = 0.0; /**< meters along the ray, 0 to 0.1; for Noise::White */
  std::optional<Waviness> waviness; /**< of Stereo, TimeOfFlight and Structured; none:
                                       that of the camera, random */
  double turn = 0.0; /**< degrees by which the camera walked around the objects, to its
                        right, -180 to 180: another view of the same scene */
  bool in_bin = false; /**< not on a table but in a bin that stands on a floor, seen
                          from above: of its walls and the floor instance is 0, too */
};

/** \brief An object as it was placed. */
struct SceneObject {
  Shape shape = Shape::Box;
  std::uint32_t instance = 0; /**< its value in Scene::instance, 1 and up */
  /** Box: lengths along its axes. Cylinder, cone: base radius, height, 0. Sphere:
   * radius. Bowl: outer radius, height, wall thickness. Part: 0. In meters. */
  std::array<double, 3> size{};
  /** Rows: the object's axes x, y, z (z is the axis of revolution) in camera frame. */
  std::array<std::array<double, 3>, 3> axes{};
  /** Box, sphere: center. Cylinder, cone: center of the base. Bowl: lowest point of the
   * outside when upright. Part: the origin of its plan. Camera frame, meters. */
  std::array<double, 3> origin{};
  bool touches_table = false;
  std::vector<std::uint32_t>
      touches; /**< instances of the objects it touches, sorted */
};

/** \brief An organized view of a table with objects, and the truth about each pixel.
 *
 * Camera frame: x right, y down, z forward, meters. Pixel (column u, row v) is entry
 * v * width + u. Pixels without depth have NaN coordinates and normals, 0 labels,
 * edge 255 and a NaN crease_mm.
 *
 * A crease is a line where two faces meet (edges and rims, also those that stand on the
 * table or on another object) and where the camera sees both: where it sees one, the
 * line is a silhouette. With Noise::Kinect the projector and the detector must see both
 * as well. A label belongs to the exact point, not to the measured one.
 */
struct Scene {
  unsigned width = 0;
  unsigned height = 0;
  std::vector<float> xyz;     /**< measured, 3 per pixel */
  std::vector<float> normals; /**< exact, 3 per pixel, towards the camera */
  std::vector<std::uint32_t> surface;
  std::vector<std::uint32_t> edge;
  std::vector<std::uint32_t> instance; /**< 0 on the table, 1 and up on objects */
  std::vector<std::uint32_t> face;     /**< its number, 0 and up, on the object */
  std::vector<float>
      crease_mm; /**< from the exact point to the nearest crease, capped */
  std::vector<SceneObject> objects;
  /** The camera in a frame that is the same for every view of a scene: z up, the table
   * at z = 0, meters. Rows: the camera's axes x, y, z. */
  std::array<std::array<double, 3>, 3> camera_axes{};
  std::array<double, 3> camera_origin{};
};

/** \brief Generate a random table scene and look at it with a virtual depth camera.
 *
 * The same options give the same labels, and coordinates within 1e-6 m, on any machine.
 *
 * \throws std::invalid_argument that names the parameter, its value and what it must be
 */
Scene generateScene(const SceneOptions& options);

} // namespace pcl::scene
