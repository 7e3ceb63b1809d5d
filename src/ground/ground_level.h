// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// PURPOSE

#pragma once

#include "ground/ground_cells.h"

#include <pcl/segmentation/ground_detection.h>

namespace pcl::segmentation {

/** \brief Measure heights from the plane that most bottoms of cells are near. A sensor
 * is rarely quite upright. \return whether there is one that is not steeper than ground
 * may be */
bool level(const GroundParameters& parameters, unsigned threads, GroundCells& cells);

} // namespace pcl::segmentation
