// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// PURPOSE

#pragma once

#include "sweep/index/row_index.h"
#include "sweep/portable/angle.h"
#include "sweep/sweep_block.h"

#include <pcl/features/neighborhood_sweep.h>

#include <cmath>
#include <cstdint>
#include <vector>

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

/** \brief In radians. */
INADResult toINAD(const Spread& spread);

/** \brief NaN for a normal that is not finite or of length 0. */
UnitNormal normalized(const float* normal);

/** \brief As normalized(); a normal that floats cannot bring nearer to length 1 as it
 * is. */
inline UnitNormal
unitNormal(const float* normal)
{
  const double x = normal[0], y = normal[1], z = normal[2];
  const bool is_unit = std::abs(x * x + y * y + z * z - 1.0) < 2.5e-7;
  return is_unit ? UnitNormal{normal[0], normal[1], normal[2]} : normalized(normal);
}

/** \brief The normals of points order[0], order[1], ...; of all points if order is
 * null. */
UnitNormals
unitNormals(const XYZView& normals, const RowIndex* surface, unsigned threads);

/** \brief Whether a neighbor is at the query's position. */
bool anyAtQuery(const Neighbors& neighbors);

/** \param[in] contains_itself the query's own point is one of the neighbors */
NormalResult normalOf(const Neighbors& neighbors, bool contains_itself);

/** \param[in] own the query's normal
 * \param[in] contains_itself the query's own point is one of the neighbors, and left
 * out
 */
INADResult inadOf(const Neighbors& neighbors,
                  const UnitNormal& own,
                  const float* const normals[3],
                  bool contains_itself,
                  double outlier_rate);

} // namespace pcl::kernels
