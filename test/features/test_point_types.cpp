// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// The library's point types all give the same results.

#include "support/clouds.h"

#include <pcl/features/inad.h>
#include <pcl/features/normal_3d_sweep.h>
#include <pcl/point_types.h>

#include <gtest/gtest.h>

namespace {

using namespace pcl;
using namespace pcl::test;

Surface
tube()
{
  Random random(51);
  return cylinder(1500, 0.03, 0.1, random);
}

template <typename PointT, typename PointNT>
std::vector<float>
pipeline()
{
  const auto cloud = toCloud<PointT>(tube());
  NormalEstimationSweep<PointT, PointNT> normal_estimation;
  normal_estimation.setInputCloud(cloud);
  normal_estimation.setRadiusSearch(0.015);
  const auto normals = make_shared<PointCloud<PointNT>>();
  normal_estimation.compute(*normals);

  INADEstimation<PointT, PointNT> estimation;
  estimation.setInputCloud(cloud);
  estimation.setInputNormals(normals);
  estimation.setRadiusSearch(0.015);
  PointCloud<INAD> inad;
  estimation.compute(inad);

  std::vector<float> values = normalValuesOf(*normals);
  const std::vector<float> angles = valuesOf(inad);
  values.insert(values.end(), angles.begin(), angles.end());
  return values;
}

template <typename PointT>
class PointTypes : public testing::Test {};

using Types = testing::Types<PointXYZ,
                             PointXYZI,
                             PointXYZRGB,
                             PointXYZRGBA,
                             PointXYZL,
                             PointXYZRGBL,
                             PointNormal,
                             PointXYZINormal,
                             PointXYZRGBNormal,
                             PointXYZLNormal>;
TYPED_TEST_SUITE(PointTypes, Types);

TYPED_TEST(PointTypes, AllGiveTheSame)
{
  static const std::vector<float> expected = pipeline<PointXYZ, Normal>();
  ASSERT_EQ(6U * 1500, expected.size());
  EXPECT_GT(expected.back(), 0.0f);
  EXPECT_EQ(expected, (pipeline<TypeParam, Normal>()));
  EXPECT_EQ(expected, (pipeline<TypeParam, PointNormal>()));
  EXPECT_EQ(expected, (pipeline<TypeParam, PointXYZRGBNormal>()));
}

/** \brief The coordinates of an output with coordinates stay as they are. */
TEST(PointTypesAlone, OneCloudOfPointsAndNormals)
{
  const auto cloud = toCloud<PointNormal>(tube());
  NormalEstimationSweep<PointNormal, PointNormal> estimation;
  estimation.setInputCloud(cloud);
  estimation.setRadiusSearch(0.015);
  PointCloud<PointNormal> output = *cloud;
  estimation.compute(output);
  for (std::size_t i = 0; i < output.size(); ++i) {
    ASSERT_EQ((*cloud)[i].x, output[i].x);
    ASSERT_EQ((*cloud)[i].z, output[i].z);
  }
}

TEST(PointTypesAlone, INADIsTwoFloats)
{
  std::ostringstream text;
  text << INAD{0.5f, 0.25f};
  EXPECT_EQ("(0.5,0.25)", text.str());
  EXPECT_EQ(2 * sizeof(float), sizeof(INAD));
  EXPECT_EQ(0.0f, INAD().mu);
}

} // namespace
