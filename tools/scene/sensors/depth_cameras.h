// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// What a Kinect and stereo, time-of-flight and structured-light cameras measure of a
// scene.

#pragma once

#include "scene/random.h"
#include "scene/scene.h"
#include "scene/worlds/world.h"

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

/** \brief An image with the noise of a sensor. */
struct DepthImage {
  View view; /**< beside silhouettes a pixel may see what its neighbor sees exactly */
  std::vector<double> depth; /**< z in meters a pixel, or NaN */
};

/** \brief The waviness of a camera: as asked for, or random from the seed, .5 to 3 mm
 * over 10 to 60 mm. A structured-light camera has none of its own. */
Waviness wavinessOf(const SceneOptions& options);

/** \brief The positions that have to see a point for it to be measured. */
Observer depthObserver(Noise camera, const World& world);

/** \brief An image of one of Noise::Kinect, Stereo, TimeOfFlight and Structured.
 *
 * Kinect: its disparity is d = focal * baseline / z. One eighth of a pixel of it is the
 * step of the output, 2.87 mm z^2 (z in meters); see Khoshelham and Elberink, Sensors
 * 12(2), 2012. Outlines are ragged; depths are whole millimeters.
 *
 * No other camera was measured for the numbers: they are choices of the usual order.
 *
 * Stereo: 5 cm of baseline, as Intel's D435 has, and windows of 7 pixels (of a picture
 * 640 wide). Disparities are off by .05 pixels, as on good texture, the same within a
 * window, and come in steps of 1/32 pixel; depths are whole millimeters. Where a window
 * sees an outline it takes the depth of what is in front: objects are up to half a
 * window too wide.
 *
 * Time of flight: 1.5 mm (one sigma) at 1 m in each pixel, growing with the square of
 * the depth as the light returned gets less. Beside outlines a pixel gets light from
 * both surfaces and flies between them.
 *
 * Structured light: .1 mm at .6 m, and a ripple of .1 mm every quarter of a fringe of
 * 32 pixels, which is what a projector that is not quite linear leaves of four phase
 * steps. The projector is 10 cm beside the camera; outlines are lost.
 *
 * Stereo and time of flight add the waviness, whose lengths count at the middle depth.
 */
DepthImage depthImage(const World& world,
                      const View& exact,
                      Noise camera,
                      const Waviness& waviness,
                      Random& random);

} // namespace pcl::scene
