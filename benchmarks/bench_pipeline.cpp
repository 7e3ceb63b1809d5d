/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * Point Cloud Library (PCL) - www.pointclouds.org
 * Copyright (c) 2026, pcl_shape contributors
 *
 * All rights reserved
 */

#include "scene/scene.h"

#include <pcl/features/inad.h>
#include <pcl/features/normal_3d_omp.h>
#include <pcl/features/normal_3d_sweep.h>
#include <pcl/features/shape_model.h>
#include <pcl/filters/filter.h>
#include <pcl/io/pcd_io.h>
#include <pcl/point_types.h>
#include <pcl/search/kdtree.h>

#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <string>

// Normals, INAD and the likelihood of a plane, on one thread: over PCL's search tree as
// its users write it, and over the sweep.
// Usage: bench_pipeline [Google Benchmark's options] [cloud.pcd]
namespace {

using Cloud = pcl::PointCloud<pcl::PointXYZ>;
using Normals = pcl::PointCloud<pcl::Normal>;
using Inad = pcl::PointCloud<pcl::INAD>;
using Tree = pcl::search::KdTree<pcl::PointXYZ>;

constexpr double outlier_rate = 2.0;

Cloud::Ptr
generatedCloud()
{
  const pcl::scene::Scene scene = pcl::scene::generateScene({});
  const auto cloud = pcl::make_shared<Cloud>();
  for (std::size_t i = 0; i < scene.surface.size(); ++i) {
    const float* p = &scene.xyz[3 * i];
    if (std::isfinite(p[2])) {
      cloud->emplace_back(p[0], p[1], p[2]);
    }
  }
  return cloud;
}

Cloud::Ptr
loadedCloud(const std::string& path)
{
  const auto cloud = pcl::make_shared<Cloud>();
  if (pcl::io::loadPCDFile(path, *cloud) != 0) {
    return nullptr;
  }
  pcl::Indices kept;
  pcl::removeNaNFromPointCloud(*cloud, *cloud, kept);
  return cloud;
}

struct MeanAndDeviation {
  double mean = 0.0;
  double deviation = 0.0;
};

MeanAndDeviation
momentsOf(const std::vector<float>& angles)
{
  double sum = 0.0;
  double squares = 0.0;
  for (const double a : angles) {
    sum += a;
    squares += a * a;
  }
  const auto count = static_cast<double>(angles.size());
  const double mean = sum / count;
  return {mean, std::sqrt(std::max(0.0, squares / count - mean * mean))};
}

/** INAD of one point from the angles to its neighbors, which are filtered. */
pcl::INAD
inadOf(std::vector<float>& angles)
{
  const MeanAndDeviation all = momentsOf(angles);
  const double width = outlier_rate * all.deviation * (1.0 + 1e-5);
  const auto is_outlier = [&](float a) { return std::abs(a - all.mean) > width; };
  angles.erase(std::remove_if(angles.begin(), angles.end(), is_outlier), angles.end());
  const MeanAndDeviation kept = angles.empty() ? all : momentsOf(angles);
  return {static_cast<float>(kept.mean), static_cast<float>(kept.deviation)};
}

Inad
inadOverTree(const Cloud& cloud,
             const Normals& normals,
             const Tree& tree,
             double radius)
{
  Inad inad;
  inad.reserve(cloud.size());
  pcl::Indices neighbors;
  std::vector<float> squared_distances;
  std::vector<float> angles;
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    tree.radiusSearch(cloud[i], radius, neighbors, squared_distances);
    const auto n = normals[i].getNormalVector3fMap();
    angles.clear();
    for (const pcl::index_t j : neighbors) {
      if (j != static_cast<pcl::index_t>(i)) {
        const float cosine = std::abs(n.dot(normals[j].getNormalVector3fMap()));
        if (!std::isnan(cosine)) {
          angles.push_back(std::acos(std::min(1.0f, cosine)));
        }
      }
    }
    inad.push_back(angles.size() < 5 ? pcl::INAD{NAN, NAN} : inadOf(angles));
  }
  return inad;
}

