// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// The field of a cloud with its surfaces, for the apps that have one method only.

#include "detection/surface_field.h"

#include "cli/pcl_errors.h"
#include "detection/resolution.h"
#include "detection/unknown.h"

#include <pcl/segmentation/shape_field_estimation.h>

namespace pcl::app {

pcl::ShapeField::ConstPtr
surfaceFieldOf(const CloudFile& file,
               const pcl::PointCloud<pcl::PointXYZ>::ConstPtr& points,
               const std::optional<pcl::ShapeModel>& model,
               double resolution,
               unsigned threads,
               Report& report)
{
  pcl::ShapeFieldEstimation<pcl::PointXYZ> estimation;
  estimation.setInputCloud(points);
  estimation.setResolution(resolution);
  if (model)
    estimation.setSurfaceModel(*model);
  estimation.setNumberOfThreads(threads);
  const auto field = pcl::make_shared<pcl::ShapeField>();
  withPclErrors(file.path, [&] { return estimation.compute(*field); });
  reportResolution(file.path, field->resolution, resolution, report);
  reportUnknown(file.path, *field, threads, report);
  return field;
}

} // namespace pcl::app
