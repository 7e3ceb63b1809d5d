// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// A tool for PCL's own tree: adds normals and INAD to a cloud.

#include "upstream/extended_cloud.h"

#include <pcl/console/parse.h>
#include <pcl/console/print.h>
#include <pcl/features/inad.h>
#include <pcl/features/normal_3d_omp.h>

#include <cstdlib>
#include <string>
#include <vector>

namespace {

using namespace pcl::console;

using Cloud = ExtendedCloud::Points;
using Normals = pcl::PointCloud<pcl::Normal>;
using InadCloud = pcl::PointCloud<pcl::INAD>;

struct Options {
  double radius = 0.0;        // of the angles, in meters
  double normal_radius = 0.0; // in meters
  double outlier_rate = 2.0;
};

void
printHelp(const char* program)
{
  print_error("Syntax is: %s input.pcd output.pcd -radius X [options]\n", program);
  print_info(
      "Adds normals, and mean and standard deviation (mu, sigma) of the angles\n"
      "between the normal of a point and those of its neighbors.\n"
      "  -radius X        = compare with the normals within X meters\n"
      "  -normal_radius X = estimate normals within X meters (default: -radius)\n"
      "  -outliers X      = reject angles further than X standard deviations from\n"
      "                     the mean, once (default: 2; 0: reject none)\n");
}

Normals::Ptr
estimateNormals(const Cloud::ConstPtr& cloud, double radius)
{
  pcl::NormalEstimationOMP<pcl::PointXYZ, pcl::Normal> estimation;
  estimation.setInputCloud(cloud);
  estimation.setRadiusSearch(radius);
  const auto normals = pcl::make_shared<Normals>();
  estimation.compute(*normals);
  return normals;
}

InadCloud
estimateInad(const Cloud::ConstPtr& cloud,
             const Normals::ConstPtr& normals,
             const Options& options)
{
  pcl::INADEstimation<pcl::PointXYZ, pcl::Normal> estimation;
  estimation.setInputCloud(cloud);
  estimation.setInputNormals(normals);
  estimation.setRadiusSearch(options.radius);
  estimation.setOutlierRate(options.outlier_rate);
  InadCloud inad;
  estimation.compute(inad);
  return inad;
}

/** \brief Write the input with all that was found; says itself what goes wrong. */
int
run(const std::string& input_name,
    const std::string& output_name,
    const Options& options)
{
  ExtendedCloud cloud;
  if (!cloud.load(input_name))
    return EXIT_FAILURE;
  const Normals::Ptr normals = estimateNormals(cloud.points(), options.normal_radius);
  const InadCloud inad = estimateInad(cloud.points(), normals, options);
  const bool is_written = inad.size() == cloud.points()->size() &&
                          cloud.add(*normals) && cloud.add(inad) &&
                          cloud.save(output_name);
  return is_written ? EXIT_SUCCESS : EXIT_FAILURE;
}

} // namespace

int
main(int argc, char** argv)
{
  const std::vector<int> files = parse_file_extension_argument(argc, argv, ".pcd");
  Options options;
  parse_argument(argc, argv, "-radius", options.radius);
  options.normal_radius = options.radius;
  parse_argument(argc, argv, "-normal_radius", options.normal_radius);
  parse_argument(argc, argv, "-outliers", options.outlier_rate);
  if (files.size() != 2 || options.radius <= 0.0 || options.normal_radius <= 0.0) {
    printHelp(argv[0]);
    return EXIT_FAILURE;
  }
  return run(argv[files[0]], argv[files[1]], options);
}
