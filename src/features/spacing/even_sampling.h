// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Fewer points where dense parts of a cloud meet sparse ones.

#pragma once

#include <pcl/features/xyz_view.h>

#include <vector>

namespace pcl::detail {

/** \brief Points whose spacing changes slowly: a dense part beside a sparse one is
 * replaced by its voxel means, so that the neighborhoods of both see both. The rest of
 * the points come first, as they are. \return three coordinates each
 * \param[in] spacings one for each point, meters. Points that are not finite are left
 * out */
std::vector<float> evenSampling(const XYZView& points,
                                const std::vector<float>& spacings,
                                unsigned threads = 1);

} // namespace pcl::detail
