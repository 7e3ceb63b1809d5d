// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Faces as a whole, where they meet, and whether they are one body there.

#pragma once

#include "geometry/point_grid.h"
#include "instances/instance_detection.h"
#include "instances/instance_points.h"

#include <cstdint>
#include <vector>

namespace pcl::segmentation {

constexpr double planar_threshold = 0.5; // likelihood: more likely planar than not

/** \brief What is known about a face as a whole. */
struct Face {
  double area = 0.0;   ///< sum of the squared spacings, in squares of the median one
  double planar = 0.0; ///< mean likelihood
  std::size_t points = 0;
  ShapePrimitive surface; ///< about origin; None if no primitive describes it
  Eigen::Vector3f origin = Eigen::Vector3f::Zero();
};

std::vector<Face> facesOf(const detail::InstanceInput& input, const Labels& labels);

/** \brief How two faces meet: lengths of their common border in spacings. */
struct FaceContact {
  std::int32_t first = 0;  ///< label of a face
  std::int32_t second = 0; ///< a larger one
  float convex = 0.0f;     ///< length where they are one body
  float concave = 0.0f;    ///< length where one stands on or before the other
};

/** \brief Where faces meet, and whether the border is convex (after Stein et al.,
 * "Object Partitioning using Local Convexity", 2014).
 * \param[in] faces label of each point of a face's inside
 * \param[in] grown the same with the points between the faces shared out
 * \return one entry a pair of faces, sorted by their labels */
std::vector<FaceContact> faceContacts(const detail::InstanceInput& input,
                                      const PointGrid& grid,
                                      const Labels& faces,
                                      const std::vector<Face>& properties,
                                      const Labels& grown);

} // namespace pcl::segmentation
