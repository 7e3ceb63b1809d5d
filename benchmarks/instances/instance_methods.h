// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Methods that find instances, with the settings to choose from.

#pragma once

#include "instance_cloud.h"

#include <functional>

namespace instances {

/** \brief A way to find the instances of a cloud. */
struct Method {
  std::string name;
  std::string setting;
  std::function<Labels(const InstanceCloud& cloud)> run;
};

/** \brief pcl::ShapeInstanceSegmentation; it is not told how many there are. */
Method ownMethod(unsigned threads);

/** \brief Others for a task. RANSAC is told how many there are, region growing which of
 * its regions are on what is looked for. */
std::vector<Method> peersFor(Task task);

} // namespace instances
