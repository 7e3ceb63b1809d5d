// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// The classes on a field, and the ground, are compiled for PCL's usual point types.

#include "support/clouds.h"

#include <pcl/segmentation/shape_back_projection.h>
#include <pcl/segmentation/shape_edge_detection.h>
#include <pcl/segmentation/shape_ground_segmentation.h>
#include <pcl/segmentation/shape_instance_segmentation.h>
#include <pcl/segmentation/shape_labeling.h>
#include <pcl/segmentation/suction_grasp_estimation.h>

#include <gtest/gtest.h>

namespace {

using namespace pcl;
using namespace pcl::test;

constexpr std::size_t points = 6000;

Surface
fold()
{
  Random random(62);
  Surface surface = dihedral(points, 90, 0.16, random);
  surface.move(Eigen::Isometry3d(Eigen::Translation3d(0, 0, 0.5)));
  return surface;
}

void
append(std::vector<float>& values, const std::vector<float>& more)
{
  EXPECT_FALSE(more.empty());
  values.insert(values.end(), more.begin(), more.end());
}

template <typename PointT, typename PointNT>
std::vector<float>
detectedIn(const typename PointCloud<PointT>::Ptr& cloud)
{
  std::vector<float> values;
  std::vector<std::vector<float>> likelihoods;
  ShapeEdgeDetection<PointT, PointNT> edges;
  ShapeBackProjection<PointT, PointNT> surfaces;
  edges.setInputCloud(cloud);
  surfaces.setInputCloud(cloud);
  surfaces.setInputNormals(trueNormalsOf<PointNT>(fold()));
  edges.compute(likelihoods);
  append(values, likelihoods.at(0));
  surfaces.compute(likelihoods);
  append(values, likelihoods.at(0));

  ShapeLabeling<PointT> labeling;
  labeling.setInputCloud(cloud);
  PointLabels labels;
  labeling.label(labels);
  append(values, labels.confidence);
  return values;
}

/** What all classes find that need no normals. */
template <typename PointT>
std::vector<float>
foundIn(const typename PointCloud<PointT>::Ptr& cloud)
{
  std::vector<float> values;
  ShapeFieldEstimation<PointT> estimation;
  estimation.setInputCloud(cloud);
  const auto field = make_shared<ShapeField>();
  EXPECT_TRUE(estimation.compute(*field));
  append(values, field->edge_likelihood);

  ShapeInstanceSegmentation<PointT> segmentation;
  segmentation.setInputCloud(cloud);
  segmentation.setShapeField(field);
  segmentation.setClass("planar");
  std::vector<ShapeInstance> instances;
  EXPECT_TRUE(segmentation.segment(instances));
  EXPECT_FALSE(instances.empty());
  for (const ShapeInstance& instance : instances)
    append(values, {instance.indices.begin(), instance.indices.end()});

  SuctionGraspEstimation<PointT> grasp_estimation;
  grasp_estimation.setInputCloud(cloud);
  grasp_estimation.setShapeField(field);
  std::vector<SuctionGrasp> grasps;
  EXPECT_TRUE(grasp_estimation.compute(grasps));
  EXPECT_FALSE(grasps.empty());
  for (const SuctionGrasp& grasp : grasps)
    append(values, {grasp.position.x(), grasp.position.z(), grasp.score});

  ShapeGroundSegmentation<PointT> ground;
  ground.setInputCloud(cloud);
  std::vector<float> likelihood;
  ground.compute(likelihood);
  append(values, likelihood);
  return values;
}

template <typename PointT>
class FieldOfPointType : public testing::Test {};

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
TYPED_TEST_SUITE(FieldOfPointType, Types);

TYPED_TEST(FieldOfPointType, AllFindTheSame)
{
  static const std::vector<float> expected =
      foundIn<PointXYZ>(toCloud<PointXYZ>(fold()));
  EXPECT_TRUE(sameBits(expected, foundIn<TypeParam>(toCloud<TypeParam>(fold()))));
}

TYPED_TEST(FieldOfPointType, AllDetectTheSameWithAnyNormals)
{
  static const std::vector<float> expected =
      detectedIn<PointXYZ, Normal>(toCloud<PointXYZ>(fold()));
  const auto cloud = toCloud<TypeParam>(fold());
  EXPECT_TRUE(sameBits(expected, detectedIn<TypeParam, Normal>(cloud)));
  EXPECT_TRUE(sameBits(expected, detectedIn<TypeParam, PointNormal>(cloud)));
  EXPECT_TRUE(sameBits(expected, detectedIn<TypeParam, PointXYZRGBNormal>(cloud)));
}

/** \brief Normals of a type that the detectors are not compiled for. */
template <typename PointNT>
void
expectNormalsAreTaken()
{
  const auto fieldWith = [](const auto& cloud, const auto& normals) {
    using PointT = typename std::decay_t<decltype(*cloud)>::PointType;
    ShapeFieldEstimation<PointT> estimation;
    estimation.setInputCloud(cloud);
    estimation.setInputNormals(normals);
    ShapeField field;
    EXPECT_TRUE(estimation.compute(field));
    return field.edge_likelihood;
  };
  const Surface surface = fold();
  const auto cloud = toCloud<PointNT>(surface);
  for (std::size_t i = 0; i < points; ++i)
    (*cloud)[i].getNormalVector3fMap() = surface.normal(i).cast<float>();
  EXPECT_TRUE(
      sameBits(fieldWith(toCloud<PointXYZ>(surface), trueNormalsOf<Normal>(surface)),
               fieldWith(cloud, cloud)));
}

TEST(FieldOfPointTypes, ACloudMayBeItsOwnNormals)
{
  expectNormalsAreTaken<PointNormal>();
  expectNormalsAreTaken<PointXYZINormal>();
  expectNormalsAreTaken<PointXYZLNormal>();
}

} // namespace
