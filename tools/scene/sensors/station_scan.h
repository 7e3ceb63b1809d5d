// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// A laser scanner on a tripod, at one or several places of a room or before a house.

#pragma once

#include "scene/scene.h"

namespace pcl::scene {

struct StationOptions {
  std::uint64_t seed = 1;
  bool is_outdoors = false; /**< before a house front instead of in a room */
  unsigned stations = 1;    /**< 1 to 4 */
  double step = 0.3;        /**< degrees between rays, 0.05 to 2 */
  double sigma = 0.0015; /**< meters along the ray, 0 to 0.1: surveying scanners promise
                            1 to 2 mm up to 10 m */
};

/** \brief A random room or house front, scanned all around from -60 degrees up at each
 * station: the density grows with the square of nearness and with the sine of the
 * incidence, by more than a factor of 30. The scans are one list (height 1) in the
 * frame of the first station, z up.
 *
 * Labels follow the spacing s of the rays where they meet the surface: an edge is
 * within 1.5 s or 5 mm of a crease, void up to 3 s or 10 mm; SurfaceCrease is within 3
 * s or 10 mm. A crease counts if each of its faces is seen from one of the stations.
 * Beside outlines, up to 3 rays, labels are void. An instance is an object; floor,
 * walls and ceiling are 0.
 *
 * \throws std::invalid_argument that names the parameter, its value and what it must be
 */
Scene scanPlace(const StationOptions& options);

} // namespace pcl::scene
