// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// PURPOSE

#pragma once

#include <pcl/segmentation/shape_instance_segmentation.h>

#include <string>
#include <vector>

namespace pcl::app {

/** \brief A JSON list of instances, their number from 1 on, as doc/files.md describes
 * it. \param[in] of_class what they are instances of
 * \param[in] classes the names of their shares */
std::string instancesToJson(const std::vector<ShapeInstance>& instances,
                            const std::string& of_class,
                            const std::vector<std::string>& classes);

} // namespace pcl::app
