// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Instances that were found, as a field and counts.

#include "detection/instances.h"

#include "cli/pcl_errors.h"
#include "results/result_files.h"

namespace pcl::app {

void
addInstances(CloudFile& file, InstanceSegmentation& segmentation, Report& report)
{
  std::vector<pcl::ShapeInstance> instances;
  withPclErrors(file.path, [&] {
    return report.time("instances", [&] { return segmentation.segment(instances); });
  });
  std::vector<std::uint32_t> labels(file.size(), 0);
  std::uint64_t labeled = 0;
  for (std::size_t k = 0; k < instances.size(); ++k) {
    for (const pcl::index_t index : instances[k].indices)
      labels[static_cast<std::size_t>(index)] = static_cast<std::uint32_t>(k + 1);
    labeled += instances[k].indices.size();
  }
  report.setCount("counts", "instances", instances.size());
  report.setCount("counts", "points in them", labeled);
  reportInstances(
      instances, segmentation.getClass(), segmentation.getClasses(), report);
  setField(file, "instance", labels);
}

} // namespace pcl::app
