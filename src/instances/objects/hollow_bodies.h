// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Cups and bowls: the inside, seen over the rim, and its floor belong to the outside.

#pragma once

#include "instances/instance_points.h"

#include <Eigen/Core>

namespace pcl::segmentation {

/** \brief Give the insides of hollow bodies the labels of their outsides.
 *
 * Only at the ends of the rim can a sensor see them meet. So their shapes decide: the
 * inside is concave, both face away from or towards one axis at about the same
 * distance, and the inside ends at most 0.3 of the height above the outside's rim,
 * and at most half of it below, as where the image cuts it off.
 * \param[in] input the points, and how they are seen
 * \param[in] up the normal of what they stand on
 * \param[in,out] labels of the objects, for each point */
void joinInsides(const detail::InstanceInput& input,
                 const Eigen::Vector3f& up,
                 Labels& labels);

/** \brief Give the floors of hollow bodies, which are hardly higher than what these
 * stand on, the labels of the bodies that one sees around them, of several the
 * innermost.
 * \param[in] input the points, and how they are seen
 * \param[in] up the normal of what they stand on
 * \param[in] patch_of the patch of each point, apart from its support; -1 none
 * \param[in,out] labels of the objects, for each point */
void joinFloors(const detail::InstanceInput& input,
                const Eigen::Vector3f& up,
                const Labels& patch_of,
                Labels& labels);

} // namespace pcl::segmentation
