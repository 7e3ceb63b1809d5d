// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// A plane with noise that neighbors share.

#pragma once

#include "support/random.h"
#include "support/shapes.h"

#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

#include <Eigen/Core>

#include <cmath>
#include <vector>

namespace pcl::test {

/** \brief A plane with waves (noise that neighbors share) and some bumps.
 * \param[in] height of the bumps, in spacings of 2 mm */
inline PointCloud<PointXYZ>::Ptr
bumpyPlane(double height)
{
  constexpr int count = 200, bumps = 150;
  constexpr double spacing = 0.002; // meters
  constexpr double wave = 0.1;      // spacings
  Random random(72);
  std::vector<Eigen::Vector3d> points; // in spacings
  for (int i = 0; i < count; ++i)
    for (int j = 0; j < count; ++j)
      points.emplace_back(i + random.uniform(-0.2, 0.2),
                          j + random.uniform(-0.2, 0.2),
                          wave * std::sin(i * pi / 6.0) * std::sin(j * pi / 6.0));
  for (int bump = 0; bump < bumps; ++bump) {
    const double x = random.uniform(0, count), y = random.uniform(0, count);
    for (Eigen::Vector3d& p : points)
      p.z() +=
          height * std::exp(-0.5 * (std::pow(p.x() - x, 2) + std::pow(p.y() - y, 2)));
  }
  const auto cloud = make_shared<PointCloud<PointXYZ>>();
  for (const Eigen::Vector3d& p : points) {
    const Eigen::Vector3f q = (spacing * p).cast<float>();
    cloud->emplace_back(q.x(), q.y(), 0.6f + q.z());
  }
  return cloud;
}

} // namespace pcl::test
