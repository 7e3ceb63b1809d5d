// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Distances in an image to the nearest marked pixel.

#pragma once

#include <vector>

namespace pcl::segmentation {

/** \brief For each cell of a square image the distance to the nearest marked one, in
 * cells; huge without any. Felzenszwalb and Huttenlocher, Distance transforms of
 * sampled functions, Theory of Computing 8, 2012. \param[in] marks row by row, not 0 is
 * marked */
std::vector<float> distancesTo(const std::vector<char>& marks, int side);

} // namespace pcl::segmentation
