// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// A turn of a laser scanner on a vehicle, with the truth about each point.

#pragma once

#include "scene/worlds/street.h"

#include <cstdint>
#include <vector>

namespace pcl::scene {

/** \brief Values of LidarScan::ground. */
enum GroundTruth : std::uint32_t {
  GroundNot = 0,
  GroundTrue = 1,  /**< road, pavement, yards */
  GroundVoid = 255 /**< the face of a curb */
};

/** \brief How the rays of a turn are arranged. */
enum class LidarPattern {
  Turn,      /**< beams that spin */
  Rosette70, /**< forward only, without repeats: 70 by 77 degrees */
  Rosette120 /**< likewise 120 by 25 degrees */
};

struct LidarOptions {
  std::uint64_t seed = 1;
  unsigned beams = 64;   /**< of a spinning scanner: 16, 32, 64, 128 */
  double sigma = 0.02;   /**< meters along the ray, 0 to 0.1 */
  bool drop_outs = true; /**< returns are lost at random */
  StreetPlace place = StreetPlace::Town;
  LidarPattern pattern = LidarPattern::Turn;
  bool mirrors = false;  /**< some ground is wet and mirrors what stands behind it */
  bool fillers = false;  /**< rays that did not come back are points at 0 */
  double speed = 0.0;    /**< forward, 0 to 60 m/s */
  double yaw_rate = 0.0; /**< to the left, -180 to 180 degrees per second */
};

/** \brief A turn of a spinning laser scanner in a street, without the rays that did not
 * come back, in the order of firing. Frame of the sensor: x forward, y left, z up; of a
 * moving one that of each ray, as drivers hand scans out. */
struct LidarScan {
  std::vector<float> xyz;     /**< measured, meters, 3 per point */
  std::vector<float> normals; /**< exact, 3 per point, towards the sensor */
  std::vector<std::uint32_t> ground;
  std::vector<std::uint32_t> surface;  /**< 1 planar, 2 curved, see Surface */
  std::vector<std::uint32_t> instance; /**< 0 ground, 1 and up objects */
  std::vector<std::uint32_t> ring;     /**< the beam, 0 the lowest */
  std::uint32_t objects = 0;           /**< in the street, seen or not */

  std::size_t
  size() const
  {
    return ground.size();
  }
};

/** \brief Elevations of the beams in degrees, the lowest first. \throws
 * std::invalid_argument unless there are 16, 32, 64 or 128 */
std::vector<double> beamElevations(unsigned beams);

/** \brief Scan a random street.
 *
 * 64 beams: Velodyne HDL-64E, its upper 32 lasers from +2 to -8.33 degrees by a third,
 * its lower 32 from -8.83 to -24.33 by a half, 0.1728 degrees from column to column at
 * 10 turns a second, 120 m. 16 beams: VLP-16, -15 to +15 degrees by 2, 0.2 degrees, 100
 * m. 32 beams: HDL-32E, -30.67 to +10.67 degrees by 4/3, 0.1659 degrees, 100 m. 128
 * beams: OS1-128, -22.5 to +22.5 degrees, 1024 columns, 120 m. Rosettes have 48,000
 * rays and 100 m. All: 2 cm (one sigma), and 50 m on asphalt, which reflects a tenth
 * (HDL-64E data sheet). 1 % of the returns get lost. A scan takes a tenth of a second,
 * in which the vehicle may drive on and turn.
 *
 * The same options give the same labels, and coordinates within 1e-6 m, on any machine.
 * \throws std::invalid_argument that names the parameter, its value and what it must be
 */
LidarScan scanStreet(const LidarOptions& options);

} // namespace pcl::scene
