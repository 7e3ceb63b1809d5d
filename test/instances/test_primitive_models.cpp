// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Primitives fitted to exact surfaces.

#include "instances/primitives/counting_models.h"
#include "small_surfaces.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace {

using namespace pcl;
using namespace pcl::test;
using Eigen::Vector3f;
using segmentation::coneResidual;
using segmentation::enlarge;
using segmentation::fitTo;
using segmentation::footOn;
using segmentation::normalOf;
using segmentation::PrimitiveSample;
using segmentation::refine;

PrimitiveSample
sampleOf(const Surface& surface)
{
  PrimitiveSample sample;
  for (std::size_t i = 0; i < surface.size(); ++i) {
    const float* p = &surface.xyz[3 * i];
    const float* n = &surface.normals[3 * i];
    sample.points->push_back({p[0], p[1], p[2]});
    sample.normals->push_back({n[0], n[1], n[2]});
  }
  sample.tolerance = 0.1;
  sample.first_tolerance = 0.3;
  return sample;
}

/** How far points are from a model, in the mean of squares, as PCL measures it. */
template <typename Model>
double
offset(Model& model, const Eigen::VectorXf& coefficients)
{
  std::vector<double> distances;
  model.Model::getDistancesToModel(coefficients, distances);
  const double sum =
      std::inner_product(distances.begin(), distances.end(), distances.begin(), 0.0);
  return std::sqrt(sum / static_cast<double>(distances.size()));
}

/** Each hypothesis is counted as PCL does it, if it is the best so far, and optimized
 * as PCL does it. */
template <typename Counting, typename Counted>
void
expectResultsOfPCL(Counting model, const std::vector<std::vector<float>>& hypotheses)
{
  std::size_t most = 0, ended = 0;
  for (const std::vector<float>& hypothesis : hypotheses) {
    const Eigen::VectorXf coefficients = Eigen::Map<const Eigen::VectorXf>(
        hypothesis.data(), static_cast<Eigen::Index>(hypothesis.size()));
    const std::size_t right = model.Counted::countWithinDistance(coefficients, 0.1);
    const std::size_t count = model.countWithinDistance(coefficients, 0.1);
    if (right > most) {
      EXPECT_EQ(count, right);
    }
    EXPECT_LE(count, std::max(right, most));
    Eigen::VectorXf of_pcl, optimized;
    model.Counted::optimizeModelCoefficients(*model.getIndices(), coefficients, of_pcl);
    model.optimizeModelCoefficients(*model.getIndices(), coefficients, optimized);
    // In float both end a thousandth of the distance between points from the best, and
    // where depends on how PCL was compiled.
    EXPECT_LT(offset<Counted>(model, optimized), offset<Counted>(model, of_pcl) + 5e-4)
        << optimized << "\n\n"
        << of_pcl;
    ended += count < right;
    most = std::max(most, right);
  }
  EXPECT_GT(most, 300U);
  EXPECT_GT(ended, 0U) << "none ended early";
}

TEST(CountingModel, CountsAndOptimizesAsPCL)
{
  Random random(12);
  const PrimitiveSample flat = sampleOf(floorPatch(0, 0, 3, 20, 20));
  const PrimitiveSample ball = sampleOf(sphere(900, 4.0, random));
  const PrimitiveSample can = sampleOf(cylinder(900, 4.0, 10.0, random));
  const PrimitiveSample horn = sampleOf(cone(900, 10.0, random));
  std::vector<std::vector<float>> planes, balls, cans, horns;
  for (const float off : {0.05f, 0.02f, 0.0f, 0.01f, 0.04f}) {
    planes.push_back({off, 0.0f, std::sqrt(1.0f - off * off), -3.0f});
    balls.push_back({off, 2.0f * off, 0.0f, 4.0f + off});
    const float upright = std::sqrt(1.0f - off * off);
    cans.push_back({off, 0.0f, 1.0f, off, 0.0f, upright, 4.0f});
    horns.push_back({off, 0.0f, 0.0f, off, 0.0f, upright, float(M_PI / 6.0)});
  }
  using Point = PointXYZ;
  expectResultsOfPCL<segmentation::PlaneModel, SampleConsensusModelPlane<Point>>(
      segmentation::PlaneModel(flat.points), planes);
  expectResultsOfPCL<segmentation::SphereModel, SampleConsensusModelSphere<Point>>(
      segmentation::SphereModel(ball.points), balls);
  segmentation::CylinderModel of_can(can.points);
  of_can.setInputNormals(can.normals);
  of_can.setNormalDistanceWeight(0.0);
  expectResultsOfPCL<segmentation::CylinderModel,
                     SampleConsensusModelCylinder<Point, Normal>>(of_can, cans);
  segmentation::ConeModel of_horn(horn.points);
  of_horn.setInputNormals(horn.normals);
  of_horn.setNormalDistanceWeight(0.0);
  expectResultsOfPCL<segmentation::ConeModel, SampleConsensusModelCone<Point, Normal>>(
      of_horn, horns);
}

