// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// PCL's models of planes, cylinders, spheres and cones that count the points on them
// and fit them faster. Sums are in the order of PCL's on SSE2, so that the same points
// count.

#include "instances/primitives/counting_models.h"

#include <cmath>
#include <limits>
#include <type_traits>

#include <unsupported/Eigen/NonLinearOptimization>

namespace pcl::segmentation {
namespace {

/** The float that floats are below if they are below a double. */
float
roundedUp(double value)
{
  const auto nearest = static_cast<float>(value);
  return nearest < value
             ? std::nextafter(nearest, std::numeric_limits<float>::infinity())
             : nearest;
}

/** The line of a cylinder's or a cone's coefficients. */
struct Line {
  explicit Line(const Eigen::VectorXf& c)
  : a(c[0])
  , b(c[1])
  , c(c[2])
  , u(c[3])
  , v(c[4])
  , w(c[5])
  , squared_length((u * u + w * w) + v * v)
  {}

  float
  squaredDistance(float x, float y, float z) const
  {
    const float dx = a - x, dy = b - y, dz = c - z;
    const float p = v * dz - w * dy, q = w * dx - u * dz, r = u * dy - v * dx;
    return ((p * p + r * r) + q * q) / squared_length;
  }

  float a, b, c, u, v, w;
  float squared_length;
};

struct ConeAxis : Line {
  explicit ConeAxis(const Eigen::VectorXf& coefficients)
  : Line(coefficients)
  , apex_along((a * u + c * w) + b * v)
  , per_length(1.0f / squared_length)
  {}

  /** From the apex to the foot of a point. */
  float
  height(float x, float y, float z) const
  {
    const float k = (((x * u + z * w) + y * v) - apex_along) * per_length;
    const float dx = a - (a + k * u), dy = b - (b + k * v), dz = c - (c + k * w);
    return std::sqrt((dx * dx + dz * dz) + dy * dy);
  }

  float apex_along, per_length;
};

/** What PCL's functors measure, but of coordinates one by one: compilers vectorize it.
 */
template <typename Model>
struct Distances : pcl::Functor<float> {
  Distances(const PointCloud<PointXYZ>& points, const Indices& some)
  : pcl::Functor<float>(static_cast<int>(some.size()))
  {
    for (const index_t i : some) {
      const PointXYZ& point = points[static_cast<std::size_t>(i)];
      x.push_back(point.x);
      y.push_back(point.y);
      z.push_back(point.z);
    }
  }

  int operator()(const Eigen::VectorXf& coefficients, Eigen::VectorXf& distances) const;

  template <typename DistanceOf>
  int
  set(Eigen::VectorXf& distances, const DistanceOf& distanceOf) const
  {
    float* const values = distances.data();
    for (std::size_t i = 0; i < x.size(); ++i)
      values[i] = distanceOf(x[i], y[i], z[i]);
    return 0;
  }

