// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Suction grasps on real scenes.

#include <pcl/io/pcd_io.h>
#include <pcl/segmentation/suction_grasp_estimation.h>

#include <gtest/gtest.h>

#include <string>

/** \brief A point and its distance to the nearest true crease. */
struct EIGEN_ALIGN16 CreasePointXYZ {
  PCL_ADD_POINT4D
  float crease_mm;
};

POINT_CLOUD_REGISTER_POINT_STRUCT(CreasePointXYZ,
                                  (float, x, x)(float, y, y)(float, z, z)(float,
                                                                          crease_mm,
                                                                          crease_mm))

namespace {

using namespace pcl;

/** \brief True if no crease runs through the cup. */
bool
isFreeOfCreases(const PointCloud<CreasePointXYZ>& truth,
                const SuctionGrasp& grasp,
                float radius)
{
  constexpr float on_a_crease = 1.5f; // millimeters, as the points are apart
  for (const CreasePointXYZ& point : truth) {
    const float distance = (point.getVector3fMap() - grasp.position).norm();
    if (distance < radius && point.crease_mm < on_a_crease)
      return false;
  }
  return true;
}

TEST(SuctionGraspsOfRealScenes, AreFreeOfCreases)
{
  if (std::string(PCL_SHAPE_TEST_DATA).empty())
    GTEST_SKIP() << "PCL_SHAPE_TEST_DATA is not set: no scenes";
  PointCloud<CreasePointXYZ> truth;
  const std::string file = std::string(PCL_SHAPE_TEST_DATA) + "/osd/learn33_gt.pcd";
  ASSERT_EQ(0, io::loadPCDFile(file, truth)) << file;
  const auto cloud = make_shared<PointCloud<PointXYZ>>();
  for (const CreasePointXYZ& point : truth)
    cloud->emplace_back(point.x, point.y, point.z);
  SuctionGraspEstimation<PointXYZ> estimation;
  estimation.setInputCloud(cloud);
  std::vector<SuctionGrasp> grasps;
  ASSERT_TRUE(estimation.compute(grasps));
  double sealing = 0, free = 0;
  for (const SuctionGrasp& grasp : grasps) {
    if (grasp.seals()) {
      sealing += 1;
      free += isFreeOfCreases(truth, grasp, 0.01f) ? 1 : 0;
    }
  }
  EXPECT_GE(sealing, 50);
  EXPECT_GE(free, 0.98 * sealing);
}

} // namespace
