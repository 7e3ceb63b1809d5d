// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// The evidence of faces at each point: its own face's, or the nearest one's.

#pragma once

#include "geometry/point_grid.h"
#include "surfaces/face_evidence.h"

namespace pcl::segmentation {

// How far the nearest face may be: bands of edges are up to 2.2 to either side.
constexpr float nearest_face_spacings = 5.0f;

/** \brief The evidence at each point. A point of an edge takes that of the nearest
 * face. \param[in] of_nodes see faceEvidence() \param[in] spacing median \param[in]
 * bounds of the cloud \param[in] threads 0 for all cores \return NaN unknown */
FaceEvidence evidenceOfFaces(const XYZView& points,
                             const FacePyramid& faces,
                             const FaceEvidence& of_nodes,
                             float spacing,
                             const Bounds& bounds,
                             unsigned threads);

} // namespace pcl::segmentation
