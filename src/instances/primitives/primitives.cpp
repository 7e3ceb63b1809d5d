// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Planes, cylinders, spheres and cones: their geometry, and fits to points by RANSAC.

#include "instances/primitives/primitives.h"

#include "instances/primitives/counting_models.h"

#include <pcl/sample_consensus/ransac.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

namespace pcl::segmentation {
namespace {

using Eigen::Vector3f;
using Eigen::VectorXf;
using Point = pcl::PointXYZ;
using Model = pcl::SampleConsensusModel<Point>;

// 3 of 10 points on a cylinder: 500 draws miss it with a probability of 10^-20.
constexpr int max_iterations = 500;
// Distances alone decide: PCL would add radians to meters.
constexpr double normal_weight = 0.0;
// Least squares on ever nearer points; the last round is stable.
constexpr std::array<double, 3> tightening{2.0, 1.0, 1.0};

/** A point of the axis and the part of the way to a point that is square to it. */
std::pair<Vector3f, Vector3f>
fromAxis(const std::vector<float>& cylinder, const Vector3f& point)
{
  const Vector3f origin(cylinder[0], cylinder[1], cylinder[2]);
  const Vector3f axis(cylinder[3], cylinder[4], cylinder[5]);
  const Vector3f on_axis = origin + axis.dot(point - origin) * axis;
  return {on_axis, point - on_axis};
}

/** The coefficients as the header promises them. */
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

/** The longest distance in the box around the points: a larger radius cannot be told
 * from a plane. */
double
extentOf(const pcl::PointCloud<Point>& points)
{
  Eigen::Array3f low = points.front().getArray3fMap(), high = low;
  for (const Point& point : points) {
    low = low.min(point.getArray3fMap());
    high = high.max(point.getArray3fMap());
  }
  return (high - low).matrix().norm();
}

template <typename WithNormals>
Model::Ptr
modelWithNormals(const PrimitiveSample& sample)
{
  const auto model = pcl::make_shared<WithNormals>(sample.points);
  model->setInputNormals(sample.normals);
  model->setNormalDistanceWeight(normal_weight);
  return model;
}

Model::Ptr
modelOf(const PrimitiveSample& sample, PrimitiveType type)
{
  if (type == PrimitiveType::Plane && sample.min_cosine > -1.0f)
    return pcl::make_shared<OrientedPlaneModel>(
        sample.points, *sample.normals, sample.min_cosine);
  if (type == PrimitiveType::Plane)
    return pcl::make_shared<PlaneModel>(sample.points);
  if (type == PrimitiveType::Sphere)
    return pcl::make_shared<SphereModel>(sample.points);
  return modelWithNormals<CylinderModel>(sample);
}

std::optional<VectorXf>
drawn(const Model::Ptr& model, double tolerance)
{
  pcl::RandomSampleConsensus<Point> ransac(model, tolerance);
  ransac.setMaxIterations(max_iterations);
  if (!ransac.computeModel(0))
    return std::nullopt;
  VectorXf coefficients;
  ransac.getModelCoefficients(coefficients);
  return coefficients;
}

/** Least squares. \return false, and nothing changed, if it has no solution */
bool
optimize(const Model& model, const pcl::Indices& indices, VectorXf& coefficients)
{
  VectorXf refined;
  model.optimizeModelCoefficients(indices, coefficients, refined);
  if (!refined.allFinite())
    return false;
  coefficients = refined;
  return true;
}

ShapePrimitive
primitiveOf(const PrimitiveSample& sample,
            PrimitiveType type,
            const VectorXf& coefficients)
{
  ShapePrimitive primitive;
  primitive.type = type;
  primitive.coefficients.assign(coefficients.data(),
                                coefficients.data() + coefficients.size());
  normalize(primitive);
  double sum = 0.0;
  for (const Point& point : *sample.points) {
    const Vector3f p = point.getVector3fMap();
    sum += (footOn(primitive, p) - p).squaredNorm();
  }
  primitive.residual =
      static_cast<float>(std::sqrt(sum / static_cast<double>(sample.points->size())));
  return primitive;
}

} // namespace

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

ShapePrimitive
fitTo(const PrimitiveSample& sample, PrimitiveType type)
{
  const Model::Ptr model = modelOf(sample, type);
  const double extent = extentOf(*sample.points);
  const bool is_plane = type == PrimitiveType::Plane; // three points determine it
  if (!is_plane)
    model->setRadiusLimits(0.0, extent);
  const double first = is_plane ? sample.tolerance : sample.first_tolerance;
  std::optional<VectorXf> coefficients = drawn(model, first);
  if (!coefficients)
    return {};
  pcl::Indices inliers;
  for (const double times : tightening) {
    const double tolerance = std::min(first, times * sample.tolerance);
    model->selectWithinDistance(*coefficients, tolerance, inliers);
    if (!optimize(*model, inliers, *coefficients))
      break;
  }
  const ShapePrimitive primitive = primitiveOf(sample, type, *coefficients);
  const bool is_too_large = !is_plane && primitive.coefficients.back() > extent;
  return is_too_large ? ShapePrimitive() : primitive;
}

void
refine(const PrimitiveSample& sample, ShapePrimitive& primitive)
{
  const Model::Ptr model = modelOf(sample, primitive.type);
  VectorXf coefficients = Eigen::Map<const VectorXf>(
      primitive.coefficients.data(),
      static_cast<Eigen::Index>(primitive.coefficients.size()));
  if (optimize(*model, *model->getIndices(), coefficients))
    primitive = primitiveOf(sample, primitive.type, coefficients);
}

double
coneResidual(const PrimitiveSample& sample)
{
  constexpr double none = std::numeric_limits<double>::infinity();
  const Model::Ptr model = modelWithNormals<ConeModel>(sample);
  std::optional<VectorXf> coefficients = drawn(model, sample.first_tolerance);
  if (!coefficients || !optimize(*model, *model->getIndices(), *coefficients))
    return none;
  std::vector<double> distances;
  model->getDistancesToModel(*coefficients, distances);
  double squares = 0.0;
  for (const double distance : distances)
    squares += distance * distance;
  return distances.empty() ? none
                           : std::sqrt(squares / static_cast<double>(distances.size()));
}

} // namespace pcl::segmentation
