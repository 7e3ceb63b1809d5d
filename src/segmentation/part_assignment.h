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

/** \brief Give each node of a piece to a part whose surface is near and which others
 * around it are of (iterated conditional modes; Besag, "On the statistical analysis of
 * dirty pictures", 1986); nodes near none to none. Parts that are left with few nodes,
 * or with nodes on the surfaces of others, go. The largest part is first then. */
void assignNodes(const SurfacePiece& piece, std::vector<SurfacePart>& parts);

} // namespace pcl::segmentation
