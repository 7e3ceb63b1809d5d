// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Heights measured from the plane of the ground instead of the sensor.

#pragma once

#include "ground/ground_cells.h"

namespace pcl::segmentation {

/** \brief Measure heights from the plane that most bottoms of cells are near: a sensor
 * is rarely quite upright. If a sensor is there the plane passes below it. It may be
 * twice as steep as ground may be, as the sensor may be tilted.
 * \return the share of the bottoms near it, 0 if there is no such plane */
double level(const GroundParameters& parameters, unsigned threads, GroundCells& cells);

} // namespace pcl::segmentation
