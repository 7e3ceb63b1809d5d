// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Follows creases from where they are clear to where they are faint.

#pragma once

#include "edges/crease_votes.h"

#include <vector>

namespace pcl::segmentation {

/** \brief Give faint places that continue a crease in its direction what they lack: two
 * thresholds, as in Canny, A Computational Approach to Edge Detection (1986). See
 * doc/method.md for what continues a crease.
 * \param[in] needed the evidence of a clear place
 * \param[in] faint the least of a faint one; with as much as needed nothing is followed
 * \param[in] spacing the median of the cloud's, meters
 * \param[in,out] agreements those that continue a crease get just more than is needed
 */
void continueCreases(float needed,
                     float faint,
                     float spacing,
                     unsigned threads,
                     std::vector<Agreement>& agreements);

/** \brief How far it follows a crease, in spacings. */
float continuationSpacings();

} // namespace pcl::segmentation
