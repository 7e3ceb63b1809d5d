// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Where faces meet, and whether they belong to one body there.

#pragma once

#include "geometry/point_grid.h"
#include "instances/faces/faces.h"
#include "instances/instance_points.h"

#include <cstdint>
#include <vector>

namespace pcl::segmentation {

/** \brief How two faces meet: lengths of their common border in spacings. */
struct FaceContact {
  std::int32_t first = 0;  ///< label of a face
  std::int32_t second = 0; ///< a larger one
  float convex = 0.0f;     ///< length where they belong to one body
  float concave = 0.0f;    ///< length where one stands on or before the other
  /** Length that is not convex, but where neither may stand on the other: as far as is
   * known, no face is level there. None of two planes, which may be walls of two boxes,
   * or of the inside of one. */
  float sloping = 0.0f;
};

/** \brief Where faces meet, and whether the border is convex (after Stein et al.,
 * "Object Partitioning using Local Convexity", 2014).
 * \param[in] faces label of each point of a face's inside
 * \param[in] grown the same with the points between the faces shared out
 * \param[in] up the normal of what things stand on; zero if nobody knows
 * \return one entry a pair of faces, sorted by their labels */
std::vector<FaceContact> faceContacts(const detail::InstanceInput& input,
                                      const PointGrid& grid,
                                      const Labels& faces,
                                      const std::vector<Face>& properties,
                                      const Labels& grown,
                                      const Eigen::Vector3f& up);

} // namespace pcl::segmentation
