// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// The options of INAD: radii or k, outlier rate, scale.

#pragma once

#include "cli/arguments.h"
#include "cli/command_line.h"
#include "cli/report.h"
#include "io/cloud_file.h"

#include <pcl/features/inad_point.h>
#include <pcl/features/shape_model.h>

#include <string>

namespace pcl::app {

/** \brief -radius, -normal_radius, -scale, -k, -outlier_rate, -use_normals.
 * \param[in] condition said before the help of those that need one */
void addInadOptions(CommandLine& command_line, const std::string& condition = "");

/** \brief -scale, fixed by default. */
AdaptiveRadius::RadiusMode radiusMode(const Arguments& arguments);

/** \brief What -scale calls it. */
std::string nameOfScale(AdaptiveRadius::RadiusMode mode);

/** \brief The parameters on the command line over given ones. -radius alone is the
 * normal radius too if the two are equal in `defaults`. \throws UsageError for -k
 * together with a radius */
INADParameters inadParameters(const Arguments& arguments,
                              const INADParameters& defaults);

void reportParameters(const INADParameters& parameters, Report& report);

/** \throws InputError if k is above the number of finite points */
void requireEnoughPoints(const INADParameters& parameters,
                         const CloudFile& cloud,
                         const pcl::PointCloud<pcl::PointXYZ>& points);

} // namespace pcl::app
