// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Whether points lie on the steps of a sensor that are wider than their neighborhoods.

#pragma once

#include <pcl/features/impl/neighborhoods.hpp>

#include <vector>

namespace pcl::detail {

/** \brief Whether most of a cloud that seems to bend does so only between the steps of
 * its sensor.
 *
 * A sensor that counts disparities or ticks of a clock gives steps, which grow with the
 * square of the range: the points of each are on a plane without noise. Steps and the
 * faces of a shape differ in this: all steps around a place have the same normal, for
 * there are no points on the risers between them, while the means of many points have
 * other normals. \param[in] neighborhoods of all points of a cloud among themselves
 * \param[in] spacings one for each point */
bool areOnWideSteps(const Neighborhoods& neighborhoods,
                    const std::vector<float>& spacings,
                    unsigned threads);

} // namespace pcl::detail
