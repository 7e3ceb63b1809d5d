/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * Point Cloud Library (PCL) - www.pointclouds.org
 * Copyright (c) 2026, pcl_shape contributors
 *
 * All rights reserved
 */

#pragma once

#include "surface_piece.h"

namespace pcl::segmentation {

/** \brief The nodes of parts that are one surface: those that meet where their nodes
 * do, and those too small to be another. */
std::vector<NodeIndices> joinParts(const SurfacePiece& piece,
                                   const std::vector<SurfacePart>& parts);

} // namespace pcl::segmentation