TEST(PrimitiveModel, FitsExactSurfaces)
{
  Random random(11);
  const ShapePrimitive plane =
      fitTo(sampleOf(floorPatch(0, 0, 3, 20, 20)), PrimitiveType::Plane);
  ASSERT_EQ(PrimitiveType::Plane, plane.type);
  EXPECT_NEAR(std::abs(plane.coefficients[2]), 1.0f, 1e-5f);
  EXPECT_NEAR(plane.coefficients[3] * plane.coefficients[2], -3.0f, 1e-4f);
  EXPECT_LT(plane.residual, 1e-4f);

  const ShapePrimitive ball =
      fitTo(sampleOf(sphere(500, 4.0, random)), PrimitiveType::Sphere);
  ASSERT_EQ(PrimitiveType::Sphere, ball.type);
  EXPECT_LT(Vector3f(ball.coefficients.data()).norm(), 1e-3f);
  EXPECT_NEAR(ball.coefficients[3], 4.0f, 1e-3f);
  EXPECT_LT(ball.residual, 1e-3f);

  const ShapePrimitive can =
      fitTo(sampleOf(cylinder(500, 4.0, 10.0, random)), PrimitiveType::Cylinder);
  ASSERT_EQ(PrimitiveType::Cylinder, can.type);
  EXPECT_LT(Vector3f(can.coefficients.data()).norm(), 1e-2f);
  EXPECT_NEAR(std::abs(can.coefficients[5]), 1.0f, 1e-4f);
  EXPECT_NEAR(can.coefficients[6], 4.0f, 1e-3f);
  EXPECT_LT(can.residual, 1e-3f);
}

TEST(PrimitiveModel, APlaneIsNotTiltedByTheFootOfAWall)
{
  Surface bottom = floorPatch(0, 0, 0, 20, 20);
  bottom.append(
      pcl::test::patch({9.5, 0, 0.02}, Eigen::Vector3d::UnitY(), {0, 0, 0.02}, 20, 20));
  PrimitiveSample sample = sampleOf(bottom);
  sample.tolerance = 0.4;
  EXPECT_GT(std::abs(fitTo(sample, PrimitiveType::Plane).coefficients[0]), 0.005f);
  sample.min_cosine = 0.8f;
  EXPECT_LT(std::abs(fitTo(sample, PrimitiveType::Plane).coefficients[0]), 1e-5f);
}

TEST(PrimitiveModel, NoSphereIsLargerThanItsPoints)
{
  Surface flat = floorPatch(0, 0, 0, 20, 20);
  for (std::size_t i = 0; i < flat.size(); ++i) { // 50 in radius, 13 across
    const float x = flat.xyz[3 * i] - 5.0f, y = flat.xyz[3 * i + 1] - 5.0f;
    flat.xyz[3 * i + 2] = std::sqrt(2500.0f - x * x - y * y);
  }
  EXPECT_EQ(PrimitiveType::None, fitTo(sampleOf(flat), PrimitiveType::Sphere).type);
}

TEST(PrimitiveModel, RefineMovesThePrimitiveOntoThePoints)
{
  Random random(12);
  const PrimitiveSample sample = sampleOf(sphere(300, 4.0, random));
  ShapePrimitive ball{PrimitiveType::Sphere, {0.3f, -0.2f, 0.1f, 4.3f}, 0.5f};
  refine(sample, ball);
  EXPECT_LT(Vector3f(ball.coefficients.data()).norm(), 1e-3f);
  EXPECT_NEAR(ball.coefficients[3], 4.0f, 1e-3f);
  EXPECT_LT(ball.residual, 1e-3f);
}

TEST(PrimitiveModel, AConeIsDescribedByACone)
{
  Random random(13);
  EXPECT_LT(coneResidual(sampleOf(cone(500, 10.0, random))), 0.02);
  EXPECT_GT(coneResidual(sampleOf(sphere(500, 4.0, random))), 0.1);
}

