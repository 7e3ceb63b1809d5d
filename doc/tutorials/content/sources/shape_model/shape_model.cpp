/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * Point Cloud Library (PCL) - www.pointclouds.org
 * Copyright (c) 2026, pcl_shape contributors
 *
 * All rights reserved
 */

#include <pcl/features/inad.h>
#include <pcl/features/normal_3d_sweep.h>
#include <pcl/io/pcd_io.h>
#include <pcl/point_types.h>
#include <pcl/segmentation/shape_back_projection.h>

#include <array>
#include <cmath>
#include <iostream>
#include <random>

using Cloud = pcl::PointCloud<pcl::PointXYZ>;

namespace {

constexpr double radius = 0.025; // meters, of normals and INAD

// [surfaces]
/** Points of a surface of width x width meters from x = left on, with noise. */
template <typename Height>
void
addSurface(Cloud& cloud, float left, float width, const Height& height)
{
  std::mt19937 random(static_cast<unsigned>(cloud.size()) + 1);
  std::uniform_real_distribution<float> anywhere(0.0f, width);
  std::normal_distribution<float> noise(0.0f, 0.0005f);
  constexpr float points_per_square_metre = 1.0f / (0.003f * 0.003f);
  const auto count = static_cast<int>(points_per_square_metre * width * width);
  for (int i = 0; i < count; ++i) {
    const float x = anywhere(random);
    const float y = anywhere(random);
    cloud.emplace_back(left + x, y, height(x, y) + noise(random));
  }
}

float
flat(float, float)
{
  return 1.0f;
}

/** A corrugated sheet: 18 mm deep, 76 mm from crest to crest. */
float
corrugated(float x, float)
{
  return 1.0f + 0.009f * std::sin(6.2831853f * x / 0.076f);
}

/** A dome, part of a ball of 0.25 m in radius. */
float
dome(float x, float y)
{
  const float right = x - 0.15f;
  const float up = y - 0.15f;
  return 1.25f - std::sqrt(0.0625f - right * right - up * up);
}
// [surfaces]

// [sample]
template <typename Height>
pcl::ShapeHistogram
sample(const Height& height, const char* file_name)
{
  const auto cloud = pcl::make_shared<Cloud>();
  addSurface(*cloud, 0.0f, 0.5f, height);
  pcl::io::savePCDFileBinaryCompressed(file_name, *cloud);

  const auto normals = pcl::make_shared<pcl::PointCloud<pcl::Normal>>();
  pcl::NormalEstimationSweep<pcl::PointXYZ, pcl::Normal> normal_estimation;
  normal_estimation.setInputCloud(cloud);
  normal_estimation.setRadiusSearch(radius);
  normal_estimation.compute(*normals);

  pcl::PointCloud<pcl::INAD> inad;
  pcl::INADEstimation<pcl::PointXYZ, pcl::Normal> inad_estimation;
  inad_estimation.setInputCloud(cloud);
  inad_estimation.setInputNormals(normals);
  inad_estimation.setRadiusSearch(radius);
  inad_estimation.compute(inad);

  pcl::ShapeHistogram histogram(60, 60); // bins of 1.5 degrees
  histogram.add(inad);
  return histogram;
}
// [sample]

/** A flat sheet, a corrugated one and a dome, side by side. */
Cloud::Ptr
threeSheets(std::vector<std::size_t>& ends)
{
  auto cloud = pcl::make_shared<Cloud>();
  addSurface(*cloud, 0.0f, 0.3f, flat);
  ends.push_back(cloud->size());
  addSurface(*cloud, 0.4f, 0.3f, corrugated);
  ends.push_back(cloud->size());
  addSurface(*cloud, 0.8f, 0.3f, dome);
  ends.push_back(cloud->size());
  return cloud;
}

} // namespace

int
main()
{
  // [model]
  pcl::INADParameters parameters;
  parameters.normal_radius = radius;
  parameters.radius = radius;
  pcl::ShapeModel model(parameters);
  model.add("flat", sample(flat, "flat.pcd"));
  model.add("corrugated", sample(corrugated, "corrugated.pcd"));
  model.setFloor(1.0); // where both densities are below, the answer is: unknown
  model.save("sheets.json");
  // [model]

  // [find]
  std::vector<std::size_t> ends;
  const Cloud::Ptr cloud = threeSheets(ends);
  pcl::ShapeBackProjection<pcl::PointXYZ> back_projection;
  back_projection.setMode(back_projection.PAPER); // the radii are given
  back_projection.setModel(pcl::ShapeModel::load("sheets.json"));
  back_projection.setInputCloud(cloud);
  std::vector<pcl::PointIndices> classes;
  back_projection.segment(classes);
  // [find]

  // [count]
  pcl::PointCloud<pcl::PointXYZL> labeled;
  pcl::copyPointCloud(*cloud, labeled);
  for (std::size_t c = 0; c < classes.size(); ++c) {
    for (const pcl::index_t index : classes[c].indices) {
      labeled[static_cast<std::size_t>(index)].label =
          static_cast<std::uint32_t>(c + 1);
    }
  }
  const char* const sheets[] = {"flat sheet", "corrugated sheet", "dome"};
  std::size_t i = 0;
  for (std::size_t sheet = 0; sheet < ends.size(); ++sheet) {
    std::array<std::size_t, 3> counts{};
    for (; i < ends[sheet]; ++i)
      ++counts[labeled[i].label];
    std::cout << sheets[sheet] << ": " << counts[1] << " points flat, " << counts[2]
              << " corrugated, " << counts[0] << " unknown\n";
  }
  // [count]
  return pcl::io::savePCDFileBinaryCompressed("sheets.pcd", labeled) == 0 ? 0 : 1;
}
