// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Radius search and INAD over the search structures that exist.

#include "common/clouds.h"
#include "common/measure.h"
#include "common/options.h"
#include "search_structures.h"

#include <pcl/common/point_tests.h>
#include <pcl/features/inad.h>
#include <pcl/features/normal_3d_sweep.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <iostream>

// Radius search and INAD over the search structures that exist, with one loop for all,
// beside INADEstimation.
namespace {

namespace po = boost::program_options;

struct Settings : Options {
  double radius = 0.020;
  double normal_radius = 0.010;
};

Normals::Ptr
normalsOf(const Cloud::ConstPtr& cloud, const Settings& settings)
{
  pcl::NormalEstimationSweep<pcl::PointXYZ, pcl::Normal> estimation(settings.threads);
  estimation.setInputCloud(cloud);
  estimation.setRadiusSearch(settings.normal_radius);
  const auto normals = pcl::make_shared<Normals>();
  estimation.compute(*normals);
  return normals;
}

std::vector<float>
runShape(const Cloud::ConstPtr& cloud,
         const Normals::ConstPtr& normals,
         const Settings& settings)
{
  pcl::INADEstimation<pcl::PointXYZ, pcl::Normal> estimation(settings.threads);
  estimation.setInputCloud(cloud);
  estimation.setInputNormals(normals);
  estimation.setRadiusSearch(settings.radius);
  estimation.setOutlierRate(outlier_rate);
  pcl::PointCloud<pcl::INAD> inad;
  estimation.compute(inad);
  std::vector<float> mu;
  for (const pcl::INAD& value : inad)
    mu.push_back(value.mu);
  return mu;
}

struct Measured {
  std::string name;
  std::vector<double> build_ms, query_ms;
  SearchResult result;
};

/** \brief Octrees and the projection of an image have borders of their own: 99 % of the
 * points must agree. */
bool
agrees(const std::vector<float>& a, const std::vector<float>& b)
{
  constexpr double agreement = 2e-3;
  return quantile(differences(a, b), 0.99) < agreement;
}

Settings
settingsOf(int argc, char** argv)
{
  Settings settings;
  po::options_description description = commonOptions("structures", settings);
  description.add_options()("radius", po::value(&settings.radius), "of INAD, meters")(
      "normal_radius", po::value(&settings.normal_radius), "meters");
  parse(argc, argv, description, settings);
  if (settings.shuffle)
    throw std::invalid_argument("organized clouds cannot be shuffled");
  return settings;
}

nlohmann::ordered_json
rowOf(const Measured& m, double queries)
{
  return {{"name", m.name},
          {"build_ms", median(m.build_ms)},
          {"us_per_query", 1e3 * median(m.query_ms) / queries},
          {"neighbors", m.result.neighbors}};
}

struct AllMeasured {
  std::vector<Measured> structures;
  std::vector<double> shape_ms;
  std::vector<float> shape_mu;
};

/** \brief All structures in turns, and pcl_shape between them. */
AllMeasured
measure(const Settings& settings, const Cloud::ConstPtr& cloud)
{
  const Normals::ConstPtr normals = normalsOf(cloud, settings);
  const std::vector<SearchStructure> structures = searchStructures(*cloud);
  AllMeasured all;
  for (const SearchStructure& structure : structures)
    all.structures.push_back({structure.name, {}, {}, {}});
  for (unsigned i = 0; i < settings.repeat; ++i) {
    for (std::size_t s = 0; s < structures.size(); ++s) {
      Measured& m = all.structures[s];
      std::unique_ptr<RadiusSearch> search;
      m.build_ms.push_back(millisecondsOf(
          [&] { search = structures[s].build(cloud, settings.radius); }));
      m.query_ms.push_back(millisecondsOf([&] {
        m.result = search->run(*normals, static_cast<int>(settings.threads));
      }));
      all.shape_ms.push_back(
          millisecondsOf([&] { all.shape_mu = runShape(cloud, normals, settings); }));
      std::cerr << m.name << ": " << m.query_ms.back() << " ms\n";
    }
  }
  return all;
}

int
run(int argc, char** argv)
{
  const Settings settings = settingsOf(argc, argv);
  const Cloud::ConstPtr cloud = cloudOf(settings);
  const auto points = std::count_if(
      cloud->begin(), cloud->end(), [](const auto& p) { return pcl::isFinite(p); });
  const auto queries = static_cast<double>(points);
  const AllMeasured all = measure(settings, cloud);
  nlohmann::ordered_json rows = nlohmann::ordered_json::array();
  bool all_agree = true;
  for (const Measured& m : all.structures) {
    rows.push_back(rowOf(m, queries));
    all_agree = all_agree && agrees(m.result.mu, all.shape_mu);
  }
  const nlohmann::ordered_json report{
      {"points", points},
      {"organized", cloud->isOrganized()},
      {"threads", settings.threads},
      {"target", settings.target},
      {"radius", settings.radius},
      {"pcl_shape_us_per_query", 1e3 * median(all.shape_ms) / queries},
      {"structures", rows}};
  std::cout << report.dump() << std::endl;
  if (!all_agree)
    std::cerr << "structures: the results do not agree\n";
  return all_agree ? 0 : 1;
}

} // namespace

int
main(int argc, char** argv)
{
  return runProgram("structures", run, argc, argv);
}
