// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Viridis for numbers, Glasbey's colors for labels.

#include "viewer/color.h"

#include <pcl/common/colors.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace pcl::app {
namespace {

std::vector<Color>
colorsSeenOnWhite()
{
  constexpr int lightest = 3 * 200, darkest = 3 * 30; // sums of the channels
  std::vector<Color> seen;
  for (std::size_t i = 0; i < pcl::GlasbeyLUT::size(); ++i) {
    const pcl::RGB color = pcl::GlasbeyLUT::at(i);
    const int sum = color.r + color.g + color.b;
    if (sum >= darkest && sum <= lightest)
      seen.push_back({color.r, color.g, color.b});
  }
  return seen;
}

} // namespace

Color
viridis(double share)
{
  const auto last = static_cast<double>(pcl::ViridisLUT::size() - 1);
  const double position = std::clamp(share, 0.0, 1.0) * last;
  const pcl::RGB color =
      pcl::ViridisLUT::at(static_cast<std::size_t>(std::lround(position)));
  return {color.r, color.g, color.b};
}

Color
distinctColor(std::size_t position)
{
  static const std::vector<Color> seen = colorsSeenOnWhite();
  return seen[position % seen.size()];
}

} // namespace pcl::app
