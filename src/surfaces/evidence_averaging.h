// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Averages of evidence over a surface that do not cross its edges.

#pragma once

#include "features/adaptive_inad.h"

#include <pcl/segmentation/shape_field.h>

#include <cstddef>
#include <vector>

namespace pcl::segmentation {

/** \brief Average the evidence of each class over neighborhoods, without crossing
 * edges.
 *
 * A few points stand for all: of the known ones in each cell of space the one nearest
 * to its middle. The averages of averages there reach further than one neighborhood
 * would: around corners of the surface, but not across its edges.
 * \param[in] evidence logarithms of densities, point by point; NaN stays NaN */
std::vector<float> averageEvidence(const detail::FieldInput& input,
                                   const ShapeField& edges,
                                   std::vector<float> evidence,
                                   std::size_t classes);

} // namespace pcl::segmentation
