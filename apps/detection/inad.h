// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// INAD of a cloud: its options, and the stages from the file to all points.

#pragma once

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

/** \brief What -scale calls it. */
std::string nameOfScale(AdaptiveRadius::RadiusMode mode);

/** \brief The parameters on the command line over given ones. -radius alone is the
 * normal radius too if the two are equal in `defaults`. \throws UsageError for -k
 * together with a radius */
INADParameters inadParameters(const Arguments& arguments,
                              const INADParameters& defaults);

void reportParameters(const INADParameters& parameters, Report& report);

/** \brief A cloud with what the classes of pcl_shape need of it. */
struct InadCloud {
  pcl::PointCloud<pcl::PointXYZ>::ConstPtr points;
  pcl::PointCloud<pcl::Normal>::ConstPtr normals;
  pcl::PointCloud<pcl::INAD>::ConstPtr inad;
};

/** \brief From a file to INAD at all its points: with its own normals if -use_normals
 * is given, else with estimated ones, which are set as fields if -normals is given. The
 * sizes of the cloud, the parameters and the times of the stages are reported. */
InadCloud estimateInad(CloudFile& file,
                       const Arguments& arguments,
                       const INADParameters& parameters,
                       Report& report);

/** \brief Set normals of the cloud, over the radius for its noise, and their curvature.
 * Equal points count once. */
void addNormals(CloudFile& file,
                const pcl::PointCloud<pcl::PointXYZ>::ConstPtr& points,
                const INADParameters& parameters,
                unsigned threads);

} // namespace pcl::app
