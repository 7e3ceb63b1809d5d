// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// The evidence of faces at each point: its own face's, or the nearest one's.

#pragma once

#include "surfaces/face_pyramid.h"

#include <vector>

namespace pcl::segmentation {

/** \brief Evidence for curved against planar at each point, as of faceEvidence(). A
 * point of an edge takes that of the nearest face. \param[in] spacing median
 * \param[in] threads 0 for all cores \return NaN unknown */
std::vector<float> evidenceOfFaces(const XYZView& points,
                                   const FacePyramid& faces,
                                   float spacing,
                                   unsigned threads);

} // namespace pcl::segmentation
