// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Voxel means, and every class with a resolution.

#include "detection_scenes.h"
#include "geometry/voxel_means.h"
#include "support/errors.h"

#include <pcl/segmentation/shape_back_projection.h>
#include <pcl/segmentation/shape_instance_segmentation.h>
#include <pcl/segmentation/shape_labeling.h>
#include <pcl/segmentation/suction_grasp_estimation.h>

#include <gtest/gtest.h>

#include <array>
#include <limits>
#include <map>
#include <numeric>

// Work on means of points, for the results of all points: setResolution().
namespace {

using namespace pcl;
using namespace pcl::test;

constexpr float nan = std::numeric_limits<float>::quiet_NaN();

Surface
scatteredPoints(std::size_t count)
{
  Random random(31);
  Surface surface;
  for (std::size_t i = 0; i < count; ++i) {
    surface.add({{random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(2, 3)},
                 {0, 0, 1}});
  }
  return surface;
}

std::vector<float>
shuffled(const std::vector<float>& xyz)
{
  std::vector<std::size_t> order(xyz.size() / 3);
  std::iota(order.begin(), order.end(), 0);
  Random random(32);
  for (std::size_t i = order.size(); i > 1; --i)
    std::swap(order[i - 1], order[random.index(i)]);
  std::vector<float> result;
  for (const std::size_t i : order)
    result.insert(result.end(), &xyz[3 * i], &xyz[3 * i] + 3);
  return result;
}

scene::Scene
denseScene(std::uint64_t seed, std::uint32_t width)
{
  scene::SceneOptions options;
  options.seed = seed;
  options.width = width;
  options.height = width / 4 * 3;
  return scene::generateScene(options);
}

TEST(Thinning, MeansOfCells)
{
  constexpr double size = 0.07;
  const Surface surface = scatteredPoints(5000);
  struct Sum {
    Eigen::Vector3d position = Eigen::Vector3d::Zero();
    double count = 0;
  };
  std::map<std::array<double, 3>, Sum> cells;
  for (std::size_t i = 0; i < surface.size(); ++i) {
    const Eigen::Vector3d p = surface.position(i);
    const Eigen::Array3d cell = (p.array() / size).floor();
    Sum& sum = cells[{cell.z(), cell.y(), cell.x()}];
    sum.position += p;
    sum.count += 1;
  }
  const std::vector<float> thin = detail::voxelMeans(surface.points(), size);
  ASSERT_EQ(3 * cells.size(), thin.size());
  std::size_t k = 0;
  for (const auto& [cell, sum] : cells) {
    const Eigen::Vector3d mean = sum.position / sum.count;
    const auto found = Eigen::Map<const Eigen::Vector3f>(&thin[3 * k++]).cast<double>();
    EXPECT_LE((found - mean).norm(), 5e-7);
  }
}

TEST(Thinning, TheOrderDoesNotMatterAndPointsThatAreNotFiniteAreLeftOut)
{
  std::vector<float> xyz = scatteredPoints(5000).xyz;
  const std::vector<float> expected = detail::voxelMeans({xyz.data(), 3, 5000}, 0.2);
  xyz.insert(xyz.end(), {0.5f, nan, 2.5f});
  xyz = shuffled(xyz);
  EXPECT_TRUE(sameBits(expected, detail::voxelMeans({xyz.data(), 3, 5001}, 0.2)));
}

TEST(Thinning, CellsOfOnePointKeepIt)
{
  const std::vector<float> xyz{-3.25f, 1e-3f, 7.0f, 5.0f, -2.0f, 8.5f};
  const std::vector<float> thin = detail::voxelMeans({xyz.data(), 3, 2}, 1e-3);
  ASSERT_EQ(6U, thin.size());
  for (std::size_t i = 0; i < 6; ++i)
    EXPECT_NEAR(xyz[i], thin[i], 1e-9 + 6e-8 * std::abs(xyz[i]));
}

template <typename Class>
class Resolution : public testing::Test {};
using Classes =
    testing::Types<ShapeBackProjection<PointXYZ>, ShapeEdgeDetection<PointXYZ>>;
TYPED_TEST_SUITE(Resolution, Classes);

TYPED_TEST(Resolution, IsASearchSurfaceOfMeans)
{
  const auto cloud = cloudOf(sampledScene(26));
  constexpr double resolution = 0.006;
  TypeParam detection;
  detection.setResolution(resolution);
  EXPECT_EQ(resolution, detection.getResolution());
  const Likelihoods found = likelihoodsOf(detection, cloud);

  const std::vector<float> xyz = detail::voxelMeans(
      {cloud->front().data, sizeof(PointXYZ) / sizeof(float), cloud->size()},
      resolution);
  const auto surface = make_shared<Cloud>();
  for (std::size_t i = 0; i < xyz.size(); i += 3)
    surface->emplace_back(xyz[i], xyz[i + 1], xyz[i + 2]);
  EXPECT_LT(surface->size(), cloud->size() / 2);
  TypeParam other;
  other.setSearchSurface(surface);
  const Likelihoods expected = likelihoodsOf(other, cloud);
  ASSERT_EQ(expected.size(), found.size());
  EXPECT_TRUE(sameBits(expected[0], found[0]));
}

TYPED_TEST(Resolution, ThreadsDoNotMatter)
{
  const auto cloud = cloudOf(sampledScene(27));
  TypeParam one, three;
  one.setNumberOfThreads(1);
  three.setNumberOfThreads(3);
  one.setResolution(0.004);
  three.setResolution(0.004);
  EXPECT_TRUE(sameBits(likelihoodsOf(one, cloud)[0], likelihoodsOf(three, cloud)[0]));
}

TYPED_TEST(Resolution, AllPointsAreKnown)
{
  Random random(33);
  const auto cloud = toCloud<PointXYZ>(plane(20000, 0.2, random));
  cloud->push_back(PointXYZ(0.1f, nan, 0.0f));
  TypeParam detection;
  detection.setResolution(0.005);
  const std::vector<float> likelihood = likelihoodsOf(detection, cloud)[0];
  ASSERT_EQ(20001U, likelihood.size());
  EXPECT_TRUE(std::isnan(likelihood.back()));
  EXPECT_TRUE(std::all_of(likelihood.begin(), likelihood.end() - 1, [](float value) {
    return std::isfinite(value);
  }));
}

TYPED_TEST(Resolution, BadOnesAreRefused)
{
  Random random(34);
  TypeParam detection;
  detection.setInputCloud(toCloud<PointXYZ>(plane(500, 2.0, random)));
  const auto expectRefused = [&](const std::vector<std::string>& parts) {
    Likelihoods likelihoods(3);
    expectParts(errorsOf([&] { detection.compute(likelihoods); }), parts);
    EXPECT_TRUE(likelihoods.empty());
  };
  for (const auto& [resolution, text] :
       {std::pair(-0.01, "resolution is -0.01 m"),
        std::pair(std::numeric_limits<double>::infinity(), "resolution is inf m"),
        std::pair(static_cast<double>(nan), "resolution is nan m")}) {
    detection.setResolution(resolution);
    expectRefused({text, "positive and finite, or 0"});
  }
  detection.setResolution(1e-9);
  expectRefused({"resolution is 1e-09 m", "or more, what a float holds"});
  detection.setResolution(2.0);
  expectRefused({"resolution is 2 m", "less than the cloud's extent"});
  detection.setResolution(0.01);
  detection.setMode(TypeParam::PAPER);
  expectRefused({"a resolution is set", "DEFAULT mode"});
}

TEST(Resolution, SurfacesOfADenseDepthImage)
{
  const scene::Scene scene = denseScene(28, 1280);
  ShapeFieldEstimation<PointXYZ> estimation;
  estimation.setInputCloud(cloudOf(scene));
  ShapeField field;
  ASSERT_TRUE(estimation.compute(field));
  const double own = f1(field.likelihoods[1], scene.surface, 2, 1);
  EXPECT_GE(own, 0.95);
  EXPECT_GT(field.resolution, 0.001); // the depth's steps are seen from farther away
  EXPECT_LT(field.resolution, 0.004);
  estimation.setResolution(0.002);
  ASSERT_TRUE(estimation.compute(field));
  const double coarse = f1(field.likelihoods[1], scene.surface, 2, 1);
  EXPECT_GE(coarse, 0.95);
  EXPECT_NEAR(largestCurvedRadius(field), 1.2, 0.3); // 300 spacings of two means
}

/** The steps of a Kinect's depth, sampled so densely that each looks like a face of its
 * own: means that are coarser are taken. */
TEST(Resolution, StepsOfDepthAreNoEdges)
{
  const scene::Scene scene = denseScene(30, 1920);
  ShapeEdgeDetection<PointXYZ> detection;
  const auto likelihoods = likelihoodsOf(detection, cloudOf(scene));
  EXPECT_GE(f1(likelihoods[0], scene.edge, 1, 0), 0.80);
}

TEST(Resolution, OfLabelsInstancesAndGrasps)
{
  const auto cloud = cloudOf(sampledScene(29));
  const std::string refused = "resolution is 1e-12 m";
  ShapeLabeling<PointXYZ> labeling;
  labeling.setInputCloud(cloud);
  labeling.setResolution(1e-12);
  PointLabels labels;
  expectParts(errorsOf([&] { labeling.label(labels); }), {refused});
  EXPECT_TRUE(labels.labels.empty());
  labeling.setResolution(0.004);
  labeling.label(labels);
  EXPECT_EQ(cloud->size(), labels.labels.size());

  ShapeInstanceSegmentation<PointXYZ> segmentation;
  segmentation.setInputCloud(cloud);
  segmentation.setClass("object");
  segmentation.setResolution(1e-12);
  std::vector<ShapeInstance> instances;
  expectParts(errorsOf([&] { EXPECT_FALSE(segmentation.segment(instances)); }),
              {refused});
  segmentation.setResolution(0.004);
  EXPECT_TRUE(segmentation.segment(instances));
  EXPECT_FALSE(instances.empty());

  SuctionGraspEstimation<PointXYZ> estimation;
  estimation.setInputCloud(cloud);
  estimation.setResolution(1e-12);
  std::vector<SuctionGrasp> grasps;
  expectParts(errorsOf([&] { EXPECT_FALSE(estimation.compute(grasps)); }), {refused});
  estimation.setResolution(0.004);
  EXPECT_TRUE(estimation.compute(grasps));
  EXPECT_FALSE(grasps.empty());
}

/** The share of each object's points that its most frequent instance has, 0 where
 * another object has more of it. */
std::vector<double>
sharesFound(const std::vector<ShapeInstance>& instances, const Labels& truth)
{
  std::map<std::uint32_t, double> sizes;
  for (const std::uint32_t object : truth)
    sizes[object] += 1.0;
  std::map<std::uint32_t, double> most;
  for (const ShapeInstance& instance : instances) {
    std::map<std::uint32_t, double> counts;
    for (const index_t index : instance.indices)
      counts[truth[static_cast<std::size_t>(index)]] += 1.0;
    const auto best = std::max_element(
        counts.begin(), counts.end(), [](const auto& a, const auto& b) {
          return a.second < b.second;
        });
    most[best->first] = std::max(most[best->first], best->second);
  }
  std::vector<double> shares;
  for (const auto& [object, size] : sizes)
    if (object != 0)
      shares.push_back(most[object] / size);
  return shares;
}

TEST(Resolution, ObjectsOfADenseDepthImage)
{
  const scene::Scene scene = denseScene(31, 1280);
  ShapeInstanceSegmentation<PointXYZ> segmentation;
  segmentation.setInputCloud(cloudOf(scene));
  segmentation.setClass("object");
  segmentation.setResolution(0.003);
  std::vector<ShapeInstance> instances;
  ASSERT_TRUE(segmentation.segment(instances));
  const std::vector<double> shares = sharesFound(instances, scene.instance);
  EXPECT_EQ(8U, shares.size());
  EXPECT_GE(std::count_if(
                shares.begin(), shares.end(), [](double share) { return share > 0.9; }),
            7);
  EXPECT_LE(instances.size(), 9U);
  for (const ShapeInstance& instance : instances) {
    EXPECT_TRUE(std::is_sorted(instance.indices.begin(), instance.indices.end()));
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (const index_t index : instance.indices) {
      sum += Eigen::Map<const Eigen::Vector3f>(
                 &scene.xyz[3 * static_cast<std::size_t>(index)])
                 .cast<double>();
    }
    const double points = static_cast<double>(instance.indices.size());
    EXPECT_LE((sum / points - instance.centroid.cast<double>()).norm(), 1e-6);
  }
}

TEST(Resolution, InstancesAmongSomePoints)
{
  const auto cloud = cloudOf(sampledScene(29));
  Indices left;
  for (std::size_t i = 0; i < cloud->size(); ++i)
    if ((*cloud)[i].x < 0.0f)
      left.push_back(static_cast<index_t>(i));
  ShapeInstanceSegmentation<PointXYZ> segmentation;
  segmentation.setInputCloud(cloud);
  segmentation.setIndices(indicesOf(left));
  segmentation.setClass("planar");
  segmentation.setResolution(0.004);
  std::vector<ShapeInstance> instances;
  ASSERT_TRUE(segmentation.segment(instances));
  ASSERT_FALSE(instances.empty());
  for (const ShapeInstance& instance : instances) {
    EXPECT_TRUE(std::includes(
        left.begin(), left.end(), instance.indices.begin(), instance.indices.end()));
  }
  segmentation.setResolution(0.0);
  std::vector<ShapeInstance> own, fresh;
  ASSERT_TRUE(segmentation.segment(own));
  ShapeInstanceSegmentation<PointXYZ> other;
  other.setInputCloud(cloud);
  other.setIndices(indicesOf(left));
  other.setClass("planar");
  ASSERT_TRUE(other.segment(fresh));
  ASSERT_EQ(fresh.size(), own.size());
  for (std::size_t k = 0; k < own.size(); ++k)
    EXPECT_EQ(fresh[k].indices, own[k].indices);
  segmentation.setIndices(indicesOf({0, 1, 1 << 30}));
  expectParts(errorsOf([&] { EXPECT_FALSE(segmentation.segment(own)); }),
              {"ShapeInstanceSegmentation::segment", "1073741824"});
}

} // namespace
