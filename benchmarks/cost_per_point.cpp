// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// The cost of a point among a hundred thousand and among ten million.

#include "common/measure.h"
#include "common/options.h"
#include "pipeline.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <iostream>

// The pipeline on sheets of growing area and the same density: does a point cost the
// same among ten million as among a hundred thousand?
namespace {

namespace po = boost::program_options;

struct Size {
  std::size_t points;
  unsigned runs;            ///< in each turn, more of the short ones
  std::vector<double> ns;   ///< a point
  double extra_bytes = 0.0; ///< a point, the most
  double neighbors = 0.0;   ///< a point, the mean over both radii
};

void
measure(Size& size, const Pipeline& pipeline, unsigned threads)
{
  const Cloud::ConstPtr cloud = sheetCloud(size.points);
  size.points = cloud->size();
  const auto points = static_cast<double>(size.points);
  if (size.ns.empty()) {
    size.extra_bytes = maxExtraBytes(pipeline, cloud, threads);
    size.neighbors =
        static_cast<double>(countShapeNeighbors(pipeline, *cloud, threads)) / points;
  }
  for (unsigned i = 0; i < size.runs; ++i) {
    size.ns.push_back(1e6 / points *
                      millisecondsOf([&] { runShape(pipeline, cloud, threads); }));
  }
}

int
run(int argc, char** argv)
{
  Options options;
  std::vector<std::size_t> points{
      100000, 200000, 500000, 1000000, 2000000, 5000000, 10000000};
  po::options_description description = commonOptions("cost_per_point", options);
  description.add_options()(
      "points", po::value(&points)->multitoken(), "numbers of points");
  parse(argc, argv, description, options);
  if (!options.cloud.empty() || !options.generate.empty())
    throw std::invalid_argument("its clouds are its own: a cloud is not allowed");
  const Pipeline pipeline = Pipeline::of("pipeline", 1.0);
  const std::size_t most = *std::max_element(points.begin(), points.end());
  std::vector<Size> sizes;
  for (const std::size_t count : points) {
    const std::size_t runs = std::clamp<std::size_t>(most / (10 * count), 1, 10);
    sizes.push_back({count, static_cast<unsigned>(runs), {}});
  }
  for (unsigned i = 0; i < options.repeat; ++i) {
    for (Size& size : sizes) {
      measure(size, pipeline, options.threads);
      std::cerr << size.points << " points: " << size.ns.back() << " ns a point\n";
    }
  }
  nlohmann::ordered_json rows = nlohmann::ordered_json::array();
  for (const Size& size : sizes) {
    rows.push_back({{"points", size.points},
                    {"ns_per_point", median(size.ns)},
                    {"ratio", median(size.ns) / median(sizes.front().ns)},
                    {"max_extra_bytes_per_point", size.extra_bytes},
                    {"neighbors_per_point", size.neighbors}});
  }
  const nlohmann::ordered_json report{
      {"threads", options.threads}, {"target", options.target}, {"sizes", rows}};
  std::cout << report.dump() << std::endl;
  return 0;
}

} // namespace

int
main(int argc, char** argv)
{
  return runProgram("cost_per_point", run, argc, argv);
}
