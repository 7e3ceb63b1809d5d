/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * Point Cloud Library (PCL) - www.pointclouds.org
 * Copyright (c) 2026, pcl_shape contributors
 *
 * All rights reserved
 */

#pragma once

#include "row_index.h"

namespace pcl::kernels {

/** \brief Sort the points of each row by x, y and z. They are sorted by cells of x. */
void finishRows(RowIndex& index, unsigned threads);

} // namespace pcl::kernels
