// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// A tool for PCL's own tree: labels the points of a cloud with their instances.

#include "upstream/extended_cloud.h"

#include <pcl/console/parse.h>
#include <pcl/console/print.h>
#include <pcl/segmentation/shape_instance_segmentation.h>

#include <cstdint>
#include <cstdlib>
#include <string>
#include <vector>

namespace {

using namespace pcl::console;

using Cloud = ExtendedCloud::Points;
using Labels = pcl::PointCloud<pcl::Label>;
using Instances = std::vector<pcl::ShapeInstance>;

void
printHelp(const char* program)
{
  print_error("Syntax is: %s input.pcd output.pcd [-class X]\n", program);
  print_info("Adds the field label: 0, or the number of the instance from 1 on, the\n"
             "largest first. Prints the primitive that fits each instance best.\n"
             "  -class X = curved (default), planar, or object for whole objects\n");
}

void
printInstance(std::size_t number, const pcl::ShapeInstance& instance)
{
  static const char* const names[] = {"none", "none", "plane", "cylinder", "sphere"};
  const pcl::ShapePrimitive& fit = instance.primitive;
  print_info("%zu: ", number);
  print_value("%zu", instance.indices.size());
  print_info(" points, %s", names[static_cast<std::size_t>(fit.type)]);
  for (const float coefficient : fit.coefficients)
    print_value(" %g", coefficient);
  print_info("\n");
}

Labels
labelsOf(const Instances& instances, const Cloud& cloud)
{
  Labels labels(cloud.width, cloud.height);
  for (pcl::Label& label : labels)
    label.label = 0;
  for (std::size_t i = 0; i < instances.size(); ++i)
    for (const pcl::index_t index : instances[i].indices)
      labels[static_cast<std::size_t>(index)].label = static_cast<std::uint32_t>(i + 1);
  return labels;
}

/** \brief Write the input with the labels; says itself what goes wrong. */
int
run(const std::string& input_name,
    const std::string& output_name,
    const std::string& class_name)
{
  ExtendedCloud cloud;
  if (!cloud.load(input_name))
    return EXIT_FAILURE;

  pcl::ShapeInstanceSegmentation<pcl::PointXYZ> segmentation;
  segmentation.setInputCloud(cloud.points());
  segmentation.setClass(class_name);
  segmentation.setPrimitive(pcl::PrimitiveType::Auto);
  Instances instances;
  if (!segmentation.segment(instances))
    return EXIT_FAILURE;
  for (std::size_t i = 0; i < instances.size(); ++i)
    printInstance(i + 1, instances[i]);

  const bool is_written =
      cloud.add(labelsOf(instances, *cloud.points())) && cloud.save(output_name);
  return is_written ? EXIT_SUCCESS : EXIT_FAILURE;
}

} // namespace

int
main(int argc, char** argv)
{
  const std::vector<int> files = parse_file_extension_argument(argc, argv, ".pcd");
  std::string class_name = "curved";
  parse_argument(argc, argv, "-class", class_name);
  if (files.size() != 2) {
    printHelp(argv[0]);
    return EXIT_FAILURE;
  }
  return run(argv[files[0]], argv[files[1]], class_name);
}
