// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// A machined part that is sampled all around, or reconstructed, from its options.

#pragma once

#include "cli/arguments.h"
#include "cli/report.h"
#include "io/cloud_file.h"
#include "scene/part_samples.h"

namespace pcl::app {

/** \brief What -seed, -size, -sampling, -spread and -noise say. \throws UsageError that
 * names the option and what is expected */
pcl::scene::PartOptions partOptions(const Arguments& arguments);

/** \brief Sample a random part, or reconstruct it from photographs. The fields are
 * those of a table scene, and crease_s, radius_s and thin_s in spacings. Parameters,
 * counts and time are reported. */
CloudFile partCloud(const Arguments& arguments,
                    const pcl::scene::PartOptions& options,
                    Report& report);

} // namespace pcl::app
