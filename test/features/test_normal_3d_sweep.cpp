// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// NormalEstimationSweep agrees with NormalEstimationOMP.

#include "support/clouds.h"
#include "support/differences.h"
#include "support/reference.h"

#include <pcl/features/inad.h>
#include <pcl/features/normal_3d_omp.h>
#include <pcl/features/normal_3d_sweep.h>

#include <gtest/gtest.h>

#include <limits>

namespace {

using namespace pcl;
using namespace pcl::test;

using Cloud = PointCloud<PointXYZ>;

/** \brief In radius and in k mode. */
class NormalEstimationSweepTest : public testing::TestWithParam<bool> {
protected:
  NormalEstimationSweepTest()
  {
    Random random(41);
    scene_ = mixedScene(6000, random);
    scene_.addNoise(0.0005, random);
    cloud_ = toCloud<PointXYZ>(scene_);
    configure(estimation_);
    configure(peer_);
  }

  template <typename Estimation>
  void
  configure(Estimation& estimation) const
  {
    estimation.setInputCloud(cloud_);
    if (GetParam())
      estimation.setKSearch(40);
    else
      estimation.setRadiusSearch(0.02);
  }

  /** \brief Directions, signs and curvatures against NormalEstimationOMP. */
  void
  expectLikePeer()
  {
    PointCloud<Normal> mine, its;
    estimation_.compute(mine);
    peer_.compute(its);
    ASSERT_EQ(its.size(), mine.size());
    Differences angles, curvatures;
    for (std::size_t i = 0; i < mine.size(); ++i) {
      const Eigen::Vector3d a = mine[i].getNormalVector3fMap().cast<double>();
      const Eigen::Vector3d b = its[i].getNormalVector3fMap().cast<double>();
      angles.add(0, 2 * std::asin(std::min(1.0, (a - b).norm() / 2)));
      curvatures.add(its[i].curvature, mine[i].curvature);
    }
    EXPECT_GT(angles.known(), mine.size() / 2);
    EXPECT_GE(angles.within(1e-4), 0.99);
    EXPECT_GE(curvatures.within(1e-5), 0.99);
  }