TEST(PrimitiveModel, FootAndNormal)
{
  const ShapePrimitive plane{PrimitiveType::Plane, {0, 0, 1, -3}, 0};
  EXPECT_EQ(Vector3f(1, 2, 3), footOn(plane, {1, 2, 7}));
  EXPECT_EQ(Vector3f(0, 0, 1), normalOf(plane, Vector3f(1, 2, 7)));
  const ShapePrimitive ball{PrimitiveType::Sphere, {1, 0, 0, 2}, 0};
  EXPECT_EQ(Vector3f(3, 0, 0), footOn(ball, {8, 0, 0}));
  EXPECT_EQ(Vector3f(-1, 0, 0), normalOf(ball, Vector3f(-4, 0, 0)));
  const ShapePrimitive can{PrimitiveType::Cylinder, {1, 0, 0, 0, 0, 1, 2}, 0};
  EXPECT_EQ(Vector3f(1, 2, 9), footOn(can, {1, 5, 9}));
  EXPECT_EQ(Vector3f(0, 1, 0), normalOf(can, Vector3f(1, 5, 9)));
}

TEST(PrimitiveModel, EnlargeKeepsDirections)
{
  ShapePrimitive plane{PrimitiveType::Plane, {0, 0, 1, -3}, 0.5f};
  enlarge(2, plane);
  EXPECT_EQ((std::vector<float>{0, 0, 1, -6}), plane.coefficients);
  EXPECT_EQ(1.0f, plane.residual);
  ShapePrimitive can{PrimitiveType::Cylinder, {1, 2, 0, 0, 0, 1, 2}, 0.5f};
  enlarge(3, can);
  EXPECT_EQ((std::vector<float>{3, 6, 0, 0, 0, 1, 6}), can.coefficients);
}

ShapePrimitive
fitted(const detail::InstanceInput& input, PrimitiveType type)
{
  return detail::fitPrimitive(
      input, range(0, static_cast<std::uint32_t>(input.points.size)), type);
}

TEST(PrimitiveFit, AutoTakesTheSimplestThatFits)
{
  Random random(14);
  const Surface flat = floorPatch(0, 0, 0, 20, 20);
  const Surface ball = sphere(600, 5.0, random);
  const Surface can = cylinder(600, 5.0, 10.0, random);
  EXPECT_EQ(PrimitiveType::Plane, fitted(inputOf(flat), PrimitiveType::Auto).type);
  EXPECT_EQ(PrimitiveType::Sphere, fitted(inputOf(ball), PrimitiveType::Auto).type);
  EXPECT_EQ(PrimitiveType::Cylinder, fitted(inputOf(can), PrimitiveType::Auto).type);
  EXPECT_EQ(PrimitiveType::None, fitted(inputOf(flat), PrimitiveType::None).type);
}

TEST(PrimitiveFit, IsInTheCloudsFrameAndUnit)
{
  Random random(15);
  Surface ball = sphere(600, 0.05, random);
  for (std::size_t i = 0; i < ball.size(); ++i)
    ball.xyz[3 * i] += 7.0f;
  detail::InstanceInput input = inputOf(ball);
  input.spacings.assign(ball.size(), 0.01f);
  const ShapePrimitive primitive = fitted(input, PrimitiveType::Sphere);
  ASSERT_EQ(PrimitiveType::Sphere, primitive.type);
  EXPECT_NEAR(primitive.coefficients[0], 7.0f, 1e-4f);
  EXPECT_NEAR(primitive.coefficients[3], 0.05f, 1e-4f);
  EXPECT_LT(primitive.residual, 1e-4f);
}

TEST(PrimitiveFit, NeedsTwentyPointsWithANormal)
{
  const Surface flat = floorPatch(0, 0, 0, 7, 3);
  detail::InstanceInput input = inputOf(flat);
  EXPECT_EQ(PrimitiveType::Plane, fitted(input, PrimitiveType::Plane).type);
  for (const std::size_t i : {0U, 1U})
    input.normals[3 * i] = std::numeric_limits<float>::quiet_NaN();
  EXPECT_EQ(PrimitiveType::None, fitted(input, PrimitiveType::Plane).type);
  EXPECT_EQ(PrimitiveType::None,
            detail::fitPrimitive(input, {}, PrimitiveType::Plane).type);
}

TEST(PrimitiveFit, LeavesEdgesOut)
{
  const Surface flat = floorPatch(0, 0, 0, 10, 10);
  const Surface both = together(flat, floorPatch(0, 0, 0.2, 10, 10));
  detail::InstanceInput input = inputOf(both);
  std::fill(input.edge.begin() + 100, input.edge.end(), 0.9f);
  const ShapePrimitive primitive = fitted(input, PrimitiveType::Plane);
  ASSERT_EQ(PrimitiveType::Plane, primitive.type);
  EXPECT_NEAR(primitive.coefficients[3], 0.0f, 1e-5f);
  EXPECT_LT(primitive.residual, 1e-5f);
}

} // namespace
