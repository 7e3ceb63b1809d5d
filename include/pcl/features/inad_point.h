/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * Point Cloud Library (PCL) - www.pointclouds.org
 * Copyright (c) 2026, pcl_shape contributors
 *
 * All rights reserved
 */

#pragma once

#include <pcl/memory.h>
#include <pcl/register_point_struct.h>

#include <ostream>

namespace pcl {

/** \brief The inter normal angle difference at a point: mean and standard deviation of
 * the angles between its normal and the normals of its neighbors, in radians.
 *
 * Both are in [0, pi/2], or NaN where the point has too few neighbors.
 * \ingroup features
 */
struct INAD {
  float mu = 0.0f;    ///< mean, radians
  float sigma = 0.0f; ///< standard deviation, radians
};

inline std::ostream&
operator<<(std::ostream& stream, const INAD& inad)
{
  return stream << '(' << inad.mu << ',' << inad.sigma << ')';
}

} // namespace pcl

POINT_CLOUD_REGISTER_POINT_STRUCT(pcl::INAD, (float, mu, mu)(float, sigma, sigma))
