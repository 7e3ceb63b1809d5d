// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// PURPOSE

#pragma once

#include "scene/random.h"
#include "scene/world.h"

namespace pcl::scene {

/** \brief A smooth random field over the pixels, mean 0 and variance 1. */
using Field = std::vector<double>;

/** \brief White noise averaged over a box: its correlation falls linearly to 0 at the
 * box's width and height. */
Field boxField(
    unsigned width, unsigned height, int box_width, int box_height, Random& random);

/** \brief Noise that varies over about `cell` pixels (interpolated from a coarse grid).
 */
Field gridField(unsigned width, unsigned height, double cell, Random& random);

/** \brief What a structured-light camera of the Kinect's kind measures.
 *
 * Its disparity is d = focal * baseline / z. One eighth of a pixel of it is the step of
 * the output, 2.87 mm z^2 (z in metres); see Khoshelham and Elberink, Sensors 12(2),
 * 2012. */
class KinectSensor {
public:
  KinectSensor(const World& world, const View& view, Random& random);

  /** \brief What is seen once outlines have become ragged: beside silhouettes a pixel
   * may see what its neighbor sees exactly. */
  const View&
  view() const
  {
    return view_;
  }

  /** \brief Depth z in metres a pixel, whole millimetres; NaN where it is missing. */
  const std::vector<double>&
  depth() const
  {
    return depth_;
  }

  /** \brief The view point, the detector and the projector. */
  static Observer observer(const World& world);

private:
  void makeRagged(const World& world, const View& exact, Random& random);

  void measure(const World& world, Random& random);

  void loseDepth(const World& world, Random& random);

  View view_;
  std::vector<double> depth_;
};

} // namespace pcl::scene
