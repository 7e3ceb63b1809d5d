/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * Point Cloud Library (PCL) - www.pointclouds.org
 * Copyright (c) 2026, pcl_shape contributors
 *
 * All rights reserved
 */

#include "quiet.h"
#include "surface_graph.h"

#include <pcl/point_types.h>
#include <pcl/sample_consensus/ransac.h>
#include <pcl/sample_consensus/sac_model_cylinder.h>
#include <pcl/sample_consensus/sac_model_plane.h>
#include <pcl/sample_consensus/sac_model_sphere.h>
#include <pcl/segmentation/shape_primitive.h>

#include <algorithm>
#include <cmath>
#include <tuple>

namespace pcl::detail {
namespace {

using Eigen::Vector3f;
using Cloud = pcl::PointCloud<pcl::PointXYZ>;
using Normals = pcl::PointCloud<pcl::Normal>;
using Model = pcl::SampleConsensusModel<pcl::PointXYZ>;

// doc/instances.md has the reason of each number.
constexpr std::size_t least_points = 20;
constexpr std::size_t most_points = 2000;
constexpr int most_iterations = 500;
constexpr double normal_weight = 0.1;
constexpr int refinements = 2;
constexpr float simpler = 1.2f;

struct Sample {
  Cloud::Ptr points = pcl::make_shared<Cloud>();
  Normals::Ptr normals = pcl::make_shared<Normals>();
  Vector3f origin = Vector3f::Zero(); ///< of the points, for the numbers' sake
  double tolerance = 0.0;             ///< metres
  double extent = 0.0;                ///< metres
};

/** The order of the points must not matter to what RANSAC draws. */
void
sortByPosition(const InstanceInput& input, std::vector<std::uint32_t>& members)
{
  std::sort(members.begin(), members.end(), [&](std::uint32_t a, std::uint32_t b) {
    const float* p = input.points[a];
    const float* q = input.points[b];
    return std::tie(p[0], p[1], p[2]) < std::tie(q[0], q[1], q[2]);
  });
}

void
leaveEdgesOut(const InstanceInput& input, std::vector<std::uint32_t>& members)
{
  std::vector<std::uint32_t> inner;
  for (const std::uint32_t i : members)
    if (!(input.edge[i] > segmentation::edge_threshold))
      inner.push_back(i);
  if (inner.size() >= least_points)
    members = std::move(inner);
}

Sample
sampleOf(const InstanceInput& input, const std::vector<std::uint32_t>& members)
{
  Sample sample;
  const std::size_t step = (members.size() + most_points - 1) / most_points;
  sample.origin = segmentation::positionOf(input.points, members[members.size() / 2]);
  Eigen::Array3f low = Eigen::Array3f::Zero(), high = low;
  double spacings = 0.0;
  for (std::size_t k = 0; k < members.size(); k += step) {
    const Vector3f n = segmentation::normalOf(input, members[k]);
    if (!n.allFinite())
      continue;
    const Vector3f p =
        segmentation::positionOf(input.points, members[k]) - sample.origin;
    sample.points->push_back({p.x(), p.y(), p.z()});
    sample.normals->push_back({n.x(), n.y(), n.z()});
    low = low.min(p.array());
    high = high.max(p.array());
    spacings += input.spacings[members[k]];
  }
  sample.extent = (high - low).matrix().norm();
  sample.tolerance =
      segmentation::offsetLimit(input) * spacings /
      static_cast<double>(std::max<std::size_t>(1, sample.points->size()));
  return sample;
}

Model::Ptr
modelOf(const Sample& sample, PrimitiveType type)
{
  if (type == PrimitiveType::Plane)
    return pcl::make_shared<pcl::SampleConsensusModelPlane<pcl::PointXYZ>>(
        sample.points);
  Model::Ptr model;
  if (type == PrimitiveType::Sphere) {
    model =
        pcl::make_shared<pcl::SampleConsensusModelSphere<pcl::PointXYZ>>(sample.points);
  }
  else {
    const auto cylinder =
        pcl::make_shared<pcl::SampleConsensusModelCylinder<pcl::PointXYZ, pcl::Normal>>(
            sample.points);
    cylinder->setInputNormals(sample.normals);
    cylinder->setNormalDistanceWeight(normal_weight);
    model = cylinder;
  }
  model->setRadiusLimits(0.0, sample.extent);
  return model;
}

float
distanceTo(const ShapePrimitive& primitive, const Vector3f& point)
{
  const std::vector<float>& c = primitive.coefficients;
  const Vector3f first(c[0], c[1], c[2]);
  switch (primitive.type) {
  case PrimitiveType::Plane:
    return std::abs(first.dot(point) + c[3]);
  case PrimitiveType::Sphere:
    return std::abs((point - first).norm() - c[3]);
  default:
    return std::abs((point - first).cross(Vector3f(c[3], c[4], c[5])).norm() - c[6]);
  }
}

float
residualOf(const ShapePrimitive& primitive, const Cloud& points)
{
  double sum = 0.0;
  for (const pcl::PointXYZ& point : points) {
    const double distance = distanceTo(primitive, point.getVector3fMap());
    sum += distance * distance;
  }
  return static_cast<float>(std::sqrt(sum / static_cast<double>(points.size())));
}

/** From the sample's origin to the cloud's; directions become unit, and the point of an
 * axis the one nearest to the points. */
void
moveToCloud(const Vector3f& origin, ShapePrimitive& primitive)
{
  std::vector<float>& c = primitive.coefficients;
  Eigen::Map<Vector3f> first(c.data());
  if (primitive.type == PrimitiveType::Plane) {
    c[3] -= first.dot(origin);
    return;
  }
  first += origin;
}

void
normalize(ShapePrimitive& primitive)
{
  std::vector<float>& c = primitive.coefficients;
  Eigen::Map<Vector3f> first(c.data());
  if (primitive.type == PrimitiveType::Plane) {
    const float length = first.norm();
    first /= length;
    c[3] /= length;
  }
  else if (primitive.type == PrimitiveType::Cylinder) {
    Eigen::Map<Vector3f> axis(&c[3]);
    axis.normalize();
    first -= axis.dot(first) * axis;
    c[6] = std::abs(c[6]);
  }
}

ShapePrimitive
fit(const Sample& sample, PrimitiveType type)
{
  const Model::Ptr model = modelOf(sample, type);
  pcl::RandomSampleConsensus<pcl::PointXYZ> ransac(model, sample.tolerance);
  ransac.setMaxIterations(most_iterations);
  ShapePrimitive primitive;
  if (!ransac.computeModel(0))
    return primitive;
  Eigen::VectorXf coefficients;
  pcl::Indices inliers;
  ransac.getModelCoefficients(coefficients);
  ransac.getInliers(inliers);
  for (int round = 0; round < refinements; ++round) {
    Eigen::VectorXf refined;
    model->optimizeModelCoefficients(inliers, coefficients, refined);
    if (!refined.allFinite())
      break;
    coefficients = refined;
    model->selectWithinDistance(coefficients, sample.tolerance, inliers);
  }
  primitive.type = type;
  primitive.coefficients.assign(coefficients.data(),
                                coefficients.data() + coefficients.size());
  normalize(primitive);
  primitive.residual = residualOf(primitive, *sample.points);
  return primitive;
}

/** The plane, unless another is clearly better: a large sphere is nearly one. */
ShapePrimitive
bestOf(const Sample& sample)
{
  ShapePrimitive best = fit(sample, PrimitiveType::Plane);
  for (const PrimitiveType type : {PrimitiveType::Sphere, PrimitiveType::Cylinder}) {
    ShapePrimitive other = fit(sample, type);
    if (other.type != PrimitiveType::None &&
        (best.type == PrimitiveType::None || simpler * other.residual < best.residual))
      best = std::move(other);
  }
  return best;
}

} // namespace

ShapePrimitive
fitPrimitive(const InstanceInput& input,
             std::vector<std::uint32_t> members,
             PrimitiveType type)
{
  if (type == PrimitiveType::None || members.empty())
    return {};
  leaveEdgesOut(input, members);
  sortByPosition(input, members);
  const Sample sample = sampleOf(input, members);
  if (sample.points->size() < least_points || !(sample.tolerance > 0.0))
    return {};
  const Quiet quiet;
  ShapePrimitive primitive =
      type == PrimitiveType::Auto ? bestOf(sample) : fit(sample, type);
  if (primitive.type != PrimitiveType::None)
    moveToCloud(sample.origin, primitive);
  return primitive;
}

} // namespace pcl::detail
