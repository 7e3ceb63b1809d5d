/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * Point Cloud Library (PCL) - www.pointclouds.org
 * Copyright (c) 2026, pcl_shape contributors
 *
 * All rights reserved
 */

#include "sensor.h"

#include <cmath>

namespace pcl::scene {

Field
boxField(unsigned width, unsigned height, int box_width, int box_height, Random& random)
{
  const std::size_t columns = width, rows = height;
  const auto bw = static_cast<std::size_t>(box_width);
  const auto bh = static_cast<std::size_t>(box_height);
  const std::size_t padded = columns + bw - 1;
  std::vector<double> white(padded * (rows + bh - 1));
  for (auto& value : white)
    value = random.normal();

  std::vector<double> summed(columns * (rows + bh - 1), 0.0);
  for (std::size_t v = 0; v < rows + bh - 1; ++v)
    for (std::size_t u = 0; u < columns; ++u)
      for (std::size_t k = 0; k < bw; ++k)
        summed[v * columns + u] += white[v * padded + u + k];

  const double scale = 1.0 / std::sqrt(static_cast<double>(bw * bh));
  Field field(columns * rows, 0.0);
  for (std::size_t i = 0; i < field.size(); ++i) {
    for (std::size_t k = 0; k < bh; ++k)
      field[i] += summed[i + k * columns];
    field[i] *= scale;
  }
  return field;
}

Field
gridField(unsigned width, unsigned height, double cell, Random& random)
{
  const auto columns = static_cast<std::size_t>(width / cell) + 2;
  const auto rows = static_cast<std::size_t>(height / cell) + 2;
  std::vector<double> grid(columns * rows);
  for (auto& value : grid)
    value = random.normal();

  const auto weight = [](double t) { return t * t * (3.0 - 2.0 * t); };
  Field field;
  field.reserve(std::size_t{width} * height);
  for (unsigned v = 0; v < height; ++v)
    for (unsigned u = 0; u < width; ++u) {
      const double x = u / cell, y = v / cell;
      const auto i = static_cast<std::size_t>(x), j = static_cast<std::size_t>(y);
      const double a = weight(x - static_cast<double>(i));
      const double b = weight(y - static_cast<double>(j));
      const double* corner = &grid[j * columns + i];
      const double upper = (1.0 - a) * corner[0] + a * corner[1];
      const double lower = (1.0 - a) * corner[columns] + a * corner[columns + 1];
      const double variance =
          ((1.0 - a) * (1.0 - a) + a * a) * ((1.0 - b) * (1.0 - b) + b * b);
      field.push_back(((1.0 - b) * upper + b * lower) / std::sqrt(variance));
    }
  return field;
}

} // namespace pcl::scene
