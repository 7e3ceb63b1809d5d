// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Says why points got no answer, when they are many.

#pragma once

#include "cli/report.h"

#include <pcl/segmentation/unknown_points.h>

#include <string>

namespace pcl::app {

/** \brief If more than 5 % of the finite points are unknown, a line on standard error
 * that says why, and the counts by reason in the section "unknown". */
void reportUnknown(const std::string& path,
                   const pcl::UnknownPoints& points,
                   Report& report);

} // namespace pcl::app
