// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// What stereo, time-of-flight and structured-light depth cameras measure of a scene.

#pragma once

#include "scene/random.h"
#include "scene/scene.h"
#include "scene/world.h"

namespace pcl::scene {

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

/** \brief An image of one of Noise::Stereo, TimeOfFlight and Structured.
 *
 * No camera was measured for the numbers: they are choices of the usual order.
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
