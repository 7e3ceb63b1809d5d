// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Parts of one body on either side of what hides its middle.

#pragma once

#include "instances/faces/faces.h"
#include "instances/instance_points.h"

#include <vector>

namespace pcl::segmentation {

/** \brief Join groups of faces that are one body behind another one.
 *
 * They are if their surfaces go on from one to the other: one cylinder or sphere
 * describes a face of each as well as it describes one alone, or one plane does, twice
 * and in two directions, as at the top and the front of a box. And if nobody can see
 * that they end: between them something is nearer to the viewpoint.
 * \param[in] faces of each point, -1 none
 * \param[in,out] groups of each face, -1 none; a joined one takes the lower label */
void joinHiddenParts(const detail::InstanceInput& input,
                     const Labels& faces,
                     const std::vector<Face>& properties,
                     Labels& groups);

} // namespace pcl::segmentation
