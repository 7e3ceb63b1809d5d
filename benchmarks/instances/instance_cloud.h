// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Clouds with true instances of several kinds.

#pragma once

#include "scene/scene.h"

#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

#include <cstdint>
#include <string>
#include <vector>

namespace instances {

using Cloud = pcl::PointCloud<pcl::PointXYZ>;
using Labels = std::vector<std::uint32_t>; ///< of points, 0 none

/** \brief What instances are looked for. */
enum class Task {
  curved,  ///< parts of objects that are round
  objects, ///< whole objects
  faces    ///< flat faces, the table among them
};

/** \brief "curved", ... */
const char* name(Task task);

/** \brief Points, and which instance each is truly of. */
struct InstanceCloud {
  std::string group; ///< clouds with this name are reported together
  std::string name;
  Task task = Task::curved;
  Cloud::Ptr points;
  Labels truth;
  std::vector<bool> evaluated; ///< which points count

  /** \brief How many instances there are. */
  std::size_t count() const;
};

InstanceCloud
generatedCloud(const std::string& group, Task task, const pcl::scene::SceneOptions& of);

/** \brief A PCD file with the field surface. An instance is a connected part of its
 * curved points: gaps of 10 mm separate, 100 points at least. */
InstanceCloud curvedParts(const std::string& group, const std::string& path);

} // namespace instances
