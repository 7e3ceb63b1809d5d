// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// The feet of obstacles, and what hangs above the ground.

#pragma once

#include "ground/ground_cells.h"

#include <vector>

namespace pcl::segmentation {

/** \brief Marks points near the bottom of their cell that have others above them: the
 * feet of walls, poles, cars, and the ground just beside. Point by point.
 * \param[in] max_step meters: what is not as high is no obstacle */
std::vector<char> feetOf(const GroundCells& cells, float max_step, unsigned threads);

/** \brief Marks the cells around a laser beneath whose lowest point more rays pass than
 * end there: what a laser sees farther away and lower, it sees below that point. Ground
 * has no rays beneath it. No cells are marked elsewhere: without a laser in the middle
 * no rays are known. Heights have to be those above the sensor. */
std::vector<char>
overhangsOf(const GroundCells& cells, float max_step, unsigned threads);

} // namespace pcl::segmentation
