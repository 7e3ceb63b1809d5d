// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// PURPOSE

#pragma once

#include <pcl/features/shape_histogram.h>

#include <string>

namespace pcl::app {

/** \brief A PNG picture of a histogram: mu to the right, sigma upwards, both in degrees
 * with a number at every fifth of their range; the colour is the logarithm of the count
 * over the largest, from white (none) to black (the peak). */
std::string heatMap(const pcl::ShapeHistogram& histogram);

} // namespace pcl::app
