// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Heights measured from the plane of the ground instead of the sensor.

#pragma once

#include "ground/ground_cells.h"

namespace pcl::segmentation {

/** \brief Measure heights from the plane that most bottoms of cells are near: a sensor
 * is rarely quite upright. If a sensor is there the plane passes below it.
 * \return false if there is none that is no steeper than ground may be */
bool level(const GroundParameters& parameters, unsigned threads, GroundCells& cells);

} // namespace pcl::segmentation
