// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// The ground of a street: a road between curbs that rises, bends and undulates.

#pragma once

#include "scene/random.h"
#include "scene/worlds/world.h"

#include <array>
#include <optional>
#include <vector>

namespace pcl::scene {

/** \brief The kinds of ground that a curb separates. */
enum class GroundZone { Road, LeftWalk, RightWalk };

/** \brief Where the ground beside a road is higher or lower than the pavement. */
struct SideKnot {
  double across = 0.0; /**< from the edge of the road */
  double rise = 0.0;   /**< linear in between, and from the last two on */
};

/** \brief A part of a street that is higher or lower than the pavement. */
struct Driveway {
  double begin = 0.0, end = 0.0; /**< s */
  double side = 1.0;             /**< 1 left, -1 right */
  double slope = 0.0;            /**< away from the road */
  double length = 0.0;           /**< until it is level again */
};

/** \brief A bump across the road. */
struct SpeedBump {
  double s = 0.0, height = 0.0, half_length = 0.0;
};

/** \brief The shape of a street. Lengths in meters; s runs along it, t to its left, and
 * the vehicle is at s = 0. */
struct StreetProfile {
  UnitVector heading;        /**< of the vehicle in the street */
  double lane = 0.0;         /**< t of the vehicle */
  double height = 1.73;      /**< of the sensor above the road */
  double half_width = 4.0;   /**< of the road */
  double curb = 0.12;        /**< its height */
  double grade = 0.0;        /**< rise per meter along s, in the sensor's frame */
  double tilt = 0.0;         /**< likewise along t */
  double curvature = 0.0;    /**< of the road's profile, 1 / m */
  double crown = 0.02;       /**< fall from the middle to the curb, per meter */
  double wave = 0.0;         /**< amplitude of its undulation */
  double wave_length = 30.0; /**< of the undulation */
  double wave_phase = 0.0;   /**< in turns */
  double grass = 0.0;        /**< height, beyond a meter from the road */
  double low_level = 1e9;    /**< t beyond which the ground is of another level */
  std::array<std::vector<SideKnot>, 2> sides; /**< right, left */
  std::vector<Driveway> driveways;
  std::vector<SpeedBump> bumps;
};

struct StreetPoint {
  double s = 0.0, t = 0.0;
};

/** \brief Where a ray meets the ground. */
struct GroundHit {
  double distance = 0.0;  /**< in lengths of the direction */
  bool curb_face = false; /**< or ground of another level */
  Vec3 normal;            /**< unit */
};

/** \brief Road and, behind a curb on either side, pavement and yards, as a height above
 * the plane z = 0 of the sensor's frame: x forward, y left, z up, the sensor at 0. */
class StreetGround {
public:
  explicit StreetGround(const StreetProfile& profile);

  const StreetProfile profile;

  StreetPoint toStreet(double x, double y) const;

  Vec3 toSensor(const StreetPoint& p, double z) const;

  GroundZone zone(const StreetPoint& p) const;

  double height(const StreetPoint& p, GroundZone zone) const;

  double
  height(const StreetPoint& p) const
  {
    return height(p, zone(p));
  }

  /** \brief The frame of something that stands here: x along the street, z off the
   * ground. */
  Pose standing(const StreetPoint& p) const;

  /** \brief The first place where a ray meets it.
   * \param[in] ray from above it; the direction is unit \param[in] reach meters
   * \param[in] tuft where in the grass, 0 on the soil, 1 at the tips */
  std::optional<GroundHit> cast(const Ray& ray, double reach, double tuft = 0.0) const;

private:
  double side(const StreetPoint& p, GroundZone zone) const;

  Vec3 normal(const StreetPoint& p, GroundZone zone) const;

  double base_ = 0.0;
};

} // namespace pcl::scene
