// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Whether the first grasp of each object is on it, square to it, and free of holes.

#include "evaluation/grasps.h"

#include "evaluation/covered_disc.h"
#include "results/points_by_object.h"

#include <pcl/common/point_tests.h>
#include <pcl/octree/octree_search.h>
#include <pcl/pcl_base.h>

#include <Eigen/Eigenvalues>
#include <Eigen/QR>

#include <algorithm>
#include <cmath>
#include <limits>

namespace pcl::app {
namespace {

using Cloud = pcl::PointCloud<pcl::PointXYZ>;
using Eigen::Vector2d;
using Eigen::Vector3d;

// In radii of the cup.
constexpr double fit_radius = 1.5; // smaller discs turn by degrees in a camera's noise
constexpr double face_radius = 1.4142135623730951; // of a disc of twice the cup's area
constexpr double max_residual = 0.15; // 1.5 mm of a cup of 10: a Kinect's noise at 1 m
constexpr double surface_band = 2.0 * max_residual; // what is on the surface
constexpr std::size_t min_fitted = 20;              // of the six unknowns of a quadric
constexpr std::size_t face_step = 20; // every so many points a face is looked for

struct Cup {
  double radius;     ///< meters
  double compliance; ///< in radii, by which the lip may bend
};

/** The points of an object, or of all, and those near a place. */
class Points {
public:
  Points(const Cloud::ConstPtr& cloud, const pcl::IndicesPtr& indices, double cell)
  : cloud_(cloud)
  , octree_(cell)
  {
    octree_.setInputCloud(cloud, indices);
    octree_.addPointsFromInputCloud();
  }

  std::vector<Vector3d>
  near(const Vector3d& place, double radius) const
  {
    pcl::Indices found;
    std::vector<float> squares;
    octree_.radiusSearch(toPoint(place), radius, found, squares);
    std::vector<Vector3d> points;
    points.reserve(found.size());
    for (const pcl::index_t i : found)
      points.push_back((*cloud_)[static_cast<std::size_t>(i)]
                           .getVector3fMap()
                           .template cast<double>());
    return points;
  }

  std::size_t
  nearest(const Vector3d& place)
  {
    pcl::Indices found;
    std::vector<float> squares;
    octree_.nearestKSearch(toPoint(place), 1, found, squares);
    return static_cast<std::size_t>(found.front());
  }

private:
  static pcl::PointXYZ
  toPoint(const Vector3d& place)
  {
    const Eigen::Vector3f p = place.cast<float>();
    return {p.x(), p.y(), p.z()};
  }

  Cloud::ConstPtr cloud_;
  pcl::octree::OctreePointCloudSearch<pcl::PointXYZ> octree_;
};

/** A height over the tangent plane, of the second degree. */
struct Quadric {
  Vector3d center;
  Eigen::Matrix3d axes; ///< columns; the last is the normal of the points' plane
  Eigen::Matrix<double, 6, 1> terms;
  double residual = 0.0; ///< r.m.s.

  Vector3d
  local(const Vector3d& point) const
  {
    return axes.transpose() * (point - center);
  }

  static Eigen::Matrix<double, 1, 6>
  row(const Vector3d& p)
  {
    Eigen::Matrix<double, 1, 6> values;
    values << 1.0, p.x(), p.y(), p.x() * p.x(), p.x() * p.y(), p.y() * p.y();
    return values;
  }

  double
  offset(const Vector3d& local) const
  {
    return local.z() - row(local).dot(terms);
  }

