// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Estimations and detectors that share an index sort the cloud once.

// An index that a class is given is the one that it uses: a class that lost it on the
// way would give the same results, but sort elsewhere.

#include "support/clouds.h"

#include <pcl/features/inad.h>
#include <pcl/features/normal_3d_sweep.h>
#include <pcl/search/kdtree.h>
#include <pcl/segmentation/shape_back_projection.h>
#include <pcl/segmentation/shape_edge_detection.h>
#include <pcl/features/impl/neighborhoods.hpp>

#include <gtest/gtest.h>

#include <numeric>

namespace {

using namespace pcl;
using namespace pcl::test;
using Cloud = PointCloud<PointXYZ>;
using Normals = PointCloud<Normal>;

class SharedIndex : public testing::Test {
protected:
  SharedIndex()
  {
    Random random(53);
    const Surface fold = dihedral(4000, 120, 0.16, random);
    cloud_ = toCloud<PointXYZ>(fold);
    normals_ = trueNormalsOf<Normal>(fold);
  }

  template <typename Estimation, typename Output>
  void
  estimate(Estimation&& estimation, double radius, Output& output) const
  {
    estimation.setInputCloud(cloud_);
    estimation.setRadiusSearch(radius);
    estimation.setSweepIndex(index_);
    EXPECT_EQ(estimation.getSweepIndex(), index_);
    estimation.compute(output);
    ASSERT_EQ(output.size(), cloud_->size());
  }

  void
  estimateNormals(double radius) const
  {
    Normals normals;
    estimate(NormalEstimationSweep<PointXYZ, Normal>(1), radius, normals);
  }

  void
  estimateINAD(double radius, const search::Search<PointXYZ>::Ptr& search) const
  {
    INADEstimation<PointXYZ, Normal> estimation(1);
    estimation.setInputNormals(normals_);
    estimation.setSearchMethod(search);
    PointCloud<INAD> inad;
    estimate(estimation, radius, inad);
  }

  template <typename Detection>
  std::size_t
  sortsOfDetection(Detection&& detection) const
  {
    const std::size_t before = index_->getSortCount();
    detection.setInputCloud(cloud_);
    detection.setSweepIndex(index_);
    PointCloud<Intensity> likelihood;
    detection.compute(likelihood);
    EXPECT_EQ(likelihood.size(), cloud_->size());
    return index_->getSortCount() - before;
  }

  Cloud::Ptr cloud_;
  Normals::Ptr normals_;
  const SweepIndex::Ptr index_ = std::make_shared<SweepIndex>();
};

TEST_F(SharedIndex, OfNormalsAndINADIsSortedOnce)
{
  estimateNormals(0.01);
  EXPECT_EQ(index_->getSortCount(), 1u);
  estimateNormals(0.01);
  estimateINAD(0.01, nullptr);
  EXPECT_EQ(index_->getSortCount(), 1u);
}

TEST_F(SharedIndex, OfINADAloneIsUsed)
{
  estimateINAD(0.01, nullptr);
  EXPECT_EQ(index_->getSortCount(), 1u);
}

TEST_F(SharedIndex, SaysNothingWithASearchMethod)
{
  estimateINAD(0.01, make_shared<search::KdTree<PointXYZ>>());
  EXPECT_EQ(index_->getSortCount(), 0u);
}

TEST_F(SharedIndex, OfSomeOfThePointsIsThatOfAll)
{
  Indices some(100);
  std::iota(some.begin(), some.end(), 0);
  const XYZView points = detail::xyzOf(*cloud_);
  detail::Neighborhoods neighborhoods(points, 1);
  neighborhoods.setIndex(index_);
  std::vector<float> distances(points.size);
  neighborhoods.among(some).computeDistanceToNearest(12, distances.data());
  EXPECT_EQ(index_->getSortCount(), 1u);
  neighborhoods.computeDistanceToNearest(12, distances.data());
  EXPECT_EQ(index_->getSortCount(), 1u);
}

TEST_F(SharedIndex, OfADetectorWithNormalsServesItsINAD)
{
  ShapeBackProjection<PointXYZ, Normal> detection;
  detection.setMode(ShapeBackProjection<PointXYZ, Normal>::PAPER);
  detection.setInputNormals(normals_);
  detection.setRadius(0.01);
  EXPECT_EQ(sortsOfDetection(detection), 1u);
  EXPECT_EQ(sortsOfDetection(detection), 0u);
}

// Rows of normals follow from their radius alone, so that these two need rows each.
TEST_F(SharedIndex, OfADetectorServesItsNormals)
{
  ShapeEdgeDetection<PointXYZ, Normal> detection;
  detection.setMode(ShapeEdgeDetection<PointXYZ, Normal>::PAPER);
  detection.setNormalRadius(0.15);
  detection.setRadius(0.005);
  EXPECT_EQ(sortsOfDetection(detection), 2u);
}

TEST_F(SharedIndex, OfAnAdaptiveDetectorIsUsed)
{
  ShapeEdgeDetection<PointXYZ, Normal> detection;
  ASSERT_EQ(detection.getMode(), detection.DEFAULT);
  EXPECT_GE(sortsOfDetection(detection), 1u);
}

} // namespace
