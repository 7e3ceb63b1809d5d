// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Reads or generates the clouds of the benchmarks.

#include "clouds.h"

#include "scene/scene.h"

#include <pcl/filters/filter.h>
#include <pcl/io/pcd_io.h>

#include <cmath>
#include <random>
#include <stdexcept>

Cloud::Ptr
sceneCloud()
{
  const pcl::scene::Scene scene = pcl::scene::generateScene({});
  const auto cloud = pcl::make_shared<Cloud>(scene.width, scene.height);
  for (std::size_t i = 0; i < cloud->size(); ++i) {
    const float* p = &scene.xyz[3 * i];
    (*cloud)[i] = pcl::PointXYZ(p[0], p[1], p[2]);
  }
  cloud->is_dense = false;
  return cloud;
}

Cloud::Ptr
sheetCloud(std::size_t points)
{
  constexpr double spacing = 0.00165, noise = 0.001;
  constexpr double height = 0.02, wave = 0.4 / (2.0 * M_PI);
  std::mt19937 random(1);
  std::uniform_real_distribution<double> jitter(-0.5 * spacing, 0.5 * spacing);
  std::normal_distribution<double> error(0.0, noise);
  const auto side =
      static_cast<std::size_t>(std::lround(std::sqrt(static_cast<double>(points))));
  const auto cloud = pcl::make_shared<Cloud>();
  cloud->reserve(side * side);
  for (std::size_t i = 0; i < side * side; ++i) {
    const double x = static_cast<double>(i % side) * spacing + jitter(random);
    const double y = static_cast<double>(i / side) * spacing + jitter(random);
    const double z = height * std::sin(x / wave) * std::cos(y / wave) + error(random);
    cloud->emplace_back(
        static_cast<float>(x), static_cast<float>(y), static_cast<float>(z));
  }
  return cloud;
}

Cloud::Ptr
cloudOf(const Options& options)
{
  if (options.generate == "laser")
    return laserCloud();
  if (options.generate == "sheet") {
    constexpr std::size_t points = 200000;
    return sheetCloud(points);
  }
  if (options.cloud.empty() || !options.generate.empty()) {
    if (options.generate.empty() || options.generate == "scene")
      return sceneCloud();
    throw std::invalid_argument(options.generate +
                                ": scene, sheet or laser is expected");
  }
  const auto cloud = pcl::make_shared<Cloud>();
  if (pcl::io::loadPCDFile(options.cloud, *cloud) != 0)
    throw std::runtime_error(options.cloud + ": cannot be read as a PCD file");
  return cloud;
}

Cloud::Ptr
finiteCloudOf(const Options& options)
{
  const Cloud::Ptr cloud = cloudOf(options);
  pcl::Indices kept;
  pcl::removeNaNFromPointCloud(*cloud, *cloud, kept);
  if (options.shuffle)
    std::shuffle(cloud->begin(), cloud->end(), std::mt19937(1));
  return cloud;
}
