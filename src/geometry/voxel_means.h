// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Voxel means that do not depend on the order of the points, and which mean stands for
// a point.

#pragma once

#include <pcl/features/xyz_view.h>

#include <cstdint>
#include <string>
#include <vector>

namespace pcl::detail {

/** \brief What is wrong with a resolution, meters; empty if nothing is. */
std::string problemOfResolution(double resolution, const XYZView& points);

/** \brief The mean of the finite points in each voxel, three coordinates each, in an
 * order, and with values, that do not depend on the order of the points.
 * \param[in] size of a voxel; problemOfResolution() knows which are possible */
std::vector<float> voxelMeans(const XYZView& points, double size, unsigned threads = 1);

/** \brief For each of these means the point with the least coordinates in its voxel. */
std::vector<std::uint32_t>
firstInVoxels(const XYZView& points, double size, unsigned threads = 1);

/** \brief For each query the surface point it stands for: the nearest one within its
 * reach, or -1; of two that are as near the one with the least coordinates. \param[in]
 * reach one for each surface point, meters */
std::vector<std::int32_t> representatives(const XYZView& queries,
                                          const XYZView& surface,
                                          const std::vector<float>& reach,
                                          unsigned threads);

} // namespace pcl::detail
