// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Faces as a whole: how large they are, whether planar, and their primitives.

#pragma once

#include "instances/instance_detection.h"
#include "instances/instance_points.h"

#include <cmath>
#include <vector>

namespace pcl::segmentation {

constexpr double planar_threshold = 0.5; // likelihood: more likely planar than not

// In spacings: what is thinner is no body of its own, nor the side of one.
constexpr float narrow = 8.0f;

/** \brief What is known about a face as a whole. */
struct Face {
  double area = 0.0;   ///< sum of the squared spacings, in squares of the median one
  double planar = 0.0; ///< mean likelihood
  double length = 0.0; ///< along its longest axis, in median spacings
  std::size_t points = 0;
  ShapePrimitive surface; ///< about origin; None if no primitive describes it
  Eigen::Vector3f origin = Eigen::Vector3f::Zero();

  /** \brief The root of its area. */
  float
  width() const
  {
    return static_cast<float>(std::sqrt(area));
  }

  /** \brief Of a strip; of other shapes the width. */
  float
  thickness() const
  {
    return length > std::sqrt(area) ? static_cast<float>(area / length) : width();
  }
};

std::vector<Face> facesOf(const detail::InstanceInput& input, const Labels& labels);

} // namespace pcl::segmentation
