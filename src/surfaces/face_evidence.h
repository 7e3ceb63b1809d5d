// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Whether a face bends by more than its noise explains, at any scale.

#pragma once

#include "surfaces/face_pyramid.h"

#include <vector>

namespace pcl::segmentation {

/** \brief Evidence for curved against planar of each node of the first level: the
 * logarithm of a ratio, from -4 to 4; NaN where no window tells. See doc/method.md.
 * \param[in] pyramid with levels \param[in] spacing of the cloud, median \param[in]
 * threads 0 for all cores */
std::vector<float>
faceEvidence(const FacePyramid& pyramid, float spacing, unsigned threads);

} // namespace pcl::segmentation
