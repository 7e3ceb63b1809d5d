// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// A table is no object, however wavy, and a cup is one with its inside.

#include <pcl/segmentation/shape_instance_segmentation.h>

#include <Eigen/Core>
#include <Eigen/LU>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <random>
#include <vector>

namespace {

using namespace pcl;
using Eigen::Vector3d;

constexpr double none = std::numeric_limits<double>::infinity();
enum Label { table = 1, cup = 2, box = 3, second_box = 4, floor_below = 11, rim = 12 };

constexpr double radius = 0.045, wall = 0.004, height = 0.09; // of the cup
constexpr double bottom = 0.005; // its floor, if it has one

/** A box on the table, without a lid if it has compartments. */
struct Box {
  Vector3d low, high;
  int compartments = 0; ///< side by side in x
};

Box
boxWith(int compartments)
{
  return {{0.10, -0.05, 0.0}, {0.18, 0.04, 0.07}, compartments};
}

/** Where a ray meets an upright cylinder between the table and the rim. */
double
cylinderHit(const Vector3d& from, const Vector3d& ray, double r, bool from_inside)
{
  const double a = ray.head<2>().squaredNorm();
  const double b = from.head<2>().dot(ray.head<2>());
  const double root = b * b - a * (from.head<2>().squaredNorm() - r * r);
  if (root < 0.0)
    return none;
  const double t = (-b + (from_inside ? 1.0 : -1.0) * std::sqrt(root)) / a;
  const double z = from.z() + t * ray.z();
  return z > 0.0 && z < height ? t : none;
}

double
closedHit(const Box& of, const Vector3d& from, const Vector3d& ray)
{
  const Eigen::Array3d a = (of.low - from).array() / ray.array();
  const Eigen::Array3d b = (of.high - from).array() / ray.array();
  const double enter = a.min(b).maxCoeff(), leave = a.max(b).minCoeff();
  return enter < leave && enter > 0.0 ? enter : none;
}

/** Through an opening the inside of its compartment is seen. */
double
boxHit(const Box& of, const Vector3d& from, const Vector3d& ray)
{
  constexpr double thickness = 0.004, floor = 0.008;
  const Vector3d at_rim = from + (of.high.z() - from.z()) / ray.z() * ray;
  const double width = (of.high.x() - of.low.x() - thickness) / of.compartments;
  for (int k = 0; k < of.compartments; ++k) {
    const double left = of.low.x() + thickness + k * width;
    const Vector3d low(left, of.low.y() + thickness, of.low.z() + floor);
    const Vector3d high(left + width - thickness, of.high.y() - thickness, of.high.z());
    if ((at_rim.head<2>().array() < low.head<2>().array()).any() ||
        (at_rim.head<2>().array() > high.head<2>().array()).any())
      continue;
    const Eigen::Array3d a = (low - from).array() / ray.array();
    const Eigen::Array3d b = (high - from).array() / ray.array();
    return a.max(b).minCoeff();
  }
  return closedHit(of, from, ray);
}

/** A table with an end, and what is seen beside it. */
struct Slab {
  Box body;
  double floor; ///< height, negative
};

/** The nearer one of the table and the floor. */
double
slabHit(const Slab& of, const Vector3d& from, const Vector3d& ray)
{
  return std::min(closedHit(of.body, from, ray), (of.floor - from.z()) / ray.z());
}

int
labelOn(const Slab& of, const Vector3d& point)
{
  constexpr double tolerance = 1e-6;
  if (point.z() > of.body.high.z() - tolerance)
    return table;
  return point.z() < of.floor + tolerance ? floor_below : rim;
}

struct Scene {
  PointCloud<PointXYZ>::Ptr cloud = pcl::make_shared<PointCloud<PointXYZ>>();
  std::vector<int> labels;
};

/** A table with a cup and boxes on it, as a depth camera above sees them.
 * \param[in] ripple of the depth, meters, over 40 mm
 * \param[in] slab the table, if it ends in the view
 * \param[in] from_above whether the floor of the cup is seen */
Scene
tableScene(double ripple,
           double spacing,
           const std::vector<Box>& boxes,
           std::mt19937& random,
           const std::optional<Slab>& slab = std::nullopt,
           bool from_above = false)
{
  const Vector3d from(0.0, from_above ? -0.25 : -0.45, from_above ? 0.65 : 0.5);
  const Vector3d forward = (Vector3d(0.05, 0.0, 0.03) - from).normalized();
  const Vector3d right = forward.cross(Vector3d::UnitZ()).normalized();
  const Vector3d up = right.cross(forward);
  const double step = spacing / from.norm();
  std::normal_distribution<double> noise(0.0, 0.0003);
  Scene scene;
  for (double u = -0.45; u < 0.45; u += step)
    for (double v = -0.35; v < 0.35; v += step) {
      const Vector3d ray = (forward + u * right + v * up).normalized();
      std::vector<double> hits{slab ? slabHit(*slab, from, ray) : -from.z() / ray.z(),
                               cylinderHit(from, ray, radius, false),
                               cylinderHit(from, ray, radius - wall, true)};
      for (const Box& of : boxes)
        hits.push_back(boxHit(of, from, ray));
      // The inside is seen through the opening only.
      const double at_rim = (height - from.z()) / ray.z();
      if ((from + at_rim * ray).head<2>().norm() < radius - wall) {
        hits[1] = none;
        hits[0] = from_above ? (bottom - from.z()) / ray.z() : hits[0];
      }
      else
        hits[2] = none;
      const auto nearest = std::min_element(hits.begin(), hits.end());
      const int which = static_cast<int>(nearest - hits.begin());
      const int ground = slab ? labelOn(*slab, from + *nearest * ray) : table;
      Vector3d point = from + (*nearest + noise(random)) * ray;
      const bool in_cup = which == 0 && point.head<2>().norm() < radius;
      const double wave = std::sin(point.x() * 2.0 * M_PI / 0.04) *
                          std::sin(point.y() * 2.0 * M_PI / 0.04);
      point += ripple * wave * ray;
      const Vector3d seen(right.dot(point - from),
                          -up.dot(point - from), // camera axes
                          forward.dot(point - from));
      scene.cloud->push_back(PointXYZ(static_cast<float>(seen.x()),
                                      static_cast<float>(seen.y()),
                                      static_cast<float>(seen.z())));
      scene.labels.push_back(which >= 3            ? box + which - 3
                             : which > 0 || in_cup ? cup
                                                   : ground);
    }
  return scene;
}

/** The best intersection over union of an instance with the points of a label. */
double
bestOverlap(const Scene& scene, const std::vector<ShapeInstance>& instances, int label)
{
  const auto all =
      static_cast<double>(std::count(scene.labels.begin(), scene.labels.end(), label));
  double best = 0.0;
  for (const ShapeInstance& instance : instances) {
    const auto both = static_cast<double>(
        std::count_if(instance.indices.begin(), instance.indices.end(), [&](index_t i) {
          return scene.labels[static_cast<std::size_t>(i)] == label;
        }));
    const auto size = static_cast<double>(instance.indices.size());
    best = std::max(best, both / (size + all - both));
  }
  return best;
}

/** Of the points with a label, those in an instance. */
double
takenShare(const Scene& scene, const std::vector<ShapeInstance>& instances, int label)
{
  std::size_t taken = 0;
  for (const ShapeInstance& instance : instances)
    for (const index_t i : instance.indices)
      taken += scene.labels[static_cast<std::size_t>(i)] == label ? 1 : 0;
  return static_cast<double>(taken) /
         static_cast<double>(
             std::count(scene.labels.begin(), scene.labels.end(), label));
}

double
tableShare(const Scene& scene, const std::vector<ShapeInstance>& instances)
{
  return takenShare(scene, instances, table);
}

std::vector<ShapeInstance>
objectsOf(const Scene& scene)
{
  ShapeInstanceSegmentation<PointXYZ> segmentation;
  segmentation.setInputCloud(scene.cloud);
  segmentation.setClass("object");
  std::vector<ShapeInstance> instances;
  EXPECT_TRUE(segmentation.segment(instances));
  return instances;
}

struct View {
  double ripple, spacing;
};

class ObjectsOnSupports : public testing::TestWithParam<View> {};

TEST_P(ObjectsOnSupports, TheTableIsNoneAndTheCupIsOne)
{
  std::mt19937 random(3);
  const Scene scene =
      tableScene(GetParam().ripple, GetParam().spacing, {boxWith(0)}, random);
  const std::vector<ShapeInstance> objects = objectsOf(scene);
  EXPECT_LT(tableShare(scene, objects), 0.02);
  EXPECT_GT(bestOverlap(scene, objects, cup), 0.85);
  EXPECT_GT(bestOverlap(scene, objects, box), 0.85);
}

TEST(Supports, TheFloorOfACupBelongsToIt)
{
  std::mt19937 random(9);
  const Scene scene = tableScene(0.0, 0.0015, {boxWith(0)}, random, std::nullopt, true);
  const std::vector<ShapeInstance> objects = objectsOf(scene);
  EXPECT_LT(tableShare(scene, objects), 0.02);
  EXPECT_GT(bestOverlap(scene, objects, cup), 0.85);
}

/** A table above a floor that is far larger; its rim is seen. */
Slab
tableOnAFloor()
{
  return {{{-0.22, -0.2, -0.03}, {0.26, 0.25, 0.0}}, -0.7};
}

TEST(Supports, ATableWithARimAboveALargerFloorIsNone)
{
  std::mt19937 random(6);
  const Scene scene = tableScene(0.0, 0.0025, {boxWith(0)}, random, tableOnAFloor());
  const std::vector<ShapeInstance> objects = objectsOf(scene);
  for (const int support : {table, floor_below})
    EXPECT_LT(takenShare(scene, objects, support), 0.02) << support;
  EXPECT_GT(bestOverlap(scene, objects, cup), 0.85);
  EXPECT_GT(bestOverlap(scene, objects, box), 0.85);
}

TEST(Supports, AStrongRippleIsNotBehindATable)
{
  std::mt19937 random(7);
  const Scene scene = tableScene(0.003, 0.0025, {boxWith(0)}, random, tableOnAFloor());
  const std::vector<ShapeInstance> objects = objectsOf(scene);
  EXPECT_LT(tableShare(scene, objects), 0.02);
  EXPECT_GT(bestOverlap(scene, objects, box), 0.7);
}

TEST(Supports, ABoxThatCarriesABoxIsAnObject)
{
  std::mt19937 random(8);
  const Box lower{{0.08, -0.12, 0.0}, {0.24, 0.06, 0.08}};
  const Box upper{{0.11, -0.05, 0.08}, {0.18, 0.02, 0.14}};
  const Scene scene = tableScene(0.0, 0.0015, {lower, upper}, random, tableOnAFloor());
  const std::vector<ShapeInstance> objects = objectsOf(scene);
  EXPECT_LT(tableShare(scene, objects), 0.02);
  EXPECT_GT(bestOverlap(scene, objects, box), 0.85);
  EXPECT_GT(bestOverlap(scene, objects, second_box), 0.85);
}

TEST(OpenBoxes, AreOneWithTheirInside)
{
  for (const double ripple : {0.0, 0.0015}) {
    std::mt19937 random(3);
    const Scene scene = tableScene(ripple, 0.0015, {boxWith(1)}, random);
    const std::vector<ShapeInstance> objects = objectsOf(scene);
    EXPECT_LT(tableShare(scene, objects), 0.02) << ripple;
    EXPECT_GT(bestOverlap(scene, objects, box), 0.85) << ripple;
    EXPECT_GT(bestOverlap(scene, objects, cup), 0.85) << ripple;
  }
}

TEST(OpenBoxes, ACrateOfTwoCompartmentsIsOne)
{
  std::mt19937 random(4);
  Box crate = boxWith(2);
  crate.high.x() = 0.24;
  const Scene scene = tableScene(0.0, 0.0015, {crate}, random);
  const std::vector<ShapeInstance> objects = objectsOf(scene);
  EXPECT_LT(tableShare(scene, objects), 0.02);
  EXPECT_GT(bestOverlap(scene, objects, box), 0.85);
}

TEST(OpenBoxes, TwoAreTwo)
{
  std::mt19937 random(5);
  const Box first = boxWith(1);
  Box second = first;
  second.low.x() = first.high.x() + 0.015;
  second.high.x() = second.low.x() + 0.08;
  const Scene scene = tableScene(0.0, 0.0015, {first, second}, random);
  const std::vector<ShapeInstance> objects = objectsOf(scene);
  EXPECT_LT(tableShare(scene, objects), 0.02);
  EXPECT_GT(bestOverlap(scene, objects, box), 0.85);
  EXPECT_GT(bestOverlap(scene, objects, second_box), 0.85);
}

INSTANTIATE_TEST_SUITE_P(Views,
                         ObjectsOnSupports,
                         testing::Values(View{0.0, 0.0015},
                                         View{0.0, 0.0025},
                                         View{0.0015, 0.0015},
                                         View{0.0015, 0.0025}));

} // namespace
