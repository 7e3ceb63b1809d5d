// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// This library's ground, RANSAC's plane and PCL's morphological filter.

#include "methods.h"

#include "scene/sensors/lidar.h"

#include <pcl/segmentation/progressive_morphological_filter.h>
#include <pcl/segmentation/sac_segmentation.h>
#include <pcl/segmentation/shape_ground_segmentation.h>

#include <sstream>

namespace ground {
namespace {

std::string
textOf(std::initializer_list<std::pair<const char*, double>> parameters)
{
  std::ostringstream text;
  for (const auto& [name, value] : parameters)
    text << (text.tellp() > 0 ? ", " : "") << name << ' ' << value;
  return text.str();
}

Setting
planeSetting(double distance, bool is_level, unsigned threads)
{
  constexpr double most_angle = 0.35; // as ours: 20 degrees
  const auto find = [=](const Cloud::ConstPtr& cloud) {
    pcl::SACSegmentation<pcl::PointXYZ> plane;
    plane.setModelType(is_level ? pcl::SACMODEL_PERPENDICULAR_PLANE
                                : pcl::SACMODEL_PLANE);
    plane.setAxis(Eigen::Vector3f::UnitZ());
    plane.setEpsAngle(most_angle);
    plane.setMethodType(pcl::SAC_RANSAC);
    plane.setDistanceThreshold(distance);
    plane.setOptimizeCoefficients(false);
    plane.setNumberOfThreads(threads > 1 ? static_cast<int>(threads) : -1);
    plane.setInputCloud(cloud);
    pcl::PointIndices inliers;
    pcl::ModelCoefficients coefficients;
    plane.segment(inliers, coefficients);
    return inliers.indices;
  };
  return {textOf({{"distance", distance}}) + (is_level ? " m, level" : " m"), find};
}

Setting
morphologicalSetting(double cell, double slope, double initial, double most)
{
  constexpr double window = 5.0; // meters: wider than a car
  const auto find = [=](const Cloud::ConstPtr& cloud) {
    pcl::ProgressiveMorphologicalFilter<pcl::PointXYZ> filter;
    filter.setCellSize(static_cast<float>(cell));
    filter.setMaxWindowSize(static_cast<int>(window));
    filter.setSlope(static_cast<float>(slope));
    filter.setInitialDistance(static_cast<float>(initial));
    filter.setMaxDistance(static_cast<float>(most));
    filter.setExponential(true);
    filter.setInputCloud(cloud);
    pcl::Indices found;
    filter.extract(found);
    return found;
  };
  return {textOf({{"cell", cell},
                  {"slope", slope},
                  {"initial distance", initial},
                  {"largest distance", most},
                  {"window", window}}),
          find};
}

} // namespace

Street
generateStreet(unsigned beams, std::uint64_t seed)
{
  pcl::scene::LidarOptions options;
  options.beams = beams;
  options.seed = seed;
  const pcl::scene::LidarScan scan = pcl::scene::scanStreet(options);
  Street street{beams, seed, pcl::make_shared<Cloud>(), scan.ground};
  for (std::size_t i = 0; i < scan.size(); ++i)
    street.points->emplace_back(
        scan.xyz[3 * i], scan.xyz[3 * i + 1], scan.xyz[3 * i + 2]);
  return street;
}

Method
ownMethod(unsigned threads)
{
  const auto find = [=](const Cloud::ConstPtr& cloud) {
    pcl::ShapeGroundSegmentation<pcl::PointXYZ> segmentation;
    segmentation.setNumberOfThreads(threads);
    segmentation.setInputCloud(cloud);
    pcl::PointIndices found;
    segmentation.segment(found);
    return found.indices;
  };
  return {"ShapeGroundSegmentation", {{"no setting", find}}};
}

Method
planeMethod(unsigned threads)
{
  Method method{"SACSegmentation", {}};
  for (const bool is_level : {false, true})
    for (const double distance : {0.05, 0.1, 0.15, 0.2, 0.25, 0.3, 0.4})
      method.settings.push_back(planeSetting(distance, is_level, threads));
  return method;
}

Method
morphologicalMethod()
{
  Method method{"ProgressiveMorphologicalFilter", {}};
  for (const double cell : {0.5, 1.0})
    for (const double initial : {0.1, 0.2})
      for (const double most : {0.2, 0.5})
        method.settings.push_back(morphologicalSetting(cell, 0.3, initial, most));
  return method;
}

Score
scoreOf(const Street& street, const pcl::Indices& found)
{
  std::vector<char> is_found(street.truth.size(), 0);
  for (const pcl::index_t index : found)
    is_found[static_cast<std::size_t>(index)] = 1;
  double right = 0.0, wrong = 0.0, missed = 0.0;
  for (std::size_t i = 0; i < is_found.size(); ++i) {
    right += is_found[i] && street.truth[i] == 1;
    wrong += is_found[i] && street.truth[i] == 0;
    missed += !is_found[i] && street.truth[i] == 1;
  }
  return {2.0 * right / (2.0 * right + wrong + missed),
          right / (right + wrong),
          right / (right + missed)};
}

} // namespace ground
