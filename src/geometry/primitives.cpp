// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// PURPOSE

#include "geometry/primitives.h"

#include <pcl/sample_consensus/ransac.h>
#include <pcl/sample_consensus/sac_model_cone.h>
#include <pcl/sample_consensus/sac_model_cylinder.h>
#include <pcl/sample_consensus/sac_model_plane.h>
#include <pcl/sample_consensus/sac_model_sphere.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>
#include <vector>

namespace pcl::segmentation {
namespace {

using Eigen::Vector3f;

/** A point of the axis and the part of the way to a point that is square to it. */
std::pair<Vector3f, Vector3f>
fromAxis(const std::vector<float>& cylinder, const Vector3f& point)
{
  const Vector3f origin(cylinder[0], cylinder[1], cylinder[2]);
  const Vector3f axis(cylinder[3], cylinder[4], cylinder[5]);
  const Vector3f on_axis = origin + axis.dot(point - origin) * axis;
  return {on_axis, point - on_axis};
}

} // namespace

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

void
enlarge(float times, ShapePrimitive& primitive)
{
  std::vector<float>& c = primitive.coefficients;
  if (primitive.type != PrimitiveType::Plane)
    Eigen::Map<Vector3f>(c.data()) *= times;
  c.back() *= times;
  primitive.residual *= times;
}

Vector3f
footOn(const ShapePrimitive& primitive, const Vector3f& point)
{
  const std::vector<float>& c = primitive.coefficients;
  const Vector3f first(c[0], c[1], c[2]);
  switch (primitive.type) {
  case PrimitiveType::Plane:
    return point - (first.dot(point) + c[3]) * first;
  case PrimitiveType::Sphere:
    return first + c[3] * (point - first).normalized();
  default:
    const auto [on_axis, away] = fromAxis(c, point);
    return on_axis + c[6] * away.normalized();
  }
}

Vector3f
normalOf(const ShapePrimitive& primitive, const Vector3f& point)
{
  const std::vector<float>& c = primitive.coefficients;
  const Vector3f first(c[0], c[1], c[2]);
  switch (primitive.type) {
  case PrimitiveType::Plane:
    return first;
  case PrimitiveType::Sphere:
    return (point - first).normalized();
  default:
    return fromAxis(c, point).second.normalized();
  }
}

namespace {

using Eigen::Vector3f;
using Model = pcl::SampleConsensusModel<pcl::PointXYZ>;

// doc/instances.md has the reason of each number.
constexpr int most_iterations = 500;
constexpr double normal_weight = 0.0; // PCL would add radians to metres
constexpr std::array<double, 3> tightening{2.0, 1.0, 1.0};

/** The longest distance in the box around the points: no larger radius can be told from
 * a plane. */
double
extentOf(const PrimitiveSample::Points& points)
{
  Eigen::Array3f low = points.front().getArray3fMap(), high = low;
  for (const pcl::PointXYZ& point : points) {
    low = low.min(point.getArray3fMap());
    high = high.max(point.getArray3fMap());
  }
  return (high - low).matrix().norm();
}

Model::Ptr
modelOf(const PrimitiveSample& sample, PrimitiveType type)
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
  return model;
}

float
residualOf(const ShapePrimitive& primitive, const PrimitiveSample::Points& points)
{
  double sum = 0.0;
  for (const pcl::PointXYZ& point : points) {
    const Vector3f p = point.getVector3fMap();
    sum += (footOn(primitive, p) - p).squaredNorm();
  }
  return static_cast<float>(std::sqrt(sum / static_cast<double>(points.size())));
}

} // namespace

ShapePrimitive
fitTo(const PrimitiveSample& sample, PrimitiveType type)
{
  const Model::Ptr model = modelOf(sample, type);
  const double extent = extentOf(*sample.points);
  if (type != PrimitiveType::Plane)
    model->setRadiusLimits(0.0, extent);
  const bool is_exact = type == PrimitiveType::Plane; // three points give it
  const double first = is_exact ? sample.tolerance : sample.first_tolerance;
  pcl::RandomSampleConsensus<pcl::PointXYZ> ransac(model, first);
  ransac.setMaxIterations(most_iterations);
  ShapePrimitive primitive;
  if (!ransac.computeModel(0))
    return primitive;
  Eigen::VectorXf coefficients;
  pcl::Indices inliers;
  ransac.getModelCoefficients(coefficients);
  for (const double times : tightening) {
    const double tolerance = std::min(first, times * sample.tolerance);
    model->selectWithinDistance(coefficients, tolerance, inliers);
    Eigen::VectorXf refined;
    model->optimizeModelCoefficients(inliers, coefficients, refined);
    if (!refined.allFinite())
      break;
    coefficients = refined;
  }
  primitive.type = type;
  primitive.coefficients.assign(coefficients.data(),
                                coefficients.data() + coefficients.size());
  normalize(primitive);
  if (type != PrimitiveType::Plane && primitive.coefficients.back() > extent)
    return {};
  primitive.residual = residualOf(primitive, *sample.points);
  return primitive;
}

void
refine(const PrimitiveSample& sample, ShapePrimitive& primitive)
{
  pcl::Indices all(sample.points->size());
  std::iota(all.begin(), all.end(), 0);
  const Eigen::VectorXf coefficients = Eigen::Map<const Eigen::VectorXf>(
      primitive.coefficients.data(),
      static_cast<Eigen::Index>(primitive.coefficients.size()));
  Eigen::VectorXf refined;
  modelOf(sample, primitive.type)
      ->optimizeModelCoefficients(all, coefficients, refined);
  if (!refined.allFinite())
    return;
  primitive.coefficients.assign(refined.data(), refined.data() + refined.size());
  normalize(primitive);
  primitive.residual = residualOf(primitive, *sample.points);
}

double
coneResidual(const PrimitiveSample& sample)
{
  const auto model =
      pcl::make_shared<pcl::SampleConsensusModelCone<pcl::PointXYZ, pcl::Normal>>(
          sample.points);
  model->setInputNormals(sample.normals);
  model->setNormalDistanceWeight(normal_weight);
  pcl::RandomSampleConsensus<pcl::PointXYZ> ransac(model, sample.first_tolerance);
  ransac.setMaxIterations(most_iterations);
  constexpr double none = std::numeric_limits<double>::infinity();
  if (!ransac.computeModel(0))
    return none;
  Eigen::VectorXf coefficients, refined;
  ransac.getModelCoefficients(coefficients);
  pcl::Indices all(sample.points->size());
  std::iota(all.begin(), all.end(), 0);
  model->optimizeModelCoefficients(all, coefficients, refined);
  if (!refined.allFinite())
    return none;
  std::vector<double> distances;
  model->getDistancesToModel(refined, distances);
  double squares = 0.0;
  for (const double distance : distances)
    squares += distance * distance;
  return distances.empty() ? none
                           : std::sqrt(squares / static_cast<double>(distances.size()));
}

} // namespace pcl::segmentation
