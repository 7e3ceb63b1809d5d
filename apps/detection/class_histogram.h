// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// The histogram of one class, from options and a model.

#pragma once

#include "cli/arguments.h"
#include "cli/report.h"

#include <pcl/features/shape_model.h>

#include <string>

namespace pcl::app {

/** \brief The bins of the model's classes, without a count; of a model without a class
 * those of -bins, -mu_range and -sigma_range.
 * \param[in] path of the model file
 * \throws InputError if other bins than the model's are asked for */
pcl::ShapeHistogram emptyHistogram(const pcl::ShapeModel& model,
                                   const std::string& path,
                                   const Arguments& arguments);

/** \brief Bins, counts and peak, angles in degrees. */
void reportHistogram(const pcl::ShapeHistogram& histogram, Report& report);

} // namespace pcl::app
