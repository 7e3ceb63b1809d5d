// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Writes what the C++ classes compute of points: the tests of the Python module
// compare.

#include <pcl/features/inad.h>
#include <pcl/features/neighborhood_sweep.h>
#include <pcl/features/normal_3d_sweep.h>
#include <pcl/segmentation/shape_back_projection.h>
#include <pcl/segmentation/shape_edge_detection.h>
#include <pcl/segmentation/shape_ground_segmentation.h>
#include <pcl/segmentation/shape_instance_segmentation.h>
#include <pcl/segmentation/shape_labeling.h>
#include <pcl/segmentation/suction_grasp_estimation.h>
#include <pcl/features/impl/neighborhoods.hpp>

#include <algorithm>
#include <chrono>
#include <cstring>
#include <fstream>
#include <iostream>
#include <iterator>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

using Point = pcl::PointXYZ;
using CloudPtr = pcl::PointCloud<Point>::Ptr;

constexpr double radius = 0.02; // of the tests' scenes, meters

/** Three floats for each point. */
CloudPtr
readPoints(const std::string& path)
{
  std::ifstream file(path, std::ios::binary);
  const std::string bytes(std::istreambuf_iterator<char>(file), {});
  const auto cloud = pcl::make_shared<pcl::PointCloud<Point>>();
  for (std::size_t i = 0; i + 3 * sizeof(float) <= bytes.size();
       i += 3 * sizeof(float)) {
    Point point;
    std::memcpy(point.data, &bytes[i], 3 * sizeof(float));
    cloud->push_back(point);
  }
  cloud->is_dense = false;
  return cloud;
}

/** Writes arrays into a directory. */
class Writer {
public:
  explicit Writer(std::string directory) : directory_(std::move(directory)) {}

  template <typename T>
  void
  write(const std::string& name, const std::vector<T>& values) const
  {
    std::ofstream file(directory_ + "/" + name, std::ios::binary);
    file.write(reinterpret_cast<const char*>(values.data()),
               static_cast<std::streamsize>(values.size() * sizeof(T)));
    if (!file)
      throw std::runtime_error("cannot write " + directory_ + "/" + name);
  }

private:
  std::string directory_;
};

std::vector<std::uint32_t>
membership(const std::vector<pcl::PointIndices>& sets, std::size_t size)
{
  std::vector<std::uint32_t> numbers(size, 0);
  for (std::size_t k = 0; k < sets.size(); ++k)
    for (const pcl::index_t i : sets[k].indices)
      numbers[static_cast<std::size_t>(i)] = static_cast<std::uint32_t>(k + 1);
  return numbers;
}

void
writeField(const pcl::ShapeField& field, const Writer& writer)
{
  std::vector<float> normals, likelihoods, creases;
  for (const Eigen::Vector3f& n : field.normals)
    normals.insert(normals.end(), n.data(), n.data() + 3);
  for (std::size_t i = 0; i < field.points.size; ++i)
    for (const std::vector<float>& of_class : field.likelihoods)
      likelihoods.push_back(of_class[i]);
  for (const pcl::CreasePoint& crease : field.creases)
    creases.insert(creases.end(), crease.position.begin(), crease.position.end());
  writer.write("normals", normals);
  writer.write("likelihoods", likelihoods);
  writer.write("crease_points", creases);
  writer.write("edge_likelihood", field.edge_likelihood);
  writer.write("spacing", field.spacings);
}

pcl::ShapeField::ConstPtr
fieldOf(const CloudPtr& cloud)
{
  pcl::ShapeFieldEstimation<Point> estimation;
  estimation.setInputCloud(cloud);
  const auto field = pcl::make_shared<pcl::ShapeField>();
  if (!estimation.compute(*field))
    throw std::runtime_error("no field");
  return field;
}

/** What `detect` gives. */
struct Detected {
  pcl::ShapeField::ConstPtr field;
  pcl::Edges edges;
  std::vector<pcl::PointIndices> edge_classes;
  std::vector<pcl::PointIndices> surfaces;
};

Detected
detect(const CloudPtr& cloud)
{
  Detected detected;
  detected.field = fieldOf(cloud);
  pcl::ShapeEdgeDetection<Point> edges;
  edges.setInputCloud(cloud);
  edges.setShapeField(detected.field);
  edges.detect(detected.edges);
  std::vector<std::vector<float>> likelihoods;
  edges.compute(likelihoods);
  detected.edge_classes = edges.classesOf(likelihoods);
  pcl::ShapeBackProjection<Point> surfaces;
  surfaces.setInputCloud(cloud);
  surfaces.setShapeField(detected.field);
  surfaces.compute(likelihoods);
  detected.surfaces = surfaces.classesOf(likelihoods);
  return detected;
}

