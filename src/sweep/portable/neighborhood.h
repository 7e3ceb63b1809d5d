// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Normal and INAD of one query, from a list of its neighbors.

#pragma once

#include "sweep/index/row_index.h"
#include "sweep/portable/angle.h"

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
