// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// The fixture of what both detectors do alike.

#pragma once

#include "support/clouds.h"
#include "support/differences.h"

#include <pcl/features/inad.h>
#include <pcl/features/normal_3d_omp.h>
#include <pcl/segmentation/shape_back_projection.h>
#include <pcl/segmentation/shape_edge_detection.h>

#include <gtest/gtest.h>

#include <vector>

/** What the tests of both detectors share. */
namespace pcl::test {

using Cloud = PointCloud<PointXYZ>;
using Likelihoods = std::vector<std::vector<float>>;

class BackProjectionOf : public ShapeBackProjection<PointXYZ> {
public:
  static INADParameters
  defaults()
  {
    return INADParameters::surfaces();
  }

  static constexpr std::size_t plane_class = 0;
};

class EdgesOf : public ShapeEdgeDetection<PointXYZ> {
public:
  static INADParameters
  defaults()
  {
    return INADParameters::edges();
  }

  static constexpr std::size_t plane_class = 1;
};

/** \brief What both detectors do alike: two planes at a right angle, and two points
 * that are too far away to have neighbors. */
template <typename Detection>
class ShapeDetectionTest : public testing::Test {
protected:
  ShapeDetectionTest()
  {
    Random random(71);
    surface_ = dihedral(8000, 90, 0.16, random);
    surface_.add(SurfacePoint{{5, 5, 5}, {0, 0, 1}});
    surface_.add(SurfacePoint{{-5, 5, 5}, {0, 0, 1}});
    cloud_ = toCloud<PointXYZ>(surface_);
    detection_.setInputCloud(cloud_);
    detection_.setMode(Detection::PAPER);
  }

  PointCloud<Normal>::Ptr
  estimatedNormals() const
  {
    NormalEstimationOMP<PointXYZ, Normal> estimation;
    estimation.setInputCloud(cloud_);
    estimation.setRadiusSearch(Detection::defaults().normal_radius);
    const auto normals = make_shared<PointCloud<Normal>>();
    estimation.compute(*normals);
    return normals;
  }

  PointCloud<INAD>::Ptr
  estimatedINAD() const
  {
    INADEstimation<PointXYZ, Normal> estimation;
    estimation.setInputCloud(cloud_);
    estimation.setInputNormals(estimatedNormals());
    estimation.setRadiusSearch(Detection::defaults().radius);
    const auto inad = make_shared<PointCloud<INAD>>();
    estimation.compute(*inad);
    return inad;
  }

  Likelihoods
  likelihoods()
  {
    Likelihoods result;
    detection_.compute(result);
    return result;
  }

  std::vector<PointIndices>
  segments()
  {
    std::vector<PointIndices> result;
    detection_.segment(result);
    return result;
  }

  static double
  shareOfEqual(const std::vector<float>& a, const std::vector<float>& b)
  {
    Differences differences;
    differences.add(a, b);
    return differences.within(1e-6);
  }

  Surface surface_;
  Cloud::Ptr cloud_;
  Detection detection_;
};

using Detections = testing::Types<BackProjectionOf, EdgesOf>;

} // namespace pcl::test
