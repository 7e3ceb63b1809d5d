// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// A program outside of the project that uses all of the installed package.

#include <pcl/features/inad.h>
#include <pcl/features/neighborhood_sweep.h>
#include <pcl/features/normal_3d_sweep.h>
#include <pcl/features/shape_histogram.h>
#include <pcl/features/shape_model.h>
#include <pcl/features/sweep_index.h>
#include <pcl/point_types.h>
#include <pcl/segmentation/shape_back_projection.h>
#include <pcl/segmentation/shape_edge_detection.h>
#include <pcl/segmentation/shape_field_estimation.h>
#include <pcl/segmentation/shape_ground_segmentation.h>
#include <pcl/segmentation/shape_instance_segmentation.h>
#include <pcl/segmentation/shape_labeling.h>
#include <pcl/segmentation/suction_grasp_estimation.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <iostream>
#include <memory>
#include <string>
#include <vector>

// Every class of the installed package, on two walls that meet at a right angle.
namespace {

using Cloud = pcl::PointCloud<pcl::PointXYZ>;

Cloud::Ptr
twoWalls()
{
  const auto cloud = pcl::make_shared<Cloud>();
  for (int i = -50; i < 50; ++i) {
    for (int j = 0; j < 100; ++j) {
      cloud->emplace_back(0.002f * static_cast<float>(std::max(0, i)),
                          0.002f * static_cast<float>(j),
                          1.0f + 0.002f * static_cast<float>(std::min(0, i)));
    }
  }
  return cloud;
}

bool
hasFeatures(const Cloud::ConstPtr& cloud)
{
  const auto index = std::make_shared<pcl::SweepIndex>();
  const auto normals = pcl::make_shared<pcl::PointCloud<pcl::Normal>>();
  pcl::NormalEstimationSweep<pcl::PointXYZ, pcl::Normal> normal_estimation;
  normal_estimation.setSweepIndex(index);
  normal_estimation.setInputCloud(cloud);
  normal_estimation.setRadiusSearch(0.025);
  normal_estimation.compute(*normals);

  pcl::PointCloud<pcl::INAD> inad;
  pcl::INADEstimation<pcl::PointXYZ, pcl::Normal> inad_estimation;
  inad_estimation.setSweepIndex(index);
  inad_estimation.setInputCloud(cloud);
  inad_estimation.setInputNormals(normals);
  inad_estimation.setRadiusSearch(0.025);
  inad_estimation.compute(inad);

  pcl::NeighborhoodSweep sweep(
      {(*cloud)[0].data, sizeof(pcl::PointXYZ) / sizeof(float), cloud->size()});
  sweep.setIndex(index);
  std::vector<std::uint32_t> neighbors(sweep.size());
  sweep.countNeighbors(pcl::NeighborhoodSize::ofRadius(0.025), neighbors.data());

  pcl::ShapeHistogram histogram;
  histogram.add(inad);
  return histogram.total() == cloud->size() && index->getSortCount() == 1 &&
         *std::min_element(neighbors.begin(), neighbors.end()) > 100;
}

bool
hasSurfacesAndEdges(const Cloud::ConstPtr& cloud, const std::string& model_file)
{
  pcl::ShapeModel::idealPlane().save(model_file);
  pcl::ShapeBackProjection<pcl::PointXYZ> surfaces;
  surfaces.setMode(surfaces.PAPER);
  surfaces.setModel(pcl::ShapeModel::load(model_file));
  surfaces.setInputCloud(cloud);
  std::vector<pcl::PointIndices> classes;
  surfaces.segment(classes);

  pcl::PointIndices edges;
  pcl::ShapeEdgeDetection<pcl::PointXYZ> edge_detection;
  edge_detection.setInputCloud(cloud);
  edge_detection.segment(edges);
  std::cout << edges.indices.size() << " edge points of " << cloud->size() << '\n';
  return classes.size() == 2 && classes[0].indices.size() > cloud->size() / 2 &&
         !edges.indices.empty() && edges.indices.size() < cloud->size() / 5;
}

bool
hasTwoPlanes(const Cloud::ConstPtr& cloud)
{
  std::vector<pcl::ShapeInstance> instances;
  pcl::ShapeInstanceSegmentation<pcl::PointXYZ> segmentation;
  segmentation.setInputCloud(cloud);
  segmentation.setClass("planar");
  segmentation.setPrimitive(pcl::PrimitiveType::Plane);
  const bool is_done = segmentation.segment(instances);
  std::cout << instances.size() << " planes\n";
  return is_done && instances.size() == 2;
}

bool
hasGrasps(const Cloud::ConstPtr& cloud)
{
  std::vector<pcl::SuctionGrasp> grasps;
  pcl::SuctionGraspEstimation<pcl::PointXYZ> estimation;
  estimation.setInputCloud(cloud);
  estimation.setViewPoint(0.1f, 0.1f, 0.9f);
  estimation.setMaximumGrasps(1);
  return estimation.compute(grasps) && grasps.size() == 1 && grasps[0].seals();
}

bool
hasLabels(const Cloud::ConstPtr& cloud)
{
  const auto field = pcl::make_shared<pcl::ShapeField>();
  pcl::ShapeFieldEstimation<pcl::PointXYZ> estimation;
  estimation.setInputCloud(cloud);
  if (!estimation.compute(*field))
    return false;

  pcl::PointLabels labels;
  pcl::ShapeLabeling<pcl::PointXYZ> labeling;
  labeling.setInputCloud(cloud);
  labeling.setShapeField(field);
  labeling.label(labels);
  const auto planar = std::count(labels.labels.begin(), labels.labels.end(), 1U);
  std::cout << planar << " points are labeled planar\n";
  return labels.confidence.size() == cloud->size() &&
         planar > static_cast<std::ptrdiff_t>(cloud->size() / 2);
}

/** The far wall is below the sensor if up is towards it. */
bool
hasGround(const Cloud::ConstPtr& cloud)
{
  std::vector<float> likelihood;
  pcl::ShapeGroundSegmentation<pcl::PointXYZ> segmentation;
  segmentation.setInputCloud(cloud);
  segmentation.setUp({0.0f, 0.0f, -1.0f});
  segmentation.compute(likelihood);
  std::cout << std::count_if(likelihood.begin(), likelihood.end(), [](float l) {
    return l >= 0.5f;
  }) << " points of ground\n";
  return likelihood.size() == cloud->size() && likelihood.back() >= 0.5f;
}

} // namespace

int
main(int argc, char** argv)
{
  if (argc != 2)
    return 2;
  const auto cloud = twoWalls();
  const bool is_right = hasFeatures(cloud) && hasSurfacesAndEdges(cloud, argv[1]) &&
                        hasTwoPlanes(cloud) && hasGrasps(cloud) && hasLabels(cloud) &&
                        hasGround(cloud);
  return is_right ? 0 : 1;
}
