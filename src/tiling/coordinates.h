// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Coordinates as they are kept on disk: in single precision if that loses nothing.

#pragma once

#include <pcl/tiling/point_source.h>

#include <array>

namespace pcl::tiling {

/** \brief Whether floats hold a place exactly. Those of most sensors do, and take half
 * of the bytes. */
inline bool
areFloats(const Position& p)
{
  const auto isFloat = [](double c) {
    return static_cast<double>(static_cast<float>(c)) == c;
  };
  return isFloat(p[0]) && isFloat(p[1]) && isFloat(p[2]);
}

template <typename Coordinate>
std::array<Coordinate, 3>
coordinatesAs(const Position& p)
{
  return {static_cast<Coordinate>(p[0]),
          static_cast<Coordinate>(p[1]),
          static_cast<Coordinate>(p[2])};
}

template <typename Coordinate>
Position
positionOf(const std::array<Coordinate, 3>& c)
{
  return {c[0], c[1], c[2]};
}

} // namespace pcl::tiling
