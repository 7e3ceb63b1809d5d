// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// The pipeline with this library, its neighbors and its memory.

#include "common/pcl_inad.h"
#include "pipeline.h"
#include "support/heap_count.h"

#include <pcl/features/inad.h>
#include <pcl/features/neighborhood_sweep.h>
#include <pcl/features/normal_3d_sweep.h>
#include <pcl/features/shape_model.h>

#include <algorithm>
#include <numeric>
#include <stdexcept>

namespace {

using Inad = pcl::PointCloud<pcl::INAD>;

template <typename Estimate>
void
runEstimations(const Pipeline& pipeline,
               const Cloud::ConstPtr& cloud,
               unsigned threads,
               const Estimate& estimate)
{
  const auto index = std::make_shared<pcl::SweepIndex>();
  pcl::NormalEstimationSweep<pcl::PointXYZ, pcl::Normal> estimation(threads);
  estimation.setSweepIndex(index);
  const auto normals = pcl::make_shared<Normals>();
  estimation.setInputCloud(cloud);
  estimation.setRadiusSearch(pipeline.normal_radius);
  estimate(estimation, *normals);

  pcl::INADEstimation<pcl::PointXYZ, pcl::Normal> inad_estimation(threads);
  inad_estimation.setSweepIndex(index);
  inad_estimation.setInputCloud(cloud);
  inad_estimation.setInputNormals(normals);
  inad_estimation.setOutlierRate(outlier_rate);
  for (const double radius : pipeline.inad_radii) {
    Inad inad;
    inad_estimation.setRadiusSearch(radius);
    estimate(inad_estimation, inad);
  }
}

pcl::ShapeHistogram
histogramOf(const Inad& inad, bool own_histogram, unsigned threads)
{
  if (!own_histogram)
    return pcl::ShapeModel::idealPlane({}, bins).classes().front().histogram;
  pcl::ShapeHistogram histogram(bins, bins);
  histogram.add(inad, threads);
  return histogram;
}

void
backProject(Inad& inad, bool own_histogram, unsigned threads, PipelineResult& result)
{
  const pcl::ShapeHistogram histogram = histogramOf(inad, own_histogram, threads);
  result.likelihood.push_back(histogram.backProject(inad, threads));
  result.inad.push_back(std::move(inad));
}

} // namespace

Pipeline
Pipeline::of(const std::string& task, double scale)
{
  if (task == "pipeline")
    return {0.010 * scale, {0.006 * scale, 0.020 * scale}, true};
  if (task != "edges" && task != "surfaces")
    throw std::invalid_argument(task + ": pipeline, edges or surfaces is expected");
  const auto radii =
      task == "edges" ? pcl::INADParameters::edges() : pcl::INADParameters::surfaces();
  return {radii.normal_radius * scale, {radii.radius * scale}, false};
}

PipelineResult
runShape(const Pipeline& pipeline, const Cloud::ConstPtr& cloud, unsigned threads)
{
  PipelineResult result;
  runEstimations(pipeline, cloud, threads, [&](auto& estimation, auto& output) {
    estimation.compute(output);
    if constexpr (std::is_same_v<std::decay_t<decltype(output)>, Inad>)
      backProject(output, pipeline.own_histogram, threads, result);
  });
  return result;
}

void
splitINAD(PipelineResult& result)
{
  for (const Inad& inad : result.inad) {
    std::vector<float> mu, sigma;
    for (const pcl::INAD& value : inad) {
      mu.push_back(value.mu);
      sigma.push_back(value.sigma);
    }
    result.mu.push_back(std::move(mu));
    result.sigma.push_back(std::move(sigma));
  }
}

std::uint64_t
countShapeNeighbors(const Pipeline& pipeline, const Cloud& cloud, unsigned threads)
{
  pcl::NeighborhoodSweep sweep(
      {&cloud[0].x, sizeof(cloud[0]) / sizeof(float), cloud.size()});
  sweep.setNumberOfThreads(threads);
  std::vector<std::uint32_t> counts(cloud.size());
  std::uint64_t total = 0;
  for (const double radius : pipeline.inad_radii) {
    sweep.countNeighbors(pcl::NeighborhoodSize::ofRadius(radius), counts.data());
    total = std::accumulate(counts.begin(), counts.end(), total);
  }
  return total;
}

double
maxExtraBytes(const Pipeline& pipeline, const Cloud::ConstPtr& cloud, unsigned threads)
{
  std::ptrdiff_t bytes = 0;
  runEstimations(pipeline, cloud, threads, [&](auto& estimation, auto& output) {
    const pcl::test::HeapCount count; // not of the output: Eigen allocates that
    estimation.compute(output);
    bytes = std::max(bytes, count.peak());
  });
  return static_cast<double>(bytes) / static_cast<double>(cloud->size());
}
