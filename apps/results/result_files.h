// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// The JSON of crease lines, instances and grasps, as doc/files.md describes it.

#pragma once

#include "cli/report.h"
#include "io/cloud_file.h"

#include <pcl/segmentation/shape_field.h>
#include <pcl/segmentation/shape_instance_segmentation.h>
#include <pcl/segmentation/suction_grasp_estimation.h>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace pcl::app {

/** \brief The contents of the -lines file. */
std::string linesToJson(const CloudFile& input, const std::vector<CreaseLine>& lines);

/** \brief Note the instances, their number from 1 on. \param[in] of_class what they are
 * instances of \param[in] classes the names of their shares */
void reportInstances(const std::vector<ShapeInstance>& instances,
                     const std::string& of_class,
                     const std::vector<std::string>& classes,
                     Report& report);

/** \brief The grasps on one target. */
struct TargetGrasps {
  std::optional<std::uint32_t> object; ///< its number, if there are several targets
  std::size_t points = 0;
  std::vector<SuctionGrasp> grasps; ///< the best first
};

/** \brief The contents of the -json file of pcl_shape_grasp. */
std::string graspsToJson(const std::string& app,
                         const Report& report,
                         const std::vector<TargetGrasps>& targets);

} // namespace pcl::app
