// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// PURPOSE

#pragma once

#include "cli/report.h"

#include <pcl/segmentation/suction_grasp.h>

#include <string>
#include <vector>

namespace pcl::app {

/** \brief The contents of the -json file of pcl_shape_grasp, see doc/files.md. */
std::string graspsToJson(const std::string& app,
                         const Report& report,
                         const std::vector<SuctionGrasp>& grasps);

} // namespace pcl::app
