// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// From the modes of a likelihood to places where a suction cup fits.

#pragma once

#include "grasps/target_surface.h"

#include <vector>

namespace pcl::segmentation {

/** \brief Places for a cup on one class of surface: a grasp for each mode of its
 * likelihood, in the order of the modes.
 * \param[in] weights how likely the class is, one for each of target.points()
 * \param[in] surface the number of the class */
std::vector<SuctionGrasp> placeCups(const TargetSurface& target,
                                    const std::vector<float>& weights,
                                    std::uint32_t surface,
                                    const SuctionCup& cup,
                                    unsigned threads);

} // namespace pcl::segmentation
