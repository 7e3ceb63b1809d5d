// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Boxes without a lid: their inner and outer walls and the floor become one object.

#pragma once

#include "instances/faces/face_contacts.h"
#include "instances/instance_points.h"

#include <Eigen/Core>

#include <vector>

namespace pcl::segmentation {

/** \brief Join the inner walls of open boxes, which meet at concave edges and end at
 * the same height, and to them the outer walls and the floor. \param[in] up unit,
 * normal of the support \param[in] contacts of faces \param[in] groups of the faces;
 * joined like the labels \param[in,out] labels of points: those of the groups */
void joinOpenBoxes(const detail::InstanceInput& input,
                   const Eigen::Vector3f& up,
                   const Labels& faces,
                   const std::vector<FaceContact>& contacts,
                   const Labels& groups,
                   Labels& labels);

} // namespace pcl::segmentation
