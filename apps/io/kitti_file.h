// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Files of KITTI and SemanticKITTI: scans, labels, classes.

#pragma once

#include "io/cloud_file.h"

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace pcl::app {

/** \brief A scan of KITTI, four float32 a point: x, y, z and intensity; or of nuScenes,
 * with a fifth, ring. \param[in] floats 4 or 5, or 0 if the size of the file says it
 * \throws InputError that names the path, what is wrong, and what is expected */
CloudFile
decodeVelodyne(const std::string& path, std::string_view file, unsigned floats = 0);

/** \brief The bytes of such a scan, of four float32 a point, with the cloud's offset
 * subtracted. The fourth number is the field intensity, reflectivity or
 * remission, if it is a float, else 0. */
std::string encodeVelodyne(const CloudFile& cloud);

/** \brief A .label file of SemanticKITTI: uint32 a point, the class in the lower 16
 * bits and no instance in the upper ones. \param[in] labels below 2^16 */
std::string encodeLabels(const std::vector<std::uint32_t>& labels);

/** \brief A class for the configuration file of SemanticKITTI. */
struct KittiClass {
  std::string name;
  double share; ///< of the points of all clouds
};

/** \brief The configuration file: labels, color_map, content, learning_map and so on.
 * \param[in] classes by their labels: 0 is what is not learned */
std::string encodeKittiClasses(const std::vector<KittiClass>& classes);

} // namespace pcl::app
