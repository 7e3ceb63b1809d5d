// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// What a depth camera of the Kinect's kind measures of a scene.

#pragma once

#include "scene/random.h"
#include "scene/world.h"

namespace pcl::scene {

/** \brief A smooth random field over the pixels, mean 0 and variance 1. */
using Field = std::vector<double>;

/** \brief White noise averaged over a box: its correlation falls linearly to 0 at the
 * box's width and height. */
Field boxField(std::size_t width,
               std::size_t height,
               std::size_t box_width,
               std::size_t box_height,
               Random& random);

/** \brief Noise that varies over about `cell` pixels, interpolated from a grid. */
Field gridField(unsigned width, unsigned height, double cell, Random& random);

/** \brief What a structured-light camera of the Kinect's kind measures.
 *
 * Its disparity is d = focal * baseline / z. One eighth of a pixel of it is the step of
 * the output, 2.87 mm z^2 (z in meters); see Khoshelham and Elberink, Sensors 12(2),
 * 2012. */
struct KinectSensor {
  KinectSensor(const World& world, const View& exact, Random& random);

  /** \brief The view point, the detector and the projector. */
  static Observer observer(const World& world);

  View view; /**< once outlines have become ragged: beside silhouettes a pixel may see
                what its neighbor sees exactly */
  std::vector<double> depth; /**< z in meters a pixel, whole millimeters; or NaN */
};

} // namespace pcl::scene
