// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Pairs of mu and sigma of a plane and a cylinder fall where the paper shows them.

#include "support/clouds.h"
#include "support/differences.h"

#include <pcl/features/inad.h>
#include <pcl/features/normal_3d_sweep.h>
#include <pcl/segmentation/shape_back_projection.h>

#include <gtest/gtest.h>

#include <functional>

// The four pairs of the paper: histograms of a plane and of a cylinder, back-projected
// on three orthogonal planes and on a cylinder.
namespace {

using namespace pcl;
using namespace pcl::test;

constexpr double body_radius = 0.1;
constexpr double radius = 0.75 * body_radius;
constexpr double side = 0.4;
constexpr std::size_t density = 40000; // points a square meter

const INADParameters parameters{radius, radius, 0, 2.0};

Surface
tube(std::uint64_t seed)
{
  Random random(seed);
  const double area = 2 * pi * body_radius * side;
  return cylinder(static_cast<std::size_t>(density * area), body_radius, side, random);
}

Surface
wall(Random& random)
{
  return plane(static_cast<std::size_t>(density * side * side), side, random);
}

/** \brief The three coordinate planes. */
Surface
corner(std::uint64_t seed)
{
  Random random(seed);
  Surface three = wall(random);
  for (const Eigen::Vector3d& axis :
       {Eigen::Vector3d::UnitX().eval(), Eigen::Vector3d::UnitY().eval()}) {
    Surface other = wall(random);
    const double turn = axis.x() > 0 ? pi / 2 : -pi / 2;
    other.move(Eigen::Isometry3d(Eigen::AngleAxisd(turn, axis)));
    three.append(other);
  }
  return three;
}

/** \brief At least two radii away from the ends: the normals there are whole as well.
 */
bool
isInsideTube(const Eigen::Vector3d& p)
{
  return p.z() > 2 * radius && p.z() < side - 2 * radius;
}

/** \brief At least two radii away from the creases. */
bool
isInsideWall(const Eigen::Vector3d& p)
{
  const Eigen::Vector3d a = p.cwiseAbs();
  return a.sum() - a.maxCoeff() - a.minCoeff() > 2 * radius;
}

using IsInside = std::function<bool(const Eigen::Vector3d&)>;

IndicesPtr
indicesInside(const Surface& surface, const IsInside& is_inside)
{
  Indices inside;
  for (std::size_t i = 0; i < surface.size(); ++i)
    if (is_inside(surface.position(i)))
      inside.push_back(static_cast<index_t>(i));
  return indicesOf(inside);
}

ShapeModel
modelOf(const std::string& name, const Surface& sample, const IsInside& is_inside)
{
  const auto cloud = toCloud<PointXYZ>(sample);
  NormalEstimationSweep<PointXYZ, Normal> normal_estimation;
  normal_estimation.setInputCloud(cloud);
  normal_estimation.setRadiusSearch(radius);
  const auto normals = make_shared<PointCloud<Normal>>();
  normal_estimation.compute(*normals);
  INADEstimation<PointXYZ, Normal> estimation;
  estimation.setInputCloud(cloud);
  estimation.setIndices(indicesInside(sample, is_inside));
  estimation.setInputNormals(normals);
  estimation.setRadiusSearch(radius);
  PointCloud<INAD> inad;
  estimation.compute(inad);
  ShapeHistogram histogram(10, 10);
  histogram.add(inad);
  ShapeModel model(parameters);
  model.add(name, histogram);
  return model;
}

double
medianLikelihood(const ShapeModel& model,
                 const Surface& scene,
                 const IsInside& is_inside)
{
  ShapeBackProjection<PointXYZ> projection;
  projection.setMode(ShapeBackProjection<PointXYZ>::PAPER);
  projection.setModel(model);
  projection.setInputCloud(toCloud<PointXYZ>(scene));
  projection.setIndices(indicesInside(scene, is_inside));
  std::vector<std::vector<float>> likelihoods;
  projection.compute(likelihoods);
  EXPECT_GT(likelihoods[0].size(), 1000U);
  return median(likelihoods[0]);
}

TEST(PaperPairs, HistogramOfAPlane)
{
  Random random(81);
  const auto everywhere = [](const Eigen::Vector3d&) { return true; };
  const ShapeModel model = modelOf("plane", wall(random), everywhere);
  EXPECT_GE(medianLikelihood(model, corner(82), isInsideWall), 0.9);
  EXPECT_LE(medianLikelihood(model, tube(83), isInsideTube), 0.1);
}

TEST(PaperPairs, HistogramOfACylinder)
{
  const ShapeModel model = modelOf("cylinder", tube(84), isInsideTube);
  EXPECT_GE(medianLikelihood(model, tube(83), isInsideTube), 0.9);
  EXPECT_LE(medianLikelihood(model, corner(82), isInsideWall), 0.1);
}

} // namespace
