// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Which flat parts carry things.

#pragma once

#include "instances/supports/support_parts.h"

#include <cstddef>
#include <vector>

namespace pcl::segmentation {

/** \brief The parts that are supports: first those that are large, then
 * smaller ones high above these, then lower levels.
 * \param[in] nodes all of the cloud \param[in] unit the median spacing, meters */
std::vector<std::size_t> carriersAmong(const std::vector<SupportPart>& parts,
                                       const std::vector<SurfaceNode>& nodes,
                                       float unit,
                                       unsigned threads);

/** \brief Whether a part is steep to another one that ends there, along half of it or
 * more. \param[in] unit the median spacing, meters */
bool isWallOf(const SupportPart& part, const SupportPart& bottom, float unit);

} // namespace pcl::segmentation
