// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// By how much the nodes of smooth faces are off them, place by place.

#pragma once

#include "surfaces/face_fit.h"

#include <optional>
#include <vector>

namespace pcl::segmentation {

/** \brief The noise at each node of a level: the first quartile of the residuals around
 * it, since windows that cross creases, or hold more than a quadric can follow, have
 * larger ones than the noise. A ripple of the sensor counts as noise at the levels
 * whose windows are as wide as its waves. \param[in] fits of each node's window
 * \param[in] spacing of the cloud, median */
std::vector<float> faceNoise(const FaceLevel& level,
                             const std::vector<std::optional<FaceFit>>& fits,
                             float spacing);

} // namespace pcl::segmentation
