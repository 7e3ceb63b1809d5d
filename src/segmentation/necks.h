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

/** \brief Cut components of nodes where creases run into them and leave but a neck.
 *
 * A crease that is not found all along joins what it bounds. Parts of a component that
 * are apart from edges, and connected with each other by nothing else but places near
 * edges, stay apart if their common border is an edge for the most part.
 * \param[in] points all of the cloud
 * \param[in] labels of componentsOf(links) */
Labels cutNecks(const detail::InstanceInput& input,
                const PointGrid& points,
                const SurfaceNodes& nodes,
                const Links& links,
                const Labels& labels);

} // namespace pcl::segmentation
