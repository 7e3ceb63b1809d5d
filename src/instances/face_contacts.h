// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// PURPOSE

#pragma once

#include "instances/faces.h"
#include "instances/smooth_pieces.h"

#include <array>
#include <cstdint>
#include <vector>

namespace pcl::segmentation {

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

/** \brief How far points of two faces that meet may be apart, in spacings;
 * doc/instances.md has the reason. */
constexpr float contact_reach = 1.0f;

/** \brief A place where two faces meet. */
struct FaceMeeting {
  std::int32_t first, second;
  std::array<float, 3> cell;
  std::array<float, 3> position;
  float spacing;
};

/** \brief One meeting a pair of faces in each cell of space, sorted by the faces'
 * labels. \param[in] grown label of each point of a face, the points between faces
 * shared out */
std::vector<FaceMeeting> faceMeetings(const detail::InstanceInput& input,
                                      const PointGrid& grid,
                                      const Labels& grown);

} // namespace pcl::segmentation
