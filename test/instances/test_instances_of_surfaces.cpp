// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Instances of single surfaces and the primitives fitted to them.

#include "instance_scenes.h"

#include <gtest/gtest.h>

#include <cmath>

// Surfaces somewhere in front of the camera, alone: what is one instance, and what is
// fitted to it.
namespace {

using namespace pcl;
using namespace pcl::test;

/** \brief A surface somewhere in front of the camera. */
std::vector<ShapeInstance>
fittedTo(Surface surface, const std::string& of_class, PrimitiveType primitive)
{
  surface.move(tiltedPose());
  return describedIn(toCloud<PointXYZ>(surface), of_class, primitive);
}

TEST(Instances, ACylinderIsFittedWithItsAxisAndRadius)
{
  Random random(7);
  const auto found =
      fittedTo(cylinder(20000, 0.05, 0.2, random), "curved", PrimitiveType::Auto);
  ASSERT_EQ(1U, found.size());
  const ShapePrimitive& fit = found[0].primitive;
  ASSERT_EQ(PrimitiveType::Cylinder, fit.type);
  const std::vector<float>& c = fit.coefficients;
  const Eigen::Vector3d axis = tiltedPose().linear().col(2);
  const Eigen::Vector3d found_axis(c[3], c[4], c[5]);
  EXPECT_NEAR(1.0, std::abs(axis.dot(found_axis)), 1e-5);
  EXPECT_NEAR(0.05, c[6], 1e-4);
  const Eigen::Vector3d off =
      Eigen::Vector3d(c[0], c[1], c[2]) - tiltedPose().translation();
  EXPECT_LT(off.cross(axis).norm(), 1e-4);
  EXPECT_LT(fit.residual, 1e-4f);
}

TEST(Instances, ASphereIsFittedWithItsCenterAndRadius)
{
  Random random(8);
  const auto found =
      fittedTo(sphere(20000, 0.06, random), "curved", PrimitiveType::Auto);
  ASSERT_EQ(1U, found.size());
  const ShapePrimitive& fit = found[0].primitive;
  ASSERT_EQ(PrimitiveType::Sphere, fit.type);
  const std::vector<float>& c = fit.coefficients;
  EXPECT_LT((Eigen::Vector3d(c[0], c[1], c[2]) - tiltedPose().translation()).norm(),
            1e-4);
  EXPECT_NEAR(0.06, c[3], 1e-4);
}

TEST(Instances, APlaneIsFittedWithItsNormalAndResidual)
{
  Random random(9);
  Surface surface = plane(20000, 0.3, random);
  constexpr double sigma = 2e-4;
  for (std::size_t i = 2; i < surface.xyz.size(); i += 3)
    surface.xyz[i] += static_cast<float>(sigma * random.normal());
  const auto found = fittedTo(surface, "planar", PrimitiveType::Auto);
  ASSERT_EQ(1U, found.size());
  const ShapePrimitive& fit = found[0].primitive;
  ASSERT_EQ(PrimitiveType::Plane, fit.type);
  const std::vector<float>& c = fit.coefficients;
  const Eigen::Vector3d normal = tiltedPose().linear().col(2);
  EXPECT_NEAR(1.0, std::abs(normal.dot(Eigen::Vector3d(c[0], c[1], c[2]))), 1e-5);
  const Eigen::Vector3f on_plane = tiltedPose().translation().cast<float>();
  EXPECT_LT(std::abs(Eigen::Vector3f(c[0], c[1], c[2]).dot(on_plane) + c[3]), 1e-4f);
  EXPECT_NEAR(sigma, fit.residual, 0.2 * sigma);
}

TEST(Instances, TheGivenPrimitiveIsFittedAndDoesNotDependOnTheOrder)
{
  Random random(10);
  Surface surface = cylinder(20000, 0.05, 0.2, random);
  surface.move(tiltedPose());
  const auto cloud = toCloud<PointXYZ>(surface);
  const auto found = describedIn(cloud, "curved", PrimitiveType::Sphere);
  ASSERT_EQ(1U, found.size());
  EXPECT_EQ(PrimitiveType::Sphere, found[0].primitive.type);
  EXPECT_GT(found[0].primitive.residual, 1e-3f) << "it is none";
  const auto other = describedIn(
      reordered(*cloud, shuffled(cloud->size())), "curved", PrimitiveType::Sphere);
  ASSERT_EQ(1U, other.size());
  EXPECT_EQ(found[0].primitive.coefficients, other[0].primitive.coefficients);
}

/** \brief Smooth, of no primitive: two half spheres on a cylinder. */
Surface
capsule(double radius, double length, Random& random)
{
  Surface surface = cylinder(12000, radius, length, random);
  const Surface ball = sphere(8000, radius, random);
  for (std::size_t i = 0; i < ball.xyz.size(); i += 3) {
    const double end = ball.xyz[i + 2] < 0.0f ? 0.0 : length;
    surface.xyz.push_back(ball.xyz[i]);
    surface.xyz.push_back(ball.xyz[i + 1]);
    surface.xyz.push_back(ball.xyz[i + 2] + static_cast<float>(end));
  }
  return surface;
}

Surface
egg(Random& random)
{
  Surface surface = sphere(20000, 0.05, random);
  for (std::size_t i = 2; i < surface.xyz.size(); i += 3)
    surface.xyz[i] *= 1.6f;
  return surface;
}

TEST(Instances, SmoothSurfacesOfNoPrimitiveStayWhole)
{
  Random random(12);
  for (const Surface& surface : {capsule(0.05, 0.15, random), egg(random)}) {
    const auto found = fittedTo(surface, "curved", PrimitiveType::None);
    ASSERT_EQ(1U, found.size());
    EXPECT_GE(found[0].indices.size(), surface.xyz.size() / 3 * 99 / 100);
  }
}

TEST(Instances, DoNotDependOnWhatIsFarAway)
{
  Random random(13);
  const Surface one = egg(random);
  Surface two = one;
  for (std::size_t i = 0; i < one.xyz.size(); i += 3)
    two.xyz.insert(two.xyz.end(), {one.xyz[i] + 16.0f, one.xyz[i + 1], one.xyz[i + 2]});
  EXPECT_EQ(1U, fittedTo(one, "curved", PrimitiveType::None).size());
  EXPECT_EQ(2U, fittedTo(two, "curved", PrimitiveType::None).size());
}

/** \brief Upright and square, as wide as high, turned about the vertical. */
Surface
uprightSquare(double turn, double low, Random& random)
{
  constexpr double side = 0.15;
  Surface surface = plane(10000, side, random);
  const Eigen::Isometry3d upright(
      Eigen::AngleAxisd(turn, Eigen::Vector3d::UnitZ()) *
      Eigen::AngleAxisd(0.5 * pi, Eigen::Vector3d::UnitX()));
  surface.move(Eigen::Translation3d(0.0, 0.0, low) * upright *
               Eigen::Translation3d(-0.5 * side, 0.0, 0.0));
  return surface;
}

TEST(Instances, FacesThatCrossAreTwo)
{
  Random random(14);
  Surface faces = uprightSquare(0.0, 0.0, random);
  const Surface above = uprightSquare(0.25, 0.15, random);
  faces.xyz.insert(faces.xyz.end(), above.xyz.begin(), above.xyz.end());
  for (float& x : faces.xyz)
    x += static_cast<float>(4e-4 * random.normal());
  const auto found = fittedTo(faces, "planar", PrimitiveType::None);
  ASSERT_EQ(2U, found.size());
  for (const ShapeInstance& face : found)
    EXPECT_NEAR(10000.0, static_cast<double>(face.indices.size()), 500.0);
}

TEST(Instances, NothingIsFoundWhereThereIsNothing)
{
  Random random(11);
  EXPECT_TRUE(
      fittedTo(plane(20000, 0.3, random), "curved", PrimitiveType::None).empty());
  EXPECT_TRUE(
      fittedTo(sphere(20000, 0.06, random), "planar", PrimitiveType::None).empty());
}

} // namespace
