// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// The radii of the default edge model, which noise is measured with.

#pragma once

namespace pcl::detail::edge_radii {

/** In spacings, and what they grow by with the noise. */
constexpr double normal_radius = 1.2, normal_radius_noise = 10.0;
constexpr double inad_radius = 1.0, inad_radius_noise = 5.0;

} // namespace pcl::detail::edge_radii
