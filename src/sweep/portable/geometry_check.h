// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Whether neighbors spread over a surface, or are on a line.

#pragma once

#include <algorithm>
#include <tuple>

namespace pcl::kernels {

/** \brief Whether offsets from a point spread over a surface: false if they all lie
 * within 1/1000 of the longest one's length from that one's line, or are all 0. Of
 * equally long ones the coordinates decide, not the order that they come in.
 *
 * \tparam Offsets of members dx, dy, dz and d2 = dx^2 + dy^2 + dz^2
 */
template <typename Offsets>
bool
spansSurface(const Offsets& offsets)
{
  const auto longest = std::max_element(
      offsets.begin(), offsets.end(), [](const auto& a, const auto& b) {
        return std::tie(a.d2, a.dx, a.dy, a.dz) < std::tie(b.d2, b.dx, b.dy, b.dz);
      });
  if (longest == offsets.end())
    return false;
  const double x = longest->dx, y = longest->dy, z = longest->dz;
  const double length2 = x * x + y * y + z * z;
  constexpr double tolerance2 = 1e-6; // squared
  return std::any_of(offsets.begin(), offsets.end(), [&](const auto& d) {
    const double cx = y * d.dz - z * d.dy;
    const double cy = z * d.dx - x * d.dz;
    const double cz = x * d.dy - y * d.dx;
    return cx * cx + cy * cy + cz * cz > tolerance2 * length2 * length2;
  });
}

} // namespace pcl::kernels
