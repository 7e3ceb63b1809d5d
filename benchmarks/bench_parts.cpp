// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// The parts of the pipelines one by one, by Google Benchmark.

#include "common/clouds.h"
#include "common/options.h"

#include <pcl/features/inad.h>
#include <pcl/features/normal_3d_sweep.h>
#include <pcl/features/shape_histogram.h>
#include <pcl/segmentation/shape_field_estimation.h>
#include <pcl/segmentation/shape_ground_segmentation.h>
#include <pcl/segmentation/shape_instance_segmentation.h>

#include <benchmark/benchmark.h>

#include <string>
#include <vector>

// The parts of the pipelines one by one, by Google Benchmark.
// Usage: bench_parts [--benchmark_...] [CLOUD.pcd] [options]
namespace {

using Normals = pcl::PointCloud<pcl::Normal>;
using Inad = pcl::PointCloud<pcl::INAD>;

/** \brief What parts are given: each is the output of the one before. */
struct Inputs {
  unsigned threads;
  Cloud::ConstPtr cloud;
  Normals::Ptr normals = pcl::make_shared<Normals>();
  Inad inad;
  pcl::ShapeHistogram histogram;
  pcl::ShapeField::Ptr field = pcl::make_shared<pcl::ShapeField>();
};

void
estimateNormals(const Inputs& in, double radius, int k, Normals& normals)
{
  pcl::NormalEstimationSweep<pcl::PointXYZ, pcl::Normal> estimation(in.threads);
  estimation.setInputCloud(in.cloud);
  estimation.setRadiusSearch(radius);
  estimation.setKSearch(k);
  estimation.compute(normals);
}

void
estimateInad(const Inputs& in, double radius, int k, Inad& inad)
{
  pcl::INADEstimation<pcl::PointXYZ, pcl::Normal> estimation(in.threads);
  estimation.setInputCloud(in.cloud);
  estimation.setInputNormals(in.normals);
  estimation.setRadiusSearch(radius);
  estimation.setKSearch(k);
  estimation.compute(inad);
}

void
estimateField(const Inputs& in, pcl::ShapeField& field)
{
  pcl::ShapeFieldEstimation<pcl::PointXYZ> estimation;
  estimation.setInputCloud(in.cloud);
  estimation.setNumberOfThreads(in.threads);
  estimation.compute(field);
}

/** \brief Time part(), and print its time for each point as well. */
template <typename Part>
void
add(const std::string& name, const Inputs& in, const Part& part)
{
  benchmark::RegisterBenchmark(name.c_str(),
                               [&in, part](benchmark::State& state) {
                                 for (auto _ : state) {
                                   part();
                                   benchmark::ClobberMemory();
                                 }
                                 state.SetItemsProcessed(
                                     state.iterations() *
                                     static_cast<std::int64_t>(in.cloud->size()));
                               })
      ->Unit(benchmark::kMillisecond)
      ->UseRealTime();
}

void
addEstimations(const Inputs& in)
{
  for (const int mm : {6, 10, 15, 20, 25}) {
    const std::string size = "/" + std::to_string(mm) + "mm";
    add("normals" + size, in, [&in, mm] {
      Normals normals;
      estimateNormals(in, 1e-3 * mm, 0, normals);
    });
    add("inad" + size, in, [&in, mm] {
      Inad inad;
      estimateInad(in, 1e-3 * mm, 0, inad);
    });
  }
  for (const int k : {10, 100, 500}) {
    const std::string size = "/" + std::to_string(k) + "_nearest";
    add("normals" + size, in, [&in, k] {
      Normals normals;
      estimateNormals(in, 0.0, k, normals);
    });
    add("inad" + size, in, [&in, k] {
      Inad inad;
      estimateInad(in, 0.0, k, inad);
    });
  }
}

void
addLookups(const Inputs& in)
{
  add("histogram", in, [&in] {
    pcl::ShapeHistogram histogram;
    histogram.add(in.inad);
    benchmark::DoNotOptimize(histogram.total());
  });
  add("likelihood", in, [&in] {
    benchmark::DoNotOptimize(in.histogram.backProject(in.inad, in.threads));
  });
}

/** \brief The field, whole objects with the field given, and the ground, which needs
 * none: of a street, z up. */
void
addDetectors(const Inputs& in)
{
  add("field", in, [&in] {
    pcl::ShapeField field;
    estimateField(in, field);
  });
  add("objects", in, [&in] {
    pcl::ShapeInstanceSegmentation<pcl::PointXYZ> segmentation;
    segmentation.setInputCloud(in.cloud);
    segmentation.setShapeField(in.field);
    segmentation.setClass("object");
    segmentation.setNumberOfThreads(in.threads);
    std::vector<pcl::ShapeInstance> objects;
    segmentation.segment(objects);
  });
  add("ground", in, [&in] {
    pcl::ShapeGroundSegmentation<pcl::PointXYZ> segmentation;
    segmentation.setInputCloud(in.cloud);
    segmentation.setNumberOfThreads(in.threads);
    pcl::PointIndices ground;
    segmentation.segment(ground);
  });
}

int
run(int argc, char** argv)
{
  benchmark::Initialize(&argc, argv);
  Options options;
  parse(argc, argv, commonOptions("bench_parts [--benchmark_...]", options), options);
  Inputs in;
  in.threads = options.threads;
  in.cloud = finiteCloudOf(options);
  estimateNormals(in, 0.010, 0, *in.normals);
  estimateInad(in, 0.006, 0, in.inad);
  in.histogram.add(in.inad);
  estimateField(in, *in.field);
  addEstimations(in);
  addLookups(in);
  addDetectors(in);
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}

} // namespace

int
main(int argc, char** argv)
{
  return runProgram("bench_parts", run, argc, argv);
}
