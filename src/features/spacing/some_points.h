// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Some points of a cloud that stand for all, whatever their order.

#pragma once

#include <pcl/features/xyz_view.h>
#include <pcl/types.h>

#include <cstdint>

namespace pcl::detail {

/** \brief About as many finite points as are asked for, chosen by where they are. */
pcl::Indices somePoints(const XYZView& points, std::size_t count);

/** \brief Those of a part of a cloud; with a larger count the same ones, and more.
 * \param[in] count how many of the whole \param[in]
 * of_points how many points the whole has */
pcl::Indices
somePoints(const XYZView& points, std::size_t count, std::uint64_t of_points);

} // namespace pcl::detail
