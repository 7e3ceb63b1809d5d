// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// PURPOSE

#pragma once

#include "viewer/field_view.h"

namespace pcl::app {

/** \brief Whether the field is a label: known as one, or of whole numbers, not too many
 * different ones. */
bool hasLabels(const CloudFile& cloud,
               const std::string& field,
               const std::vector<double>& values);

/** \brief \throws InputError if a value is not a whole number */
FieldView labelView(const CloudFile& cloud,
                    const std::string& field,
                    const std::vector<double>& values,
                    const std::map<std::int64_t, std::string>& names);

} // namespace pcl::app
