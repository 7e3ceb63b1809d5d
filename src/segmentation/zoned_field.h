// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// The field of a cloud whose zones have resolutions of their own.

#pragma once

#include "segmentation/resolution_zones.h"

#include <vector>

namespace pcl::detail {

/** \brief The field of the places of all zones, each with what its zone says of it. */
ShapeField zonedField(const FieldRequest& request,
                      const std::vector<ResolutionZone>& zones);

} // namespace pcl::detail
