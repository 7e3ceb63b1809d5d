// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// PURPOSE

#pragma once

#include "viewer/field_view.h"

namespace pcl::app {

/** \brief Numbers in Viridis. Angles are shown in degrees, what is a probability from 0
 * to 1, anything else from the first to the 99th percentile; what is beyond has the
 * color of the end. */
FieldView numberView(const std::string& field, std::vector<double> values);

} // namespace pcl::app
