/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * Point Cloud Library (PCL) - www.pointclouds.org
 * Copyright (c) 2026, pcl_shape contributors
 *
 * All rights reserved
 */

#pragma once

#include "surface_nodes.h"

namespace pcl::segmentation {

/** \brief Cut pieces that are planes, cylinders or spheres on each side of a border
 * where these do not meet: faces that cross, or are nearly in line.
 *
 * A piece that such primitives do not describe stays whole.
 * \param[in] labels of the nodes, -1 none
 * \return labels of the nodes; nodes of a piece that was cut which are on none of its
 * parts have none
 */
Labels splitSurfaces(const detail::InstanceInput& input,
                     const std::vector<SurfaceNode>& nodes,
                     Labels labels);

} // namespace pcl::segmentation
