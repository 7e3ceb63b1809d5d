// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Finds the creases of a cloud: candidates by INAD, votes for where two planes meet.

#pragma once

#include "features/adaptive_inad.h"

#include <pcl/features/shape_model.h>
#include <pcl/segmentation/shape_field.h>

namespace pcl::detail {

/** \brief Find the creases of a cloud: sets its spacings, noise, normals, edge
 * likelihood and creases. See doc/method.md for the steps.
 * \param[in] model two classes, the first of which is the edge */
void findEdges(const FieldInput& input, const ShapeModel& model, ShapeField& field);

} // namespace pcl::detail
