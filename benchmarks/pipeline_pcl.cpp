/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * Point Cloud Library (PCL) - www.pointclouds.org
 * Copyright (c) 2026, pcl_shape contributors
 *
 * All rights reserved
 */

#include "pipeline.h"

#include <pcl/common/point_tests.h>
#include <pcl/features/normal_3d_omp.h>
#include <pcl/search/kdtree.h>

#include <algorithm>
#include <cmath>

namespace {

using Normals = pcl::PointCloud<pcl::Normal>;
using Tree = pcl::search::KdTree<pcl::PointXYZ>;

struct Moments {
  float mean, deviation;
};

Moments
momentsOf(const std::vector<float>& angles)
{
  float sum = 0.0f;
  for (const float a : angles) {
    sum += a;
  }
  const float mean = sum / static_cast<float>(angles.size());
  float squares = 0.0f;
  for (const float a : angles) {
    squares += (a - mean) * (a - mean);
  }
  return {mean, std::sqrt(squares / static_cast<float>(angles.size()))};
}

Moments
inadAt(const Normals& normals, const pcl::Indices& found, pcl::index_t point)
{
  std::vector<float> angles;
  angles.reserve(found.size());
  const Eigen::Vector3f own = normals[point].getNormalVector3fMap();
  for (const pcl::index_t j : found) {
    const float cosine = std::abs(own.dot(normals[j].getNormalVector3fMap()));
    if (j != point && std::isfinite(cosine)) {
      angles.push_back(std::acos(std::min(cosine, 1.0f)));
    }
  }
  constexpr std::size_t least = 5;
  if (!std::isfinite(own.x()) || angles.size() < least) {
    const float nan = std::numeric_limits<float>::quiet_NaN();
    return {nan, nan};
  }
  const Moments all = momentsOf(angles);
  const auto limit = static_cast<float>(outlier_rate) * all.deviation * (1.0f + 1e-5f);
  const auto rejected = std::remove_if(angles.begin(), angles.end(), [&](float a) {
    return std::abs(a - all.mean) > limit;
  });
  angles.erase(rejected, angles.end());
  return angles.empty() ? all : momentsOf(angles);
}

std::size_t
binOf(float value)
{
  return static_cast<std::size_t>(value * static_cast<float>(bins / M_PI_2));
}

std::vector<float>
backProject(const std::vector<float>& mu, const std::vector<float>& sigma)
{
  std::vector<float> counts(bins * bins, 0.0f);
  const auto binAt = [&](std::size_t i) {
    return binOf(mu[i]) * bins + binOf(sigma[i]);
  };
  for (std::size_t i = 0; i < mu.size(); ++i) {
    if (!std::isnan(mu[i]) && binAt(i) < counts.size()) {
      ++counts[binAt(i)];
    }
  }
  const float peak = *std::max_element(counts.begin(), counts.end());
  std::vector<float> likelihood(mu.size());
  for (std::size_t i = 0; i < mu.size(); ++i) {
    likelihood[i] = std::isnan(mu[i])          ? mu[i]
                    : binAt(i) < counts.size() ? counts[binAt(i)] / peak
                                               : 0.0f;
  }
  return likelihood;
}

} // namespace

PipelineResult
runPcl(const Cloud::ConstPtr& cloud, bool sorted, int threads)
{
  const Tree::Ptr tree(new Tree(sorted));
  pcl::NormalEstimationOMP<pcl::PointXYZ, pcl::Normal> estimation(
      static_cast<unsigned>(threads));
  Normals normals;
  estimation.setInputCloud(cloud);
  estimation.setSearchMethod(tree);
  estimation.setRadiusSearch(normal_radius);
  estimation.compute(normals);

  PipelineResult result;
  std::uint64_t neighbors = 0;
  for (std::size_t r = 0; r < inad_radii.size(); ++r) {
    auto& mu = result.mu[r];
    auto& sigma = result.sigma[r];
    mu.resize(cloud->size());
    sigma.resize(cloud->size());
#pragma omp parallel for schedule(dynamic, 256) num_threads(threads)                     \
    reduction(+ : neighbors)
    for (std::ptrdiff_t i = 0; i < static_cast<std::ptrdiff_t>(cloud->size()); ++i) {
      pcl::Indices found;
      std::vector<float> squared_distances;
      const auto point = static_cast<pcl::index_t>(i);
      tree->radiusSearch(point, inad_radii[r], found, squared_distances);
      neighbors += found.size() - 1;
      const Moments inad = inadAt(normals, found, point);
      mu[i] = inad.mean;
      sigma[i] = inad.deviation;
    }
    result.likelihood[r] = backProject(mu, sigma);
  }
  result.neighbors = neighbors;
  return result;
}
