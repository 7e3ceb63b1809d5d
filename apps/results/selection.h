// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// The options that select some points of a cloud.

#pragma once

#include "cli/command_line.h"
#include "cli/report.h"
#include "io/cloud_file.h"

#include <pcl/pcl_base.h>

#include <cstdint>
#include <map>

namespace pcl::app {

/** \brief -field, -value and -box, which select some points of a cloud. */
void addSelectionOptions(CommandLine& command_line);

/** \brief -each and -parts, which select all objects of a cloud instead. */
void addEachOptions(CommandLine& command_line);

/** \brief Throws a UsageError for what is wrong with these options. */
void checkSelection(const Arguments& arguments);

/** \brief Notes these options, where they are given, among the parameters. */
void reportSelection(const Arguments& arguments, Report& report);

/** \brief The finite points that are selected: all of them without these options.
 * \throws InputError if there is none, or the field is missing or bad */
pcl::IndicesPtr selectedPoints(const CloudFile& file,
                               const pcl::PointCloud<pcl::PointXYZ>& points,
                               const Arguments& arguments);

/** \brief The finite points of each object of the field of -each, by its number from 1
 * on. \throws InputError if there is none, or the field is missing or bad */
std::map<std::uint32_t, pcl::IndicesPtr>
selectedObjects(const CloudFile& file,
                const pcl::PointCloud<pcl::PointXYZ>& points,
                const Arguments& arguments);

} // namespace pcl::app
