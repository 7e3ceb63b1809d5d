// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// PURPOSE

#pragma once

#include <pcl/segmentation/adaptive_detection.h>

#include <vector>

namespace pcl::segmentation {

/** \brief Normals and INAD at radii that follow a cloud; NaN unknown. */
struct AdaptiveINAD {
  std::vector<float> normals;  ///< three for each point
  std::vector<float> mu_sigma; ///< two for each point, radians
};

/** \param[in] edges with spacings and noise
 * \param[in] parameters radii in spacings */
AdaptiveINAD adaptiveINAD(const detail::AdaptiveInput& input,
                          const detail::AdaptiveEdges& edges,
                          const INADParameters& parameters);

} // namespace pcl::segmentation
