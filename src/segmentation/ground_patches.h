/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * Point Cloud Library (PCL) - www.pointclouds.org
 * Copyright (c) 2026, pcl_shape contributors
 *
 * All rights reserved
 */

#pragma once

#include "ground_cells.h"
#include "ground_planes.h"

#include <pcl/segmentation/ground_detection.h>

#include <vector>

namespace pcl::segmentation {

struct GroundPatches {
  std::vector<GroundPatch> patches; ///< one a cell; not planar where there is none
  std::vector<PatchNeighbors> neighbors;
};

/** \brief The planarity of the lowest surface, cell by cell. \param[in] feet see
 * feetOf() */
GroundPatches groundPatches(const GroundCells& cells,
                            const std::vector<char>& feet,
                            const GroundParameters& parameters,
                            unsigned threads);

} // namespace pcl::segmentation