void
writeDetected(const Detected& detected, const Writer& writer)
{
  const std::size_t size = detected.field->points.size;
  writeField(*detected.field, writer);
  writer.write("edge_type", detected.edges.types);
  writer.write("edges", membership({detected.edge_classes.front()}, size));
  writer.write("surface", membership(detected.surfaces, size));
  std::vector<float> lengths;
  for (const pcl::CreaseLine& line : pcl::creaseLines(detected.field->creases))
    lengths.push_back(line.length);
  writer.write("line_lengths", lengths);
}

void
writeTasks(const CloudPtr& cloud,
           const pcl::ShapeField::ConstPtr& field,
           const Writer& writer)
{
  pcl::ShapeInstanceSegmentation<Point> segmentation;
  segmentation.setInputCloud(cloud);
  segmentation.setShapeField(field);
  segmentation.setClass("object");
  segmentation.setPrimitive(pcl::PrimitiveType::Auto);
  std::vector<pcl::ShapeInstance> instances;
  segmentation.segment(instances);
  std::vector<pcl::PointIndices> sets;
  std::vector<float> coefficients;
  for (const pcl::ShapeInstance& instance : instances) {
    sets.emplace_back().indices = instance.indices;
    coefficients.insert(coefficients.end(),
                        instance.primitive.coefficients.begin(),
                        instance.primitive.coefficients.end());
  }
  writer.write("instances", membership(sets, cloud->size()));
  writer.write("coefficients", coefficients);

  pcl::SuctionGraspEstimation<Point> estimation;
  estimation.setInputCloud(cloud);
  estimation.setShapeField(field);
  std::vector<pcl::SuctionGrasp> grasps;
  estimation.compute(grasps);
  std::vector<float> rows;
  for (const pcl::SuctionGrasp& grasp : grasps) {
    rows.insert(rows.end(), grasp.position.data(), grasp.position.data() + 3);
    rows.push_back(grasp.score);
  }
  writer.write("grasps", rows);

  pcl::ShapeLabeling<Point> labeling;
  labeling.setInputCloud(cloud);
  labeling.setShapeField(field);
  pcl::PointLabels labels;
  labeling.label(labels);
  writer.write("labels", labels.labels);
  writer.write("confidence", labels.confidence);

  pcl::ShapeGroundSegmentation<Point> ground;
  ground.setInputCloud(cloud);
  ground.setUp(Eigen::Vector3f(0.0f, 0.0f, 1.0f));
  std::vector<float> likelihood;
  ground.compute(likelihood);
  writer.write("ground_likelihood", likelihood);
}

void
writeFeatures(const CloudPtr& cloud, const Writer& writer)
{
  pcl::NormalEstimationSweep<Point, pcl::Normal> estimation;
  estimation.setInputCloud(cloud);
  estimation.setRadiusSearch(radius);
  const auto normals = pcl::make_shared<pcl::PointCloud<pcl::Normal>>();
  estimation.compute(*normals);
  std::vector<float> rows, pairs;
  for (const pcl::Normal& n : *normals)
    rows.insert(rows.end(), {n.normal_x, n.normal_y, n.normal_z, n.curvature});
  writer.write("feature_normals", rows);

  pcl::INADEstimation<Point, pcl::Normal> angles;
  angles.setInputCloud(cloud);
  angles.setInputNormals(normals);
  angles.setRadiusSearch(radius);
  pcl::PointCloud<pcl::INAD> inad;
  angles.compute(inad);
  for (const pcl::INAD& pair : inad)
    pairs.insert(pairs.end(), {pair.mu, pair.sigma});
  writer.write("inad", pairs);

  const pcl::NeighborhoodSweep sweep(pcl::detail::xyzOf(*cloud));
  std::vector<std::uint32_t> counts(cloud->size());
  std::vector<float> distances(cloud->size());
  sweep.countNeighbors(pcl::NeighborhoodSize::ofRadius(radius), counts.data());
  sweep.computeDistanceToNearest(12, distances.data());
  writer.write("counts", counts);
  writer.write("distances", distances);
}

/** Seconds of `detect`, the best of several, to be compared with Python's. */
void
printSeconds(const CloudPtr& cloud, int runs)
{
  double best = 1e9;
  for (int i = 0; i < runs; ++i) {
    const auto begin = std::chrono::steady_clock::now();
    detect(cloud);
    const std::chrono::duration<double> seconds =
        std::chrono::steady_clock::now() - begin;
    best = std::min(best, seconds.count());
  }
  std::cout << best << "\n";
}

} // namespace

int
main(int argc, char** argv)
{
  if (argc != 3) {
    std::cerr << "usage: pcl_shape_python_reference POINTS DIRECTORY|RUNS\n";
    return 2;
  }
  const CloudPtr cloud = readPoints(argv[1]);
  const std::string second = argv[2];
  if (second.find_first_not_of("0123456789") == std::string::npos) {
    printSeconds(cloud, std::stoi(second));
    return 0;
  }
  const Writer writer(second);
  const Detected detected = detect(cloud);
  writeDetected(detected, writer);
  writeTasks(cloud, detected.field, writer);
  writeFeatures(cloud, writer);
  return 0;
}
