// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Puts boxes, cylinders, balls and cars on the ground of a street.

#pragma once

#include "scene/street.h"

namespace pcl::scene {

/** \brief Puts things on the ground of a street. */
class StreetBuilder {
public:
  StreetBuilder(Street& street, Random& random) : street_(street), random_(random) {}

  void
  beginObject()
  {
    ++street_.objects;
  }

  /** \brief A ball. \param[in] height of its middle above the ground */
  void
  addBall(const StreetPoint& at, double height, double radius)
  {
    Pose pose = upright(at, 0.0);
    pose.origin.z += height;
    add({Shape::Sphere, {radius, 0.0, 0.0}, pose});
  }

  /** \brief Along the street, above the ground. */
  void
  addSlab(const StreetPoint& at,
          double length,
          double width,
          double bottom,
          double thickness)
  {
    addBox(upright(at, 0.0),
           {0.0, 0.0, bottom + 0.5 * thickness},
           {length, width, thickness});
  }

  /** \param[in] at its middle, in the frame of what it belongs to */
  void
  addBox(const Pose& frame, const Vec3& at, const std::array<double, 3>& size)
  {
    Pose pose = frame;
    pose.origin = frame.toWorld(at);
    add({Shape::Box, size, pose});
  }

  /** \brief Along the street, its foot below a slope. */
  void
  addBlock(
      const StreetPoint& at, double below, double length, double width, double height)
  {
    addBox(upright(at, below),
           {0.0, 0.0, 0.5 * (below + height)},
           {length, width, below + height});
  }

  /** \brief Upright. */
  void
  addCylinder(const Pose& frame, double radius, double height)
  {
    add({Shape::Cylinder, {radius, height, 0.0}, frame});
  }

  /** \brief Lying across. \param[in] at the middle of its nearer end */
  void
  addWheel(const Pose& frame, const Vec3& at, double radius, double width)
  {
    Pose pose;
    pose.axes = {frame.axes[2], frame.axes[0], frame.axes[1]};
    pose.origin = frame.toWorld(at);
    add({Shape::Cylinder, {radius, width, 0.0}, pose});
  }

  /** \brief Where something stands whose foot reaches below a slope. */
  Pose
  upright(const StreetPoint& at, double below) const
  {
    const UnitVector heading = street_.ground.profile.heading;
    Pose pose;
    pose.axes = {Vec3{heading.cosine, -heading.sine, 0.0},
                 Vec3{heading.sine, heading.cosine, 0.0},
                 Vec3{0.0, 0.0, 1.0}};
    pose.origin = street_.ground.toSensor(at, street_.ground.height(at) - below);
    return pose;
  }

  void
  addCar(const StreetPoint& at)
  {
    const double length = random_.uniform(3.8, 4.9), width = random_.uniform(1.7, 1.9);
    const double clearance = random_.uniform(0.15, 0.25);
    const double hood = random_.uniform(0.8, 1.0), roof = random_.uniform(1.4, 1.9);
    const Pose frame = street_.ground.standing(at);
    beginObject();
    addBox(
        frame, {0.0, 0.0, 0.5 * (clearance + hood)}, {length, width, hood - clearance});
    addBox(frame,
           {-0.08 * length, 0.0, 0.5 * (hood + roof)},
           {0.55 * length, 0.88 * width, roof - hood});
    constexpr double wheel = 0.32, wheel_width = 0.2;
    for (const double end : {-0.31, 0.31})
      for (const double side : {-0.5 * width + 0.01, 0.5 * width - 0.01 - wheel_width})
        addWheel(frame, {end * length, side, wheel}, wheel, wheel_width);
  }

private:
  void
  add(const Solid& solid)
  {
    street_.solids.push_back(solid);
    street_.instances.push_back(street_.objects);
  }

  Street& street_;
  Random& random_;
};

} // namespace pcl::scene
