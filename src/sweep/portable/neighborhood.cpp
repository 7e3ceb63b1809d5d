// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Normal and INAD of one query, from a list of its neighbors.

#include "sweep/portable/neighborhood.h"

#include "common/number_text.h"
#include "common/parallel.h"
#include "sweep/index/row_index.h"
#include "sweep/portable/angle.h"
#include "sweep/portable/symmetric_eigen.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace pcl::kernels {
namespace {

constexpr std::size_t min_neighbors = NeighborhoodSweep::min_neighbors;

/** \brief What offsets are multiplied by to become integers of offset_bits, fewer
 * if there are so many that sums of their squares would not fit in 63 bits. */
double
integerScale(const Neighbors& neighbors)
{
  float longest = 0.0f;
  for (const Neighbor& n : neighbors)
    longest = std::max(longest, n.d2);
  int exponent = 0;
  std::frexp(std::sqrt(longest), &exponent);
  int bits = offset_bits;
  for (std::size_t n = neighbors.size() >> 22; n > 0; n >>= 2)
    --bits;
  return std::ldexp(1.0, bits - exponent);
}

/** \brief Covariance of the neighbors' offsets from the query, from exact sums of
 * integers: the order of the neighbors does not matter. */
Symmetric3
covarianceOf(const Neighbors& neighbors)
{
  const double scale = integerScale(neighbors);
  std::int64_t sx = 0, sy = 0, sz = 0, xx = 0, xy = 0, xz = 0, yy = 0, yz = 0, zz = 0;
  for (const Neighbor& n : neighbors) {
    const auto dx = static_cast<std::int64_t>(std::lrint(n.dx * scale));
    const auto dy = static_cast<std::int64_t>(std::lrint(n.dy * scale));
    const auto dz = static_cast<std::int64_t>(std::lrint(n.dz * scale));
    sx += dx, sy += dy, sz += dz;
    xx += dx * dx, xy += dx * dy, xz += dx * dz;
    yy += dy * dy, yz += dy * dz, zz += dz * dz;
  }
  const auto count = static_cast<std::int64_t>(neighbors.size());
  const double m = 1.0 / static_cast<double>(count);
  // Exact until here: points that are all at one place have no variance.
  const auto central = [=](std::int64_t ab, std::int64_t a, std::int64_t b) {
    return m * m * static_cast<double>(SignedWide{count} * ab - SignedWide{a} * b);
  };
  return {central(xx, sx, sx),
          central(xy, sx, sy),
          central(xz, sx, sz),
          central(yy, sy, sy),
          central(yz, sy, sz),
          central(zz, sz, sz)};
}

/** \brief The angles to all neighbors with a normal, in units; the query's own is left
 * out. */
void
collectAngles(const Neighbors& neighbors,
              const UnitNormal& own,
              const float* const normals[3],
              bool contains_itself,
              std::vector<std::uint32_t>& angles)
{
  angles.clear();
  bool skip_itself = contains_itself;
  for (const Neighbor& n : neighbors) {
    const UnitNormal other{
        normals[0][n.position], normals[1][n.position], normals[2][n.position]};
    if (std::isnan(other.x))
      continue;
    const float chord = squaredChord(own.x, own.y, own.z, other.x, other.y, other.z);
    const std::uint32_t angle = toUnits(angleOfChord(chord));
    if (skip_itself && n.d2 == 0.0f && angle == 0) {
      skip_itself = false;
      continue;
    }
    angles.push_back(angle);
  }
}

AngleSums
sumIf(const std::vector<std::uint32_t>& angles, const KeptRange& range)
{
  AngleSums sums;
  for (std::size_t i = 0; i < angles.size();) {
    const std::size_t end = std::min<std::size_t>(angles.size(), i + max_for_64_bits);
    std::uint64_t squares = 0;
    for (; i < end; ++i) {
      const std::uint64_t angle = range.contains(angles[i]) ? angles[i] : 0;
      sums.count += range.contains(angles[i]) ? 1 : 0;
      sums.sum += angle;
      squares += angle * angle;
    }
    sums.squares += squares;
  }
  return sums;
}

} // namespace

void
checkINADInput(std::size_t surface, std::size_t normals, double outlier_rate)
{
  if (normals != surface) {
    throw std::invalid_argument(std::to_string(normals) + " normals for " +
                                std::to_string(surface) + " surface points");
  }
  if (!(outlier_rate >= 0.0) || !std::isfinite(outlier_rate)) {
    throw std::invalid_argument("outlier rate " + detail::numberText(outlier_rate) +
                                ": it must be 0 (no rejection) or positive");
  }
}

INADResult
toINAD(const Spread& spread)
{
  return {static_cast<float>(spread.mean / units_per_radian),
          static_cast<float>(spread.sd / units_per_radian)};
}

UnitNormal
unitNormal(const float* normal)
{
  const double x = normal[0], y = normal[1], z = normal[2];
  const double squared_length = x * x + y * y + z * z;
  if (std::abs(squared_length - 1.0) < 2.5e-7)
    return {normal[0], normal[1], normal[2]};
  const double length = std::sqrt(squared_length);
  if (!(length > 0.0) || !std::isfinite(length))
    return {nan, nan, nan};
  return {static_cast<float>(x / length),
          static_cast<float>(y / length),
          static_cast<float>(z / length)};
}

UnitNormals
unitNormals(const XYZView& normals, const RowIndex* surface, unsigned threads)
{
  const std::size_t count = surface ? surface->size() : normals.size;
  UnitNormals unit;
  for (auto* array : {&unit.x, &unit.y, &unit.z})
    resizePadded(*array, count);
  parallelForRanges(count, threads, [&](std::size_t begin, std::size_t end) {
    const auto normalAt = [&](std::size_t i) {
      return normals[surface ? surface->order[i] : i];
    };
    forEachPoint(begin, end, normalAt, [&](std::size_t i, const float* normal) {
      const UnitNormal n = unitNormal(normal);
      unit.x[i] = n.x;
      unit.y[i] = n.y;
      unit.z[i] = n.z;
    });
  });
  return unit;
}

bool
anyAtQuery(const Neighbors& neighbors)
{
  return std::any_of(neighbors.begin(), neighbors.end(), [](const Neighbor& n) {
    return n.d2 == 0.0f;
  });
}

NormalResult
normalOf(const Neighbors& neighbors, bool contains_itself)
{
  const std::size_t others = neighbors.size() - (contains_itself ? 1 : 0);
  return others < min_neighbors ? unknown_normal
                                : normalOfCovariance(covarianceOf(neighbors));
}

INADResult
inadOf(const Neighbors& neighbors,
       const UnitNormal& own,
       const float* const normals[3],
       bool contains_itself,
       double outlier_rate)
{
  if (std::isnan(own.x))
    return unknown_inad;
  thread_local std::vector<std::uint32_t> angles;
  collectAngles(neighbors, own, normals, contains_itself, angles);
  if (angles.size() < min_neighbors || !spansSurface(neighbors))
    return unknown_inad;
  const AngleSums all = sumIf(angles, {});
  const AngleSums kept = sumIf(angles, keptRange(all.spread(), outlier_rate));
  return toINAD((kept.count == 0 ? all : kept).spread());
}

} // namespace pcl::kernels