std::size_t
planarPoints(const Inad& inad, const pcl::ShapeModel& model)
{
  std::size_t planar = 0;
  for (const pcl::INAD& pair : inad) {
    float likelihood = 0.0f;
    model.evaluate(pair, &likelihood);
    planar += likelihood >= 0.5f;
  }
  return planar;
}

std::size_t
pipelineOfPCL(const Cloud::ConstPtr& cloud,
              const pcl::INADParameters& parameters,
              bool sorted)
{
  const auto tree = pcl::make_shared<Tree>(sorted);
  tree->setInputCloud(cloud);
  pcl::NormalEstimationOMP<pcl::PointXYZ, pcl::Normal> estimation(1);
  estimation.setInputCloud(cloud);
  estimation.setSearchMethod(tree);
  estimation.setRadiusSearch(parameters.normal_radius);
  Normals normals;
  estimation.compute(normals);
  const Inad inad = inadOverTree(*cloud, normals, *tree, parameters.radius);
  return planarPoints(inad, pcl::ShapeModel::idealPlane(parameters));
}

/** \param[in] search null for the sweep */
std::size_t
pipelineOfThis(const Cloud::ConstPtr& cloud,
               const pcl::INADParameters& parameters,
               const Tree::Ptr& search)
{
  pcl::NormalEstimationSweep<pcl::PointXYZ, pcl::Normal> normal_estimation(1);
  normal_estimation.setInputCloud(cloud);
  normal_estimation.setSearchMethod(search);
  normal_estimation.setRadiusSearch(parameters.normal_radius);
  const auto normals = pcl::make_shared<Normals>();
  normal_estimation.compute(*normals);

  pcl::INADEstimation<pcl::PointXYZ, pcl::Normal> inad_estimation(1);
  inad_estimation.setInputCloud(cloud);
  inad_estimation.setInputNormals(normals);
  inad_estimation.setSearchMethod(search);
  inad_estimation.setRadiusSearch(parameters.radius);
  inad_estimation.setOutlierRate(outlier_rate);
  Inad inad;
  inad_estimation.compute(inad);
  return planarPoints(inad, pcl::ShapeModel::idealPlane(parameters));
}

template <typename Pipeline>
void
add(const std::string& name, const Cloud::ConstPtr& cloud, const Pipeline& pipeline)
{
  benchmark::RegisterBenchmark(name.c_str(),
                               [cloud, pipeline](benchmark::State& state) {
                                 std::size_t planar = 0;
                                 for (auto _ : state) {
                                   benchmark::DoNotOptimize(planar = pipeline());
                                 }
                                 state.counters["points"] =
                                     static_cast<double>(cloud->size());
                                 state.counters["planar"] = static_cast<double>(planar);
                               })
      ->Unit(benchmark::kMillisecond);
}

void
addPipelines(const std::string& task,
             const Cloud::ConstPtr& cloud,
             const pcl::INADParameters& parameters)
{
  add(task + "/PCL_KdTree_sorted", cloud, [=] {
    return pipelineOfPCL(cloud, parameters, true);
  });
  add(task + "/PCL_KdTree_unsorted", cloud, [=] {
    return pipelineOfPCL(cloud, parameters, false);
  });
  add(task + "/these_classes_over_KdTree_unsorted", cloud, [=] {
    return pipelineOfThis(cloud, parameters, pcl::make_shared<Tree>(false));
  });
  add(task + "/sweep", cloud, [=] {
    return pipelineOfThis(cloud, parameters, nullptr);
  });
}

} // namespace

int
main(int argc, char** argv)
{
  benchmark::Initialize(&argc, argv);
  const Cloud::ConstPtr cloud = argc > 1 ? loadedCloud(argv[1]) : generatedCloud();
  if (argc > 2 || !cloud || cloud->empty()) {
    std::cerr << "usage: bench_pipeline [--benchmark_...] [cloud.pcd]\n";
    return 1;
  }
  addPipelines("surfaces", cloud, pcl::INADParameters::surfaces());
  addPipelines("edges", cloud, pcl::INADParameters::edges());
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}
