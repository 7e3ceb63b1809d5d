// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Follows creases from where they are clear to where they are faint.

#pragma once

#include "edges/crease_votes.h"

#include <vector>

namespace pcl::segmentation {

/** \brief Give faint places that continue a crease in its direction what they lack: two
 * thresholds, as in Canny, A Computational Approach to Edge Detection (1986).
 * \param[in] needed the evidence of a clear place
 * \param[in] faint that of a faint one: if it is no less, there is none
 * \param[in] spacing the median of the cloud's, meters \param[in] bounds the cloud's */
void continueCreases(float needed,
                     float faint,
                     float spacing,
                     const Bounds& bounds,
                     unsigned threads,
                     std::vector<Agreement>& agreements);

/** \brief How far it follows a crease, in spacings. */
float continuationSpacings();

} // namespace pcl::segmentation
