// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Normal and INAD of one query, from its neighbors; checks of these and of the input.

#pragma once

#include "sweep/index/row_index.h"
#include "sweep/portable/angle.h"

#include <algorithm>
#include <tuple>

namespace pcl::kernels {

/** \brief A neighbor as seen from the query. */
struct Neighbor {
  float dx, dy, dz, d2;
  std::uint32_t position; ///< of the surface point
};

using Neighbors = std::vector<Neighbor>;

/** \brief The surface point at `position`, seen from a query. */
inline Neighbor
neighborAt(const float* surface_point, const float* query, std::uint32_t position)
{
  const float dx = surface_point[0] - query[0];
  const float dy = surface_point[1] - query[1];
  const float dz = surface_point[2] - query[2];
  return {dx, dy, dz, (dx * dx + dy * dy) + dz * dz, position};
}

/** \brief Offsets are counted in 2^-20 of a power of two that is at least as long as
 * each: the products of two, of 40 bits, are exact, and so are sums of millions. */
constexpr int offset_bits = 20;

struct UnitNormal {
  float x, y, z;
};

/** \brief Unit normals as structure of arrays, padded as RowIndex; NaN where one is
 * missing. */
struct UnitNormals {
  RawVector<float> x, y, z;

  UnitNormal
  operator[](std::uint32_t position) const
  {
    return {x[position], y[position], z[position]};
  }
};

/** \brief NaN for a normal that is not finite or of length 0. One that floats cannot
 * bring nearer to length 1 stays as it is. */
UnitNormal unitNormal(const float* normal);

/** \brief The normals of a surface's points in their order; of all if it is null. */
UnitNormals
unitNormals(const XYZView& normals, const RowIndex* surface, unsigned threads);

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

/** \throws std::invalid_argument unless there is a normal for each surface point and
 * the rate is 0 or positive and finite */
void checkINADInput(std::size_t surface, std::size_t normals, double outlier_rate);

/** \brief In radians. */
INADResult toINAD(const Spread& spread);

/** \brief Whether a neighbor is at the query's position. */
bool anyAtQuery(const Neighbors& neighbors);

/** \param[in] contains_itself the query's own point is one of the neighbors */
NormalResult normalOf(const Neighbors& neighbors, bool contains_itself);

/** \param[in] own the query's normal
 * \param[in] contains_itself the query's own point is one of the neighbors: it is left
 * out */
INADResult inadOf(const Neighbors& neighbors,
                  const UnitNormal& own,
                  const float* const normals[3],
                  bool contains_itself,
                  double outlier_rate);

} // namespace pcl::kernels
