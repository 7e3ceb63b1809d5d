// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Normals, INAD and likelihoods: time of PCL and of this library.

#include "common/measure.h"
#include "common/options.h"
#include "pipeline.h"

#include <nlohmann/json.hpp>

#include <iostream>

namespace {

namespace po = boost::program_options;

// For 99 % of the points: PCL's float acos is wrong by up to 5e-4 rad near 0, and where
// neighbors are nearly on a line, as in a laser's rings, normals are hardly defined.
constexpr double agreement = 2e-3;

struct Settings : Options {
  std::string task = "pipeline";
  double scale = 1.0;
};

struct Times {
  std::vector<double> sorted, unsorted, shape;
};

/** \brief All three in turns, so that a busy machine is busy for all. */
Times
measure(const Settings& settings,
        const Pipeline& pipeline,
        const Cloud::ConstPtr& cloud,
        PipelineResult& theirs,
        PipelineResult& ours)
{
  const unsigned threads = settings.threads;
  const auto runOurs = [&] { ours = runShape(pipeline, cloud, threads); };
  const auto runTheirs = [&](bool sorted) {
    return millisecondsOf(
        [&] { theirs = runPcl(pipeline, cloud, sorted, static_cast<int>(threads)); });
  };
  Times times;
  for (unsigned i = 0; i < settings.repeat; ++i) {
    times.shape.push_back(millisecondsOf(runOurs));
    times.unsorted.push_back(runTheirs(false));
    times.shape.push_back(millisecondsOf(runOurs));
    times.sorted.push_back(runTheirs(true));
    std::cerr << "run " << i + 1 << " of " << settings.repeat << ": PCL "
              << times.sorted.back() << " ms, unsorted " << times.unsorted.back()
              << " ms, pcl_shape " << times.shape.back() << " ms\n";
  }
  return times;
}

/** \brief Of all radii. */
std::vector<double>
differencesOf(const std::vector<std::vector<float>>& a,
              const std::vector<std::vector<float>>& b)
{
  std::vector<double> all;
  for (std::size_t r = 0; r < a.size(); ++r) {
    const std::vector<double> some = differences(a[r], b[r]);
    all.insert(all.end(), some.begin(), some.end());
  }
  return all;
}

Settings
settingsOf(int argc, char** argv)
{
  Settings settings;
  po::options_description description = commonOptions("pipeline_vs_pcl", settings);
  description.add_options()(
      "task", po::value(&settings.task), "pipeline, edges or surfaces")(
      "scale", po::value(&settings.scale), "of all radii");
  parse(argc, argv, description, settings);
  return settings;
}

int
run(int argc, char** argv)
{
  const Settings settings = settingsOf(argc, argv);
  const Pipeline pipeline = Pipeline::of(settings.task, settings.scale);
  const Cloud::ConstPtr cloud = finiteCloudOf(settings);
  // First, to count the buffers that threads keep as well.
  const double extra_bytes = maxExtraBytes(pipeline, cloud, settings.threads);
  PipelineResult theirs, ours;
  const Times times = measure(settings, pipeline, cloud, theirs, ours);
  splitINAD(ours);
  const double pcl_ms = median(times.sorted);
  const double pcl_unsorted_ms = median(times.unsorted);
  const double pcl_shape_ms = median(times.shape);
  const std::vector<double> mu = differencesOf(theirs.mu, ours.mu);
  const std::vector<double> sigma = differencesOf(theirs.sigma, ours.sigma);
  const std::uint64_t neighbors =
      countShapeNeighbors(pipeline, *cloud, settings.threads);
  const nlohmann::ordered_json report{
      {"points", cloud->size()},
      {"threads", settings.threads},
      {"pcl_ms", pcl_ms},
      {"pcl_unsorted_ms", pcl_unsorted_ms},
      {"pcl_shape_ms", pcl_shape_ms},
      {"speedup", pcl_ms / pcl_shape_ms},
      {"speedup_unsorted", pcl_unsorted_ms / pcl_shape_ms},
      {"max_extra_bytes_per_point", extra_bytes},
      {"neighbors_pcl", theirs.neighbors},
      {"neighbors", neighbors},
      {"mu_p999", quantile(mu, 0.999)},
      {"sigma_p999", quantile(sigma, 0.999)},
      {"target", settings.target}};
  std::cout << report.dump() << std::endl;
  const bool agrees = neighbors == theirs.neighbors && quantile(mu, 0.99) < agreement &&
                      quantile(sigma, 0.99) < agreement;
  if (!agrees)
    std::cerr << "pipeline_vs_pcl: the results do not agree\n";
  return agrees ? 0 : 1;
}

} // namespace

int
main(int argc, char** argv)
{
  return runProgram("pipeline_vs_pcl", run, argc, argv);
}
