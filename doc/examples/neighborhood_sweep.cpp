/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * Point Cloud Library (PCL) - www.pointclouds.org
 * Copyright (c) 2026, pcl_shape contributors
 *
 * All rights reserved
 */

#include <pcl/features/neighborhood_sweep.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <vector>

// The engine on plain arrays, without point clouds: a wavy surface, with a radius of
// its own for each point.
int
main()
{
  std::vector<float> xyz; // meters
  for (int i = 0; i < 200; ++i) {
    for (int j = 0; j < 200; ++j) {
      const float x = 0.002f * static_cast<float>(i);
      const float y = 0.002f * static_cast<float>(j);
      xyz.insert(xyz.end(), {x, y, 0.02f * std::sin(30.0f * x)});
    }
  }
  const std::size_t size = xyz.size() / 3;

  // [sweep]
  pcl::NeighborhoodSweep sweep({xyz.data(), 3, size});
  std::vector<float> radii(size);
  sweep.computeDistanceToNearest(12, radii.data()); // about two point distances
  for (float& radius : radii)
    radius *= 3.0f;
  const auto neighborhood = pcl::NeighborhoodSize::ofRadii(radii.data());

  std::vector<float> normals(3 * size);
  std::vector<float> curvature(3 * size); // one value every three, as the normals
  sweep.computeNormals(neighborhood, normals.data(), curvature.data(), 3);

  std::vector<float> mu_sigma(2 * size);
  sweep.computeINAD(neighborhood, {normals.data(), 3, size}, 2.0, mu_sigma.data());
  // [sweep]

  float largest = 0.0f;
  for (std::size_t i = 0; i < size; ++i)
    largest = std::max(largest, mu_sigma[2 * i]);
  std::cout << "largest mean angle " << largest << " rad\n";
  return largest > 0.0f ? 0 : 1;
}
