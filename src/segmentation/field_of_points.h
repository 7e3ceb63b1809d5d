// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// The field of a cloud at its points, however uneven it is.

#pragma once

#include "segmentation/field_stages.h"

namespace pcl::detail {

/** \brief The field at the points of the request's surface. If the spacing changes so
 * fast that too many points stay unknown, points take values from means that even the
 * cloud out. \param[in] toEdges whether the field goes on to edges */
ShapeField fieldOfPoints(const FieldRequest& request, const ToEdges& toEdges);

} // namespace pcl::detail
