// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Some points of a cloud that stand for all, whatever their order.

#pragma once

#include <pcl/features/xyz_view.h>
#include <pcl/types.h>

namespace pcl::detail {

/** \brief About as many finite points as are asked for, chosen by where they are. */
pcl::Indices somePoints(const XYZView& points, std::size_t count);

} // namespace pcl::detail
