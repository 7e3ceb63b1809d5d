// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// The posteriors of the classes of surfaces, by back-projection inside the faces.

#pragma once

#include "features/adaptive_inad.h"

#include <pcl/features/shape_model.h>
#include <pcl/segmentation/shape_field.h>

namespace pcl::detail {

/** \brief Set the classes and their posteriors. See doc/method.md for the steps.
 * \param[in,out] field with its edges, which evidence does not cross */
void
classifySurfaces(const FieldInput& input, const ShapeModel& model, ShapeField& field);

} // namespace pcl::detail
