// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// What is drawn over the cloud: lines, boxes, grasps, normals.

#pragma once

#include "viewer/scene.h"

#include <vector>
#include <vtkProp.h>
#include <vtkSmartPointer.h>

namespace pcl::app {

using Props = std::vector<vtkSmartPointer<vtkProp>>;

/** \brief A tube along each line, each of another color. */
Props linesOf(const std::vector<Line>& lines);

/** \brief A box and a name for each instance. */
Props instancesOf(const std::vector<InstanceBox>& instances);

/** \brief An arrow and the suction cup's disc for each grasp: green if it seals, else
 * red. */
Props graspsOf(const Grasps& grasps);

/** \brief Arrows at some thousand of the points.
 * \param[in] length meters */
Props normalsOf(const pcl::PointCloud<pcl::PointXYZ>& points,
                const pcl::PointCloud<pcl::Normal>& normals,
                float length);

} // namespace pcl::app
