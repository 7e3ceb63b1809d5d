// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// The results of edge detection, as fields and lines.

#pragma once

#include "cli/report.h"
#include "detection/detection.h"
#include "io/cloud_file.h"

#include <pcl/segmentation/shape_edge_detection.h>

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

} // namespace pcl::app
