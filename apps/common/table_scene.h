/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * Point Cloud Library (PCL) - www.pointclouds.org
 * Copyright (c) 2026, pcl_shape contributors
 *
 * All rights reserved
 */

#pragma once

#include "arguments.h"
#include "cloud_file.h"
#include "report.h"

#include <scene/scene.h>

namespace pcl::app {

/** \brief Make a random table scene: as a depth camera sees it, or with -sampling
 * points all over its surfaces. The fields are x, y, z, the normals if -normals is
 * given, surface, edge, instance, crease_mm, and face if -faces is. Parameters, counts
 * and time are reported. \param[in] options what the arguments say of the scene \throws
 * UsageError for options of a camera together with -sampling */
CloudFile tableCloud(const Arguments& arguments,
                     const pcl::scene::SceneOptions& options,
                     Report& report);

} // namespace pcl::app