  /** How far the surface departs from a plane within the cup: the lip has to follow. */
  double
  sag(double radius) const
  {
    Eigen::Matrix2d bend;
    bend << 2.0 * terms[3], terms[4], terms[4], 2.0 * terms[5];
    const Vector2d k =
        Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d>(bend).eigenvalues();
    return std::max({std::abs(k[0]), std::abs(k[1]), k[1] - k[0]}) * radius * radius /
           2.0;
  }
};

std::optional<Quadric>
quadricOf(const std::vector<Vector3d>& points, const Vector3d& center)
{
  if (points.size() < min_fitted)
    return std::nullopt;
  Vector3d mean = Vector3d::Zero();
  for (const Vector3d& point : points)
    mean += point / static_cast<double>(points.size());
  Eigen::Matrix3d squares = Eigen::Matrix3d::Zero();
  for (const Vector3d& point : points)
    squares += (point - mean) * (point - mean).transpose();
  Quadric quadric;
  quadric.center = center;
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(squares);
  for (int axis = 0; axis < 3; ++axis) // from the smallest to the largest
    quadric.axes.col(axis) = solver.eigenvectors().col(2 - axis);
  Eigen::MatrixXd rows(points.size(), 6);
  Eigen::VectorXd heights(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Vector3d local = quadric.local(points[i]);
    rows.row(static_cast<Eigen::Index>(i)) = Quadric::row(local);
    heights[static_cast<Eigen::Index>(i)] = local.z();
  }
  quadric.terms = rows.colPivHouseholderQr().solve(heights);
  quadric.residual = std::sqrt((rows * quadric.terms - heights).squaredNorm() /
                               static_cast<double>(points.size()));
  return quadric;
}

/** Square to the plane of some points. */
std::vector<Vector2d>
placesOn(const Quadric& quadric, const std::vector<Vector3d>& points, double band)
{
  std::vector<Vector2d> places;
  for (const Vector3d& point : points) {
    const Vector3d local = quadric.local(point);
    if (std::abs(quadric.offset(local)) < band)
      places.emplace_back(local.head<2>());
  }
  return places;
}

bool
hasFace(const Points& object,
        const Cloud& cloud,
        const pcl::Indices& indices,
        const Cup& cup)
{
  const double radius = cup.radius;
  for (std::size_t k = 0; k < indices.size(); k += face_step) {
    const Vector3d center = cloud[static_cast<std::size_t>(indices[k])]
                                .getVector3fMap()
                                .template cast<double>();
    const std::vector<Vector3d> near = object.near(center, fit_radius * radius);
    const std::optional<Quadric> quadric = quadricOf(near, center);
    if (quadric && quadric->sag(radius) <= cup.compliance * radius &&
        quadric->residual <= max_residual * radius &&
        isCovered(placesOn(*quadric, near, surface_band * radius),
                  face_radius * radius))
      return true;
  }
  return false;
}

pcl::IndicesPtr
finitePoints(const Cloud& cloud)
{
  auto finite = pcl::make_shared<pcl::Indices>();
  for (std::size_t i = 0; i < cloud.size(); ++i)
    if (pcl::isXYZFinite(cloud[i]))
      finite->push_back(static_cast<pcl::index_t>(i));
  return finite;
}

Vector3d
toVector(const Vector& v)
{
  return Eigen::Map<const Eigen::Vector3f>(v.data()).cast<double>();
}

void
judge(const Points& object, double radius, ObjectGrasp& result)
{
  constexpr double degrees = 180.0 / 3.14159265358979323846;
  const Vector3d position = toVector(result.first->position);
  const std::vector<Vector3d> near = object.near(position, fit_radius * radius);
  const std::optional<Quadric> quadric = quadricOf(near, position);
  if (!quadric)
    return;
  const double cosine =
      std::abs(quadric->axes.col(2).dot(toVector(result.first->approach)));
  result.angle = degrees * std::acos(std::min(1.0, cosine));
  result.is_whole = isCovered(placesOn(*quadric, near, surface_band * radius), radius);
}

/** What became of one object.
 * \param[in] nearest the object at a place of the scene, 0 if none */
template <typename Nearest>
ObjectGrasp
resultOf(std::uint32_t object,
         const Cloud::ConstPtr& cloud,
         const pcl::IndicesPtr& indices,
         const GraspsOfObjects& grasps,
         const Nearest& nearest)
{
  const Cup cup{static_cast<double>(grasps.cup_radius), grasps.compliance};
  ObjectGrasp result;
  result.object = object;
  result.points = indices->size();
  result.angle = std::numeric_limits<double>::quiet_NaN();
  const Points of_object(cloud, indices, cup.radius);
  result.has_face = hasFace(of_object, *cloud, *indices, cup);
  const auto first =
      std::find_if(grasps.grasps.begin(), grasps.grasps.end(), [&](const Grasp& grasp) {
        return grasp.object == object;
      });
  if (first != grasps.grasps.end()) {
    result.first = *first;
    result.is_on_object = nearest(toVector(first->position)) == object;
    judge(of_object, cup.radius, result);
  }
  return result;
}

} // namespace

std::vector<ObjectGrasp>
evaluateGrasps(const Cloud& cloud,
               const std::vector<std::uint32_t>& labels,
               const GraspsOfObjects& grasps,
               std::uint64_t min_points)
{
  const Cloud::ConstPtr points(&cloud, [](const Cloud*) {}); // the caller keeps it
  Points scene(points, finitePoints(cloud), static_cast<double>(grasps.cup_radius));
  const auto nearestObject = [&](const Vector3d& place) {
    return labels[scene.nearest(place)] / grasps.parts;
  };
  std::vector<ObjectGrasp> results;
  for (const auto& [object, indices] : pointsByObject(cloud, labels, grasps.parts))
    if (indices->size() >= min_points)
      results.push_back(resultOf(object, points, indices, grasps, nearestObject));
  return results;
}

} // namespace pcl::app
