/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * Point Cloud Library (PCL) - www.pointclouds.org
 * Copyright (c) 2026, pcl_shape contributors
 *
 * All rights reserved
 */

#pragma once

#include "surface_graph.h"

#include <array>
#include <cstdint>
#include <vector>

namespace pcl::segmentation {

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
