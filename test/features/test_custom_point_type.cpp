// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Everything works with a point type that the library is not compiled for.

// Point types that the library is not compiled for.
#define PCL_NO_PRECOMPILE

#include "support/clouds.h"
#include "support/sweep.h"

#include <pcl/features/inad.h>
#include <pcl/features/normal_3d_sweep.h>
#include <pcl/search/brute_force.h>
#include <pcl/segmentation/shape_back_projection.h>
#include <pcl/segmentation/shape_edge_detection.h>

#include <gtest/gtest.h>

/** \brief The coordinates are neither at the beginning nor padded. */
struct LaserPoint {
  float time = 0.0f;
  float intensity = 0.0f;
  float x = 0.0f;
  float y = 0.0f;
  float z = 0.0f;
  float ring = 0.0f;

  Eigen::Map<Eigen::Vector3f>
  getVector3fMap()
  {
    return Eigen::Map<Eigen::Vector3f>(&x);
  }

  Eigen::Map<const Eigen::Vector3f>
  getVector3fMap() const
  {
    return Eigen::Map<const Eigen::Vector3f>(&x);
  }
};

/** \brief INAD with something more. */
struct LabeledINAD {
  float label = 7.0f;
  float sigma = 0.0f;
  float mu = 0.0f;
};

POINT_CLOUD_REGISTER_POINT_STRUCT(LaserPoint,
                                  (float, time, time)(float, intensity, intensity)(
                                      float, x, x)(float, y, y)(float, z, z)(float,
                                                                             ring,
                                                                             ring))
POINT_CLOUD_REGISTER_POINT_STRUCT(
    LabeledINAD, (float, label, label)(float, sigma, sigma)(float, mu, mu))

namespace {

using namespace pcl;
using namespace pcl::test;

class CustomPointType : public testing::Test {
protected:
  CustomPointType()
  {
    Random random(61);
    surface_ = dihedral(3000, 90, 0.1, random);
    cloud_ = toCloud<LaserPoint>(surface_);
  }

  Surface surface_;
  PointCloud<LaserPoint>::Ptr cloud_;
};

TEST_F(CustomPointType, Normals)
{
  NormalEstimationSweep<LaserPoint, Normal> estimation;
  estimation.setInputCloud(cloud_);
  estimation.setRadiusSearch(0.015);
  estimation.setViewPoint(0, 1, 1);
  PointCloud<Normal> normals;
  estimation.compute(normals);
  std::size_t right = 0;
  for (std::size_t i = 0; i < normals.size(); ++i) {
    right += std::abs(normals[i].getNormalVector3fMap().dot(
                 surface_.normal(i).cast<float>())) > 0.999f;
  }
  EXPECT_GT(right, normals.size() / 2);
}

TEST_F(CustomPointType, INADIntoACustomOutput)
{
  INADEstimation<LaserPoint, Normal, LabeledINAD> estimation;
  estimation.setInputCloud(cloud_);
  estimation.setInputNormals(trueNormalsOf<Normal>(surface_));
  estimation.setRadiusSearch(0.015);
  PointCloud<LabeledINAD> output;
  estimation.compute(output);
  const auto expected = sweptINAD(NeighborhoodSweep(surface_.points()),
                                  NeighborhoodSize::ofRadius(0.015),
                                  surface_.trueNormals());
  ASSERT_EQ(surface_.size(), output.size());
  for (std::size_t i = 0; i < output.size(); ++i) {
    ASSERT_EQ(expected[2 * i], output[i].mu);
    ASSERT_EQ(expected[2 * i + 1], output[i].sigma);
    ASSERT_EQ(7.0f, output[i].label);
  }
}

TEST_F(CustomPointType, SearchMethod)
{
  INADEstimation<LaserPoint, Normal> estimation;
  estimation.setInputCloud(cloud_);
  estimation.setInputNormals(trueNormalsOf<Normal>(surface_));
  estimation.setRadiusSearch(0.015);
  estimation.setOutlierRate(0);
  PointCloud<INAD> swept, found;
  estimation.compute(swept);
  estimation.setSearchMethod(make_shared<search::BruteForce<LaserPoint>>());
  estimation.compute(found);
  for (std::size_t i = 0; i < swept.size(); ++i)
    ASSERT_NEAR(swept[i].mu, found[i].mu, 1e-6);
}

TEST_F(CustomPointType, Detection)
{
  ShapeEdgeDetection<LaserPoint> edges;
  edges.setMode(ShapeEdgeDetection<LaserPoint>::PAPER);
  edges.setInputCloud(cloud_);
  edges.setInputNormals(trueNormalsOf<Normal>(surface_));
  PointIndices found;
  edges.segment(found);
  EXPECT_GT(found.indices.size(), 50U);
  for (const index_t i : found.indices) {
    const LaserPoint& p = (*cloud_)[static_cast<std::size_t>(i)];
    ASSERT_LT(std::hypot(p.y, p.z), 0.0061f);
  }
  ShapeBackProjection<LaserPoint> planes;
  planes.setInputCloud(cloud_);
  std::vector<PointIndices> classes;
  planes.segment(classes);
  ASSERT_EQ(2U, classes.size());
  EXPECT_GT(classes[0].indices.size(), 0U);
}

} // namespace
