// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// The feet of obstacles: low points that have others above them.

#pragma once

#include "ground/ground_cells.h"

#include <vector>

namespace pcl::segmentation {

/** \brief Marks points near the bottom of their cell that have others above them: the
 * feet of walls, poles, cars, and the ground just beside. Point by point.
 * \param[in] max_step meters: what is not as high is no obstacle */
std::vector<char> feetOf(const GroundCells& cells, float max_step, unsigned threads);

} // namespace pcl::segmentation
