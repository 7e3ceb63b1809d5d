// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// The colors of what is drawn.

#pragma once

#include <cstddef>
#include <cstdint>

namespace pcl::app {

struct Color {
  std::uint8_t r, g, b;

  friend bool
  operator==(const Color& a, const Color& b)
  {
    return a.r == b.r && a.g == b.g && a.b == b.b;
  }
};

namespace colors {
constexpr Color unknown{150, 150, 150};
constexpr Color plain{205, 205, 205};
constexpr Color blue{70, 120, 205};
constexpr Color orange{240, 140, 30};
constexpr Color crimson{205, 20, 55};
constexpr Color green{35, 155, 75};
constexpr Color violet{130, 60, 190};
constexpr Color dark{95, 95, 95};
} // namespace colors

/** \brief Matplotlib's Viridis from blue (0) over green to yellow (1). */
Color viridis(double share);

/** \brief Colors that differ as much as can be, of those that are seen on white. */
Color distinctColor(std::size_t position);

} // namespace pcl::app
