// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Points all over the surfaces of a scene, as a CAD model is sampled.

#pragma once

#include "scene/scene.h"

namespace pcl::scene {

/** \brief What to sample. */
struct SampleOptions {
  std::uint64_t seed = 1;
  unsigned objects = 4;      /**< 0 to 30 */
  std::vector<Shape> shapes; /**< of the objects, in turn; none: all */
  double spacing =
      0.002;          /**< meters, 1 / sqrt(points per square meter), 0.0005 to 0.02 */
  double sigma = 0.0; /**< meters of white noise in each coordinate, 0 to 0.1 */
};

/** \brief Points spread at random over all surfaces of a random table scene, as a CAD
 * model is sampled: no camera, nothing hidden, creases exact.
 *
 * The scene is a list (height 1) in the world's frame, z up. Unlike those of
 * generateScene(), the labels follow the spacing: an edge point is within 2 spacings of
 * a crease, and a point within 4 of one is SurfaceCrease; nothing is left out but rims
 * and apexes (see thinPlaces()). Where surfaces touch there are no points between them.
 *
 * \throws std::invalid_argument that names the parameter, its value and what it must be
 */
Scene sampleScene(const SampleOptions& options);

} // namespace pcl::scene
