/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * Point Cloud Library (PCL) - www.pointclouds.org
 * Copyright (c) 2026, pcl_shape contributors
 *
 * All rights reserved
 */

#include "../src/kernels/targets.h"
#include "heap_counter.h"
#include "pipeline.h"

#include <pcl/features/inad.h>
#include <pcl/features/normal_3d_sweep.h>
#include <pcl/filters/filter.h>
#include <pcl/io/pcd_io.h>

#include <boost/program_options.hpp>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <iostream>
#include <random>
#include <stdexcept>

namespace {

namespace po = boost::program_options;

struct Options {
  std::string cloud;
  std::string target;
  unsigned threads = 1;
  unsigned repeat = 3;
  bool shuffle = false;
};

Options
parse(int argc, char** argv)
{
  Options o;
  po::options_description visible("pipeline_vs_pcl CLOUD.pcd [options]");
  visible.add_options()("threads", po::value(&o.threads), "threads of all pipelines")(
      "repeat", po::value(&o.repeat), "runs of each, interleaved")(
      "target", po::value(&o.target), "avx3, avx2, sse4, neon or portable")(
      "shuffle", po::bool_switch(&o.shuffle), "shuffle the points first")("help",
                                                                          "this");
  po::options_description all(visible);
  all.add_options()("cloud", po::value(&o.cloud));
  po::positional_options_description positional;
  positional.add("cloud", 1);
  po::variables_map values;
  const int style =
      po::command_line_style::unix_style | po::command_line_style::allow_long_disguise;
  po::store(po::command_line_parser(argc, argv)
                .options(all)
                .positional(positional)
                .style(style & ~po::command_line_style::allow_guessing)
                .run(),
            values);
  po::notify(values);
  if (values.count("help") > 0) {
    std::cout << visible;
    std::exit(0);
  }
  if (o.cloud.empty() || o.repeat == 0 || o.threads == 0) {
    throw std::invalid_argument("a cloud is needed, and at least 1 thread and 1 run");
  }
  return o;
}

Cloud::Ptr
load(const Options& options)
{
  const auto cloud = pcl::make_shared<Cloud>();
  if (pcl::io::loadPCDFile(options.cloud, *cloud) != 0) {
    throw std::runtime_error(options.cloud + ": cannot be read as a PCD file");
  }
  pcl::Indices kept;
  pcl::removeNaNFromPointCloud(*cloud, *cloud, kept);
  if (options.shuffle) {
    std::shuffle(cloud->begin(), cloud->end(), std::mt19937(1));
  }
  return cloud;
}

template <typename Run>
double
millisecondsOf(const Run& run)
{
  const auto start = std::chrono::steady_clock::now();
  run();
  return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() -
                                                   start)
      .count();
}

double
quantile(std::vector<double> values, double share)
{
  if (values.empty()) {
    return 0.0;
  }
  const auto at =
      static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), values.begin() + at, values.end());
  return values[static_cast<std::size_t>(at)];
}

double
difference999(const std::array<std::vector<float>, 2>& a,
              const std::array<std::vector<float>, 2>& b)
{
  std::vector<double> differences;
  for (std::size_t r = 0; r < a.size(); ++r) {
    for (std::size_t i = 0; i < a[r].size(); ++i) {
      if (!std::isnan(a[r][i]) && !std::isnan(b[r][i])) {
        differences.push_back(std::abs(double{a[r][i]} - b[r][i]));
      }
    }
  }
  return quantile(differences, 0.999);
}

/** \brief The most bytes in use during an estimation, without its output, for each
 * point. */
template <typename Output, typename Estimation>
double
extraBytes(Estimation& estimation, Output& output, std::size_t points)
{
  const std::size_t before = heapInUse();
  resetHeapPeak();
  estimation.compute(output);
  const std::size_t returned = output.size() * sizeof(output[0]);
  return (static_cast<double>(heapPeak() - before) - static_cast<double>(returned)) /
         static_cast<double>(points);
}

double
mostExtraBytes(const Cloud::ConstPtr& cloud, unsigned threads)
{
  const auto normals = pcl::make_shared<pcl::PointCloud<pcl::Normal>>();
  pcl::NormalEstimationSweep<pcl::PointXYZ, pcl::Normal> estimation(threads);
  estimation.setInputCloud(cloud);
  estimation.setRadiusSearch(normal_radius);
  double most = extraBytes(estimation, *normals, cloud->size());
  for (const double radius : inad_radii) {
    pcl::PointCloud<pcl::INAD> inad;
    pcl::INADEstimation<pcl::PointXYZ, pcl::Normal> inad_estimation(threads);
    inad_estimation.setInputCloud(cloud);
    inad_estimation.setInputNormals(normals);
    inad_estimation.setRadiusSearch(radius);
    most = std::max(most, extraBytes(inad_estimation, inad, cloud->size()));
  }
  return most;
}

int
run(const Options& options)
{
  pcl::kernels::chooseTarget(options.target);
  const Cloud::ConstPtr cloud = load(options);
  const auto threads = static_cast<int>(options.threads);
  std::vector<double> sorted, unsorted, shape;
  PipelineResult theirs, ours;
  for (unsigned i = 0; i < options.repeat; ++i) {
    shape.push_back(millisecondsOf([&] { ours = runShape(cloud, options.threads); }));
    unsorted.push_back(millisecondsOf([&] { theirs = runPcl(cloud, false, threads); }));
    shape.push_back(millisecondsOf([&] { ours = runShape(cloud, options.threads); }));
    sorted.push_back(millisecondsOf([&] { theirs = runPcl(cloud, true, threads); }));
    std::cerr << "run " << i + 1 << " of " << options.repeat << ": PCL "
              << sorted.back() << " ms, unsorted " << unsorted.back()
              << " ms, pcl_shape " << shape.back() << " ms\n";
  }
  const double pcl_ms = quantile(sorted, 0.5);
  const double pcl_unsorted_ms = quantile(unsorted, 0.5);
  const double pcl_shape_ms = quantile(shape, 0.5);
  const double mu = difference999(theirs.mu, ours.mu);
  const double sigma = difference999(theirs.sigma, ours.sigma);
  const std::uint64_t neighbors = countShapeNeighbors(*cloud, options.threads);
  const nlohmann::ordered_json report{
      {"points", cloud->size()},
      {"threads", options.threads},
      {"pcl_ms", pcl_ms},
      {"pcl_unsorted_ms", pcl_unsorted_ms},
      {"pcl_shape_ms", pcl_shape_ms},
      {"speedup", pcl_ms / pcl_shape_ms},
      {"speedup_unsorted", pcl_unsorted_ms / pcl_shape_ms},
      {"max_extra_bytes_per_point", mostExtraBytes(cloud, options.threads)},
      {"neighbors_pcl", theirs.neighbors},
      {"neighbors", neighbors},
      {"mu_p999", mu},
      {"sigma_p999", sigma}};
  std::cout << report.dump() << std::endl;
  // PCL's float acos is wrong by up to 5e-4 rad near 0.
  constexpr double agreement = 2e-3;
  const bool agrees =
      neighbors == theirs.neighbors && mu < agreement && sigma < agreement;
  if (!agrees) {
    std::cerr << "pipeline_vs_pcl: the results do not agree\n";
  }
  return agrees ? 0 : 1;
}

} // namespace

int
main(int argc, char** argv)
{
  try {
    return run(parse(argc, argv));
  }
  catch (const std::exception& e) {
    std::cerr << "pipeline_vs_pcl: " << e.what() << '\n';
    return 2;
  }
}
