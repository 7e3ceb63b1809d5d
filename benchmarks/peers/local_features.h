// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Features of single points that tell edges and curved surfaces.

#pragma once

#include "../common/pcl_regions.h"
#include "peer.h"

namespace peers {

using pcl_regions::Normals;
using pcl_regions::normalsOf;

/** \brief "12 mm" */
std::string millimeters(double radius);

/** \brief Surface variation: the smallest eigenvalue over the sum of all. */
Peer surfaceVariation(const std::vector<double>& radii);

/** \brief The larger of pcl::PrincipalCurvaturesEstimation. */
Peer principalCurvature(const std::vector<double>& radii);

} // namespace peers