  std::vector<float> x, y, z;
};

using Sphere = SampleConsensusModelSphere<PointXYZ>;
using Cylinder = SampleConsensusModelCylinder<PointXYZ, Normal>;
using Cone = SampleConsensusModelCone<PointXYZ, Normal>;

template <>
int
Distances<Sphere>::operator()(const Eigen::VectorXf& coefficients,
                              Eigen::VectorXf& distances) const
{
  const float a = coefficients[0], b = coefficients[1], c = coefficients[2],
              radius = coefficients[3];
  return set(distances, [=](float px, float py, float pz) {
    const float dx = px - a, dy = py - b, dz = pz - c;
    return std::sqrt((dx * dx + dz * dz) + dy * dy) - radius;
  });
}

template <>
int
Distances<Cylinder>::operator()(const Eigen::VectorXf& coefficients,
                                Eigen::VectorXf& distances) const
{
  const Line axis(coefficients);
  const float squared_radius = coefficients[6] * coefficients[6];
  return set(distances, [=](float px, float py, float pz) {
    return axis.squaredDistance(px, py, pz) - squared_radius;
  });
}

template <>
int
Distances<Cone>::operator()(const Eigen::VectorXf& coefficients,
                            Eigen::VectorXf& distances) const
{
  const ConeAxis axis(coefficients);
  const float opening = std::tan(coefficients[6]);
  return set(distances, [=](float px, float py, float pz) {
    const float radius = opening * axis.height(px, py, pz);
    return axis.squaredDistance(px, py, pz) - radius * radius;
  });
}

} // namespace

CountedPoints::CountedPoints(const PointCloud<PointXYZ>& points)
{
  x_.reserve(points.size());
  y_.reserve(points.size());
  z_.reserve(points.size());
  for (const PointXYZ& point : points) {
    x_.push_back(point.x);
    y_.push_back(point.y);
    z_.push_back(point.z);
  }
}

template <>
std::size_t
PlaneModel::countWithinDistance(const Eigen::VectorXf& coefficients,
                                double threshold) const
{
  if (!isModelValid(coefficients))
    return 0;
  const float a = coefficients[0], b = coefficients[1], c = coefficients[2],
              d = coefficients[3], limit = roundedUp(threshold);
  return points_.count([=](float x, float y, float z) {
    return std::abs((a * x + c * z) + (b * y + d)) < limit;
  });
}

OrientedPlaneModel::OrientedPlaneModel(const PointCloudConstPtr& points,
                                       const pcl::PointCloud<Normal>& normals,
                                       float min_cosine)
: PlaneModel(points)
, points_(*points)
, min_cosine_(min_cosine)
{
  for (const Normal& normal : normals) {
    normal_x_.push_back(normal.normal_x);
    normal_y_.push_back(normal.normal_y);
    normal_z_.push_back(normal.normal_z);
  }
}

std::size_t
OrientedPlaneModel::countWithinDistance(const Eigen::VectorXf& coefficients,
                                        double threshold) const
{
  if (!isModelValid(coefficients))
    return 0;
  const Eigen::Vector4f plane = coefficients / coefficients.head<3>().norm();
  const float a = plane[0], b = plane[1], c = plane[2], d = plane[3];
  const float limit = roundedUp(threshold), min_cosine = min_cosine_;
  const float *nx = normal_x_.data(), *ny = normal_y_.data(), *nz = normal_z_.data();
  return points_.countWithIndex([=](float x, float y, float z, std::size_t i) {
    const float distance = std::abs((a * x + c * z) + (b * y + d));
    const float cosine = std::abs((a * nx[i] + c * nz[i]) + b * ny[i]);
    return static_cast<int>(distance < limit) & static_cast<int>(cosine > min_cosine);
  });
}

void
OrientedPlaneModel::selectWithinDistance(const Eigen::VectorXf& coefficients,
                                         double threshold,
                                         Indices& inliers)
{
  PlaneModel::selectWithinDistance(coefficients, threshold, inliers);
  const Eigen::Vector3f normal = coefficients.head<3>().normalized();
  const auto has_other_normal = [&](index_t i) {
    const auto k = static_cast<std::size_t>(i);
    const Eigen::Vector3f own(normal_x_[k], normal_y_[k], normal_z_[k]);
    return !(std::abs(normal.dot(own)) > min_cosine_);
  };
  inliers.erase(std::remove_if(inliers.begin(), inliers.end(), has_other_normal),
                inliers.end());
}

template <>
std::size_t
SphereModel::countWithinDistance(const Eigen::VectorXf& coefficients,
                                 double threshold) const
{
  if (!isModelValid(coefficients))
    return 0;
  const float a = coefficients[0], b = coefficients[1], c = coefficients[2];
  const double radius = coefficients[3];
  const double inner = std::max(0.0, radius - threshold), outer = radius + threshold;
  const auto low = static_cast<float>(inner * inner);
  const auto high = static_cast<float>(outer * outer);
  return points_.count([=](float x, float y, float z) {
    const float dx = x - a, dy = y - b, dz = z - c;
    const float squared = dx * dx + (dy * dy + dz * dz);
    return squared >= low && squared <= high;
  });
}

template <>
std::size_t
CylinderModel::countWithinDistance(const Eigen::VectorXf& coefficients,
                                   double threshold) const
{
  if (!isModelValid(coefficients))
    return 0;
  const Line axis(coefficients);
  const double radius = coefficients[6];
  return points_.count([=](float x, float y, float z) {
    const double squared = axis.squaredDistance(x, y, z);
    return std::abs(std::sqrt(squared) - radius) < threshold;
  });
}

template <>
std::size_t
ConeModel::countWithinDistance(const Eigen::VectorXf& coefficients,
                               double threshold) const
{
  if (!isModelValid(coefficients))
    return 0;
  const ConeAxis axis(coefficients);
  const float opening = std::tan(coefficients[6]);
  return points_.count([=](float x, float y, float z) {
    const double squared = axis.squaredDistance(x, y, z);
    const double radius = opening * axis.height(x, y, z);
    return std::abs(std::sqrt(squared) - radius) < threshold;
  });
}

template <typename Model>
void
CountingModel<Model>::optimizeModelCoefficients(const Indices& inliers,
                                                const Eigen::VectorXf& coefficients,
                                                Eigen::VectorXf& optimized) const
{
  if constexpr (!std::is_same_v<Model, SampleConsensusModelPlane<PointXYZ>>)
    if (inliers.size() > this->sample_size_ && this->isModelValid(coefficients)) {
      const Distances<Model> distances(*this->input_, inliers);
      Eigen::NumericalDiff<Distances<Model>> with_derivatives(distances);
      optimized = coefficients;
      Eigen::LevenbergMarquardt<Eigen::NumericalDiff<Distances<Model>>, float>(
          with_derivatives)
          .minimize(optimized);
      if constexpr (!std::is_same_v<Model, Sphere>)
        optimized.segment<3>(3).normalize();
      return;
    }
  Model::optimizeModelCoefficients(inliers, coefficients, optimized);
}

template class CountingModel<SampleConsensusModelPlane<PointXYZ>>;
template class CountingModel<Sphere>;
template class CountingModel<Cylinder>;
template class CountingModel<Cone>;

} // namespace pcl::segmentation
