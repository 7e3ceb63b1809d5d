// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Which sensor looks at what, and which options go with them.

#pragma once

#include "cli/command_line.h"

namespace pcl::app {

/** \brief What is looked at. */
enum class SceneKind { Table, Part, Room, Street };

/** \brief -sensor and -place. */
void addKindOptions(CommandLine& command_line);

SceneKind sceneKind(const Arguments& arguments);

/** \brief Whether points are spread over all surfaces: there is no camera. */
bool isSampled(const Arguments& arguments);

/** \brief Whether the sensor is a depth camera with a noise of its own. */
bool isDepthCamera(const Arguments& arguments);

/** \throws UsageError for options of one sensor or place with another */
void checkKindOptions(const Arguments& arguments);

} // namespace pcl::app
