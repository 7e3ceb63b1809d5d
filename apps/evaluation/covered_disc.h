// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Whether a disc has points everywhere.

#pragma once

#include <Eigen/Core>

#include <vector>

namespace pcl::app {

constexpr std::size_t min_covering = 20; ///< fewer points cover nothing

/** \brief Whether no place of a disc around the origin is farther from all points than
 * two of their mean distances. A disc of that radius holds 12 points on average; of
 * 160,000 such discs between points at random only one is empty.
 * \param[in] places of the points, also of some around the disc
 * \param[in] radius of the disc */
bool isCovered(const std::vector<Eigen::Vector2d>& places, double radius);

} // namespace pcl::app