  Surface scene_;
  Cloud::Ptr cloud_;
  NormalEstimationSweep<PointXYZ, Normal> estimation_;
  NormalEstimationOMP<PointXYZ, Normal> peer_;
};

TEST_P(NormalEstimationSweepTest, IsLikeNormalEstimationOMP) { expectLikePeer(); }

Eigen::Vector3f
viewPointOf(const NormalEstimationSweep<PointXYZ, Normal>& estimation)
{
  Eigen::Vector3f point;
  estimation.getViewPoint(point.x(), point.y(), point.z());
  return point;
}

TEST_P(NormalEstimationSweepTest, ViewPoint)
{
  estimation_.setViewPoint(0.1f, 0.2f, 3.0f);
  peer_.setViewPoint(0.1f, 0.2f, 3.0f);
  EXPECT_EQ(Eigen::Vector3f(0.1f, 0.2f, 3.0f), viewPointOf(estimation_));
  expectLikePeer();
  estimation_.useSensorOriginAsViewPoint();
  peer_.useSensorOriginAsViewPoint();
  expectLikePeer();
}

TEST_P(NormalEstimationSweepTest, SensorOrigin)
{
  cloud_->sensor_origin_ = Eigen::Vector4f(0.3f, -1.0f, 0.9f, 0.0f);
  configure(peer_);
  EXPECT_EQ(Eigen::Vector3f(0.3f, -1.0f, 0.9f), viewPointOf(estimation_));
  expectLikePeer();
}

TEST_P(NormalEstimationSweepTest, NormalsFaceTheViewPoint)
{
  estimation_.setViewPoint(0.1f, 0.2f, 3.0f);
  PointCloud<Normal> normals;
  estimation_.compute(normals);
  for (std::size_t i = 0; i < normals.size(); ++i) {
    const Eigen::Vector3f n = normals[i].getNormalVector3fMap();
    const Eigen::Vector3f to_view =
        Eigen::Vector3f(0.1f, 0.2f, 3.0f) - (*cloud_)[i].getVector3fMap();
    ASSERT_GE(n.dot(to_view), -1e-6f) << i;
  }
}

TEST_P(NormalEstimationSweepTest, IndicesAndSearchSurface)
{
  Random random(42);
  scene_.addNoise(0.001, random);
  const auto queries = toCloud<PointXYZ>(scene_);
  const auto indices = indicesOf({7, 3, 5998, 3, 2500});
  const auto surface = cloud_;
  for (Feature<PointXYZ, Normal>* each :
       {static_cast<Feature<PointXYZ, Normal>*>(&estimation_),
        static_cast<Feature<PointXYZ, Normal>*>(&peer_)}) {
    each->setInputCloud(queries);
    each->setSearchSurface(surface);
    each->setIndices(indices);
  }
  PointCloud<Normal> mine, its;
  estimation_.compute(mine);
  peer_.compute(its);
  ASSERT_EQ(indices->size(), mine.size());
  for (std::size_t i = 0; i < mine.size(); ++i) {
    EXPECT_NEAR(0,
                (mine[i].getNormalVector3fMap() - its[i].getNormalVector3fMap()).norm(),
                1e-3);
  }
}

TEST_P(NormalEstimationSweepTest, BadPointsWhateverTheCloudSaysOfItself)
{
  constexpr float nan = std::numeric_limits<float>::quiet_NaN();
  for (std::size_t i = 0; i < cloud_->size(); i += 5)
    (*cloud_)[i].z = nan;
  for (const bool is_dense : {false, true}) {
    cloud_->is_dense = is_dense;
    PointCloud<Normal> normals;
    estimation_.compute(normals);
    ASSERT_EQ(cloud_->size(), normals.size());
    EXPECT_FALSE(normals.is_dense);
    for (std::size_t i = 0; i < normals.size(); ++i) {
      ASSERT_EQ(i % 5 == 0, std::isnan(normals[i].normal_x)) << i;
      ASSERT_EQ(i % 5 == 0, std::isnan(normals[i].curvature)) << i;
    }
  }
}

TEST_P(NormalEstimationSweepTest, OrganizedOutputAndSecondCompute)
{
  PointCloud<Normal> normals;
  estimation_.compute(normals);
  EXPECT_EQ(1U, normals.height);
  estimation_.setInputCloud(depthImage<PointXYZ>(64, 48));
  if (!GetParam())
    estimation_.setRadiusSearch(0.05);
  estimation_.compute(normals);
  EXPECT_EQ(64U, normals.width);
  EXPECT_EQ(48U, normals.height);
  EXPECT_TRUE(normals.is_dense);
  const Eigen::Vector3d wall = Eigen::Vector3d(-0.3, -0.2, -1).normalized();
  EXPECT_NEAR(
      0, acuteAngle(wall, normals(2, 2).getNormalVector3fMap().cast<double>()), 1e-3);
}

/** \brief What users of PCL have: normals by NormalEstimationOMP, then INAD. */
TEST_P(NormalEstimationSweepTest, EitherGivesTheSameINAD)
{
  PointCloud<INAD> from_mine, from_its;
  const auto mine = make_shared<PointCloud<Normal>>();
  const auto its = make_shared<PointCloud<Normal>>();
  estimation_.compute(*mine);
  peer_.compute(*its);
  INADEstimation<PointXYZ, Normal> inad;
  configure(inad);
  inad.setOutlierRate(0);
  inad.setInputNormals(mine);
  inad.compute(from_mine);
  inad.setInputNormals(its);
  inad.compute(from_its);
  Differences differences;
  differences.add(valuesOf(from_mine), valuesOf(from_its));
  EXPECT_GT(differences.known(), cloud_->size());
  EXPECT_GE(differences.within(1e-4), 0.99);
}

INSTANTIATE_TEST_SUITE_P(,
                         NormalEstimationSweepTest,
                         testing::Bool(),
                         [](const auto& test) {
                           return test.param ? "Nearest" : "Radius";
                         });

} // namespace
