// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// The pipeline as a user of PCL writes it.

#include "common/pcl_inad.h"
#include "pipeline.h"

#include <pcl/features/normal_3d_omp.h>
#include <pcl/search/kdtree.h>

#include <algorithm>
#include <cmath>

namespace {

using Tree = pcl::search::KdTree<pcl::PointXYZ>;

std::size_t
binOf(float value)
{
  return static_cast<std::size_t>(value * static_cast<float>(bins / M_PI_2));
}

std::vector<float>
backProject(const std::vector<float>& mu,
            const std::vector<float>& sigma,
            bool own_histogram,
            int threads)
{
  std::vector<float> counts(bins * bins, 0.0f);
  const auto binAt = [&](std::size_t i) {
    return binOf(mu[i]) * bins + binOf(sigma[i]);
  };
  counts[0] = own_histogram ? 0.0f : 1.0f;
  for (std::size_t i = 0; own_histogram && i < mu.size(); ++i)
    if (!std::isnan(mu[i]) && binAt(i) < counts.size())
      ++counts[binAt(i)];
  const float peak = *std::max_element(counts.begin(), counts.end());
  std::vector<float> likelihood(mu.size());
#pragma omp parallel for num_threads(threads)
  for (std::size_t i = 0; i < mu.size(); ++i) {
    likelihood[i] = std::isnan(mu[i])          ? mu[i]
                    : binAt(i) < counts.size() ? counts[binAt(i)] / peak
                                               : 0.0f;
  }
  return likelihood;
}

} // namespace

PipelineResult
runPcl(const Pipeline& pipeline, const Cloud::ConstPtr& cloud, bool sorted, int threads)
{
  const Tree::Ptr tree(new Tree(sorted));
  pcl::NormalEstimationOMP<pcl::PointXYZ, pcl::Normal> estimation(
      static_cast<unsigned>(threads));
  Normals normals;
  estimation.setInputCloud(cloud);
  estimation.setSearchMethod(tree);
  estimation.setRadiusSearch(pipeline.normal_radius);
  estimation.compute(normals);

  PipelineResult result;
  std::uint64_t neighbors = 0;
  for (const double radius : pipeline.inad_radii) {
    std::vector<float> mu(cloud->size());
    std::vector<float> sigma(cloud->size());
#pragma omp parallel for schedule(dynamic, 256) num_threads(threads)                   \
    reduction(+ : neighbors)
    for (std::ptrdiff_t i = 0; i < static_cast<std::ptrdiff_t>(cloud->size()); ++i) {
      pcl::Indices found;
      std::vector<float> squared_distances;
      const auto point = static_cast<pcl::index_t>(i);
      tree->radiusSearch(point, radius, found, squared_distances);
      neighbors += found.size() - 1;
      const MeanAndDeviation inad = inadAt(normals, found, point);
      mu[i] = inad.mean;
      sigma[i] = inad.deviation;
    }
    result.likelihood.push_back(
        backProject(mu, sigma, pipeline.own_histogram, threads));
    result.mu.push_back(std::move(mu));
    result.sigma.push_back(std::move(sigma));
  }
  result.neighbors = neighbors;
  return result;
}
