// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// The sensor and the place of a scene, and which options go with them.

#pragma once

#include "cli/command_line.h"

#include <cstdint>
#include <optional>
#include <string>

namespace pcl::app {

/** \brief What is looked at. */
enum class SceneKind { Table, Part, Room, Street };

/** \brief -sensor and -place. */
void addKindOptions(CommandLine& command_line);

SceneKind sceneKind(const Arguments& arguments);

/** \brief -seed, 1 by default. */
std::uint64_t seedOf(const Arguments& arguments);

/** \brief Whether points are spread over all surfaces: there is no camera. */
bool isSampled(const Arguments& arguments);

/** \brief Whether the sensor is a depth camera with a noise of its own. */
bool isDepthCamera(const Arguments& arguments);

/** \brief The sigma of -noise, meters; 0 of "none". Nothing if it is not given or the
 * usual one, the name of the sensor's own noise or "none".
 * \throws UsageError unless it is one of these, or a number from 0 to 0.1 */
std::optional<double> noiseSigma(const Arguments& arguments, const std::string& usual);

/** \throws UsageError for options of one sensor or place with another */
void checkKindOptions(const Arguments& arguments);

} // namespace pcl::app
