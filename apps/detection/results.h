// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// What detectors found, as fields and counts.

#pragma once

#include "cli/report.h"
#include "detection/detection.h"
#include "io/cloud_file.h"

#include <pcl/segmentation/shape_back_projection.h>
#include <pcl/segmentation/shape_edge_detection.h>

#include <functional>
#include <vector>

namespace pcl::app {

using EdgeDetector = pcl::ShapeEdgeDetection<pcl::PointXYZ, pcl::Normal>;

/** \brief Which results are wanted. */
struct EdgeResults {
  bool edges = true;
  bool types = false; ///< default method only
  bool lines = false; ///< default method only
};

/** \brief Add the fields that are wanted.
 * \param[in] detector ready for compute(), with a field for the default method
 * \return the creases, if lines are wanted */
std::vector<pcl::CreaseLine> addEdges(CloudFile& file,
                                      EdgeDetector& detector,
                                      const EdgeResults& results,
                                      Report& report);

using SurfaceDetector = pcl::ShapeBackProjection<pcl::PointXYZ, pcl::Normal>;

/** \brief Add the fields likelihood and surface, and with a model of several classes
 * the likelihood of each. \param[in] detector ready for compute(), with a field for the
 * default method */
void addSurfaces(CloudFile& file,
                 SurfaceDetector& detector,
                 const DetectionSettings& settings,
                 Report& report);

/** \brief Adds fields to a cloud. \return its creases, if -lines is given */
using LineFilter =
    std::function<std::vector<pcl::CreaseLine>(CloudFile& cloud, Report& report)>;

/** \brief runFilter() that also writes the -lines file, if it is asked for. */
int runFilterWithLines(const Arguments& arguments, const LineFilter& filter);

} // namespace pcl::app
