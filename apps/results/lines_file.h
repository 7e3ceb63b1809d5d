// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// PURPOSE

#pragma once

#include <pcl/segmentation/adaptive_detection.h>

#include <string>
#include <vector>

namespace pcl::app {

/** \brief The contents of the -lines file, see doc/files.md. */
std::string linesToJson(const std::string& input, const std::vector<CreaseLine>& lines);

} // namespace pcl::app
