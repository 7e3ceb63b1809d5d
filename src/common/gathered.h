// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Values and positions of some points among others.

#pragma once

#include <pcl/features/xyz_view.h>

#include <cstddef>
#include <type_traits>
#include <vector>

namespace pcl::detail {

/** \brief The values at these indices. */
template <typename T, typename Index>
std::vector<T>
gathered(const std::vector<T>& values, const std::vector<Index>& indices)
{
  std::vector<T> result;
  result.reserve(indices.size());
  for (const Index i : indices)
    result.push_back(values[static_cast<std::size_t>(i)]);
  return result;
}

/** \brief The same, and `unknown` where an index is negative: of what type it is the
 * values alone say, so common_type_t keeps it from being deduced. */
template <typename T, typename Index>
std::vector<T>
gathered(const std::vector<T>& values,
         const std::vector<Index>& indices,
         const std::common_type_t<T>& unknown)
{
  std::vector<T> result;
  result.reserve(indices.size());
  for (const Index i : indices)
    result.push_back(i < 0 ? unknown : values[static_cast<std::size_t>(i)]);
  return result;
}

/** \brief The coordinates of the points at these indices, three each. */
template <typename Index>
std::vector<float>
positionsAt(const XYZView& points, const std::vector<Index>& indices)
{
  std::vector<float> positions;
  positions.reserve(3 * indices.size());
  for (const Index i : indices) {
    const float* const p = points[static_cast<std::size_t>(i)];
    positions.insert(positions.end(), p, p + 3);
  }
  return positions;
}

/** \brief The view of coordinates, three for each point. */
inline XYZView
viewOfPositions(const std::vector<float>& positions)
{
  return {positions.data(), 3, positions.size() / 3};
}

} // namespace pcl::detail
