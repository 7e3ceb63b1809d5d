/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * Point Cloud Library (PCL) - www.pointclouds.org
 * Copyright (c) 2026, pcl_shape contributors
 *
 * All rights reserved
 */

#pragma once

#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

/** \brief What both pipelines do: normals over 10 mm; INAD over 6 and 20 mm; of each,
 * the histogram (10 x 10 bins over 90 degrees) and its likelihood at every point. */
struct PipelineResult {
  std::array<std::vector<float>, 2> mu, sigma, likelihood;
  std::uint64_t neighbors = 0; ///< of both INAD, the points themselves not counted
};

constexpr double normal_radius = 0.010;
constexpr std::array<double, 2> inad_radii{0.006, 0.020};
constexpr double outlier_rate = 2.0;
constexpr std::size_t bins = 10;

using Cloud = pcl::PointCloud<pcl::PointXYZ>;

/** \brief As a user of PCL writes it: NormalEstimationOMP, then a loop over
 * radiusSearch(). \param[in] sorted the argument of pcl::search::KdTree */
PipelineResult runPcl(const Cloud::ConstPtr& cloud, bool sorted, int threads);

/** \brief The same with NormalEstimationSweep and INADEstimation. */
PipelineResult runShape(const Cloud::ConstPtr& cloud, unsigned threads);

/** \brief The neighbors that runShape() goes through. */
std::uint64_t countShapeNeighbors(const Cloud& cloud, unsigned threads);
