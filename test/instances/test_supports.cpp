// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Boards, bins, tilted tables and others are no objects; what stands on them is, also
// behind other things.

#include "scene/sensors/depth_cameras.h"
#include "scene/worlds/world.h"
#include "segmentation/detection_scenes.h"

#include <pcl/segmentation/shape_instance_segmentation.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <ostream>
#include <string>
#include <vector>

namespace {

using namespace pcl;
using namespace pcl::test;
using scene::Pose;
using scene::Shape;
using scene::Vec3;

/** \brief What is there, and from where it is seen. Numbers are those of
 * scene::Sight::object; what is neither a support nor a thing is not judged. */
struct Setting {
  scene::World world;
  std::vector<int> supports, things;
  Vec3 eye, target;
  double width = 0.0, height = 0.0; ///< of the view at the target, meters
};

/** \brief Turned about the x axis, so that what is at y > 0 is higher. */
Pose
tilted(const Vec3& origin, double degrees)
{
  const double turn = degrees * M_PI / 180.0;
  Pose pose;
  pose.axes = {Vec3{1, 0, 0},
               Vec3{0, std::cos(turn), std::sin(turn)},
               Vec3{0, -std::sin(turn), std::cos(turn)}};
  pose.origin = origin;
  return pose;
}

/** \brief A box around the origin of a frame. */
int
addTurnedBox(Setting& setting, const Pose& pose, const Vec3& size)
{
  setting.world.solids.push_back({Shape::Box, {size.x, size.y, size.z}, pose});
  return static_cast<int>(setting.world.solids.size());
}

int
addBox(Setting& setting, const Vec3& center, const Vec3& size)
{
  return addTurnedBox(setting, tilted(center, 0.0), size);
}

/** \brief A box and a cylinder on a plane whose frame is given. */
void
addThings(Setting& setting, const Pose& pose, const Vec3& box, const Vec3& cylinder)
{
  constexpr double height = 0.12, radius = 0.04;
  Pose place = pose;
  place.origin = pose.toWorld(box + Vec3{0, 0, 0.5 * height});
  setting.things.push_back(addTurnedBox(setting, place, {0.11, 0.08, height}));
  place.origin = pose.toWorld(cylinder);
  setting.world.solids.push_back({Shape::Cylinder, {radius, height, 0}, place});
  setting.things.push_back(static_cast<int>(setting.world.solids.size()));
}

void
addFloor(Setting& setting, double half_width)
{
  setting.world.table = {{}, {1, 0, 0}, {0, 1, 0}, half_width, half_width};
  setting.supports.push_back(scene::table_index);
}

Setting
shelf()
{
  Setting setting;
  addBox(setting, {0, 0.31, 0.3}, {0.8, 0.02, 0.8}); // the back
  for (const double z : {0.0, 0.25, 0.5}) {
    setting.supports.push_back(addBox(setting, {0, 0.15, z - 0.01}, {0.8, 0.3, 0.02}));
    addThings(setting, tilted({0, 0.12, z}, 0.0), {-0.2 + z, 0, 0}, {0.15 - z, 0, 0});
  }
  setting.eye = {0.0, -0.9, 0.95};
  setting.target = {0.0, 0.1, 0.25};
  setting.width = 0.95;
  setting.height = 0.95;
  return setting;
}

Setting
bin()
{
  Setting setting;
  addFloor(setting, 1.5);
  setting.supports.push_back(addBox(setting, {0, 0, 0.3}, {0.6, 0.4, 0.02}));
  for (const double side : {-1.0, 1.0}) {
    addBox(setting, {side * 0.305, 0, 0.39}, {0.01, 0.42, 0.2});
    addBox(setting, {0, side * 0.205, 0.39}, {0.6, 0.01, 0.2});
  }
  addThings(setting, tilted({0, 0, 0.31}, 0.0), {-0.14, 0.02, 0}, {0.13, -0.02, 0});
  setting.eye = {0.0, -0.45, 1.2};
  setting.target = {0.0, 0.0, 0.31};
  setting.width = 0.9;
  setting.height = 0.8;
  return setting;
}

Setting
tiltedTable()
{
  Setting setting;
  addFloor(setting, 1.5);
  const Pose top = tilted({0, 0, 0.6}, 25.0);
  Pose board = top;
  board.origin = top.toWorld({0, 0, -0.015});
  setting.supports.push_back(addTurnedBox(setting, board, {0.7, 0.5, 0.03}));
  addThings(setting, top, {-0.15, 0.03, 0}, {0.14, -0.05, 0});
  setting.eye = {0.2, -0.7, 1.3};
  setting.target = {0.0, 0.0, 0.55};
  setting.width = 1.0;
  setting.height = 0.9;
  return setting;
}

/** \brief A bar near the camera hides what is in the middle of a table. */
Setting
behindABar()
{
  Setting setting;
  addFloor(setting, 1.5);
  setting.supports.push_back(addBox(setting, {0, 0, 0.585}, {0.8, 0.5, 0.03}));
  addThings(setting, tilted({0, 0, 0.6}, 0.0), {-0.25, 0.02, 0}, {0.24, 0.0, 0});
  addBox(setting, {0, -0.3, 1.0}, {0.06, 0.03, 1.2});
  setting.eye = {0.0, -0.7, 1.3};
  setting.target = {0.0, 0.0, 0.6};
  setting.width = 1.0;
  setting.height = 0.8;
  return setting;
}

/** \brief Of a table and the things on it the lower left corner is seen. */
Setting
cutByTheImage()
{
  Setting setting;
  addFloor(setting, 1.5);
  setting.supports.push_back(addBox(setting, {0.3, 0.3, 0.585}, {0.9, 0.7, 0.03}));
  addThings(setting, tilted({0.1, 0.1, 0.6}, 0.0), {0, 0, 0}, {0.22, 0.06, 0});
  setting.eye = {0.0, -0.7, 1.3};
  setting.target = {0.05, 0.0, 0.6};
  setting.width = 0.6;
  setting.height = 0.5;
  return setting;
}

/** \brief A board seen from above its front side. */
Setting
board()
{
  Setting setting;
  addFloor(setting, 1.5);
  setting.supports.push_back(addBox(setting, {0, 0, 0.585}, {0.9, 0.6, 0.03}));
  setting.eye = {0.0, -0.7, 1.3};
  setting.target = {0.0, 0.0, 0.6};
  setting.width = 1.0;
  setting.height = 0.8;
  return setting;
}

/** \brief Upright, before what lies in the middle of a board. */
void
addPost(Setting& setting)
{
  setting.things.push_back(addBox(setting, {0, -0.02, 0.72}, {0.07, 0.05, 0.24}));
}

/** \brief The post hides the middle of a box. */
Setting
boxBehindAPost()
{
  Setting setting = board();
  addPost(setting);
  setting.things.push_back(addBox(setting, {0, 0.12, 0.635}, {0.36, 0.09, 0.07}));
  return setting;
}

/** \brief Or of a cylinder that lies on its side. */
Setting
cylinderBehindAPost()
{
  Setting setting = board();
  addPost(setting);
  constexpr double radius = 0.05, length = 0.36;
  Pose lying;
  lying.axes = {Vec3{0, 1, 0}, Vec3{0, 0, 1}, Vec3{1, 0, 0}};
  lying.origin = {-0.5 * length, 0.12, 0.6 + radius};
  setting.world.solids.push_back({Shape::Cylinder, {radius, length, 0}, lying});
  setting.things.push_back(static_cast<int>(setting.world.solids.size()));
  return setting;
}

/** \brief In one line, as the ends of one box would be; but one sees between them. */
Setting
boxesInLine()
{
  Setting setting = board();
  for (const double side : {-1.0, 1.0})
    setting.things.push_back(
        addBox(setting, {side * 0.11, 0.12, 0.635}, {0.14, 0.09, 0.07}));
  return setting;
}

/** \brief Of other heights, and the post hides their gap. */
Setting
boxesBehindAPost()
{
  Setting setting = board();
  addPost(setting);
  setting.things.push_back(addBox(setting, {-0.11, 0.12, 0.635}, {0.14, 0.09, 0.07}));
  setting.things.push_back(addBox(setting, {0.11, 0.12, 0.645}, {0.14, 0.09, 0.09}));
  return setting;
}

scene::Camera
cameraOf(const Setting& setting, double spacing)
{
  scene::Camera camera;
  const Vec3 forward = normalized(setting.target - setting.eye);
  const Vec3 right = normalized(cross(forward, Vec3{0, 0, 1}));
  camera.width = static_cast<unsigned>(setting.width / spacing);
  camera.height = static_cast<unsigned>(setting.height / spacing);
  camera.focal = norm(setting.target - setting.eye) / spacing;
  camera.pose = {{right, cross(forward, right), forward}, setting.eye};
  return camera;
}

struct Image {
  Cloud::Ptr cloud = pcl::make_shared<Cloud>();
  std::vector<int> seen; ///< of each point
};

/** \brief With white noise of a tenth of the spacing.
 * \param[in] ripple one sigma of waves that are 15 pixels long, in spacings */
Image
imageOf(Setting setting, double spacing, double ripple)
{
  setting.world.camera = cameraOf(setting, spacing);
  const scene::Camera& camera = setting.world.camera;
  scene::Random random(3, 1);
  const scene::Field waves =
      scene::gridField(camera.width, camera.height, 15.0, random);
  const scene::View view = scene::look(setting.world);
  Image image;
  for (std::size_t i = 0; i < view.sights.size(); ++i) {
    if (view.sights[i].object == scene::nothing)
      continue;
    const double off = spacing * (0.1 * random.normal() + ripple * waves[i]);
    const Vec3 point = camera.direction(i) * (view.sights[i].depth + off);
    image.cloud->emplace_back(static_cast<float>(point.x),
                              static_cast<float>(point.y),
                              static_cast<float>(point.z));
    image.seen.push_back(view.sights[i].object);
  }
  return image;
}

/** \brief How many points of each thing an instance has. */
std::map<int, double>
countsOf(const ShapeInstance& instance, const Image& image)
{
  std::map<int, double> counts;
  for (const index_t i : instance.indices)
    ++counts[image.seen[static_cast<std::size_t>(i)]];
  return counts;
}

/** \brief Intersection over union with the instance that covers it best. */
double
bestOverlap(const Image& image, const std::vector<ShapeInstance>& instances, int thing)
{
  const auto all =
      static_cast<double>(std::count(image.seen.begin(), image.seen.end(), thing));
  double best = 0.0;
  for (const ShapeInstance& instance : instances) {
    const double both = countsOf(instance, image)[thing];
    best = std::max(best,
                    both / (static_cast<double>(instance.indices.size()) + all - both));
  }
  return best;
}

double
takenShare(const Image& image, const std::vector<ShapeInstance>& instances, int support)
{
  double taken = 0.0;
  for (const ShapeInstance& instance : instances)
    taken += countsOf(instance, image)[support];
  return taken /
         static_cast<double>(std::count(image.seen.begin(), image.seen.end(), support));
}

struct Case {
  const char* name;
  Setting (*setting)();
  double spacing, ripple;
};

void
PrintTo(const Case& of, std::ostream* stream)
{
  *stream << of.name << ", " << of.spacing << " m, ripple " << of.ripple;
}

class SupportsOfScenes : public testing::TestWithParam<Case> {};

TEST_P(SupportsOfScenes, AreNoObjectsAndCarryOnes)
{
  const Setting setting = GetParam().setting();
  const Image image = imageOf(setting, GetParam().spacing, GetParam().ripple);
  ShapeInstanceSegmentation<PointXYZ> segmentation;
  segmentation.setInputCloud(image.cloud);
  segmentation.setClass("object");
  std::vector<ShapeInstance> instances;
  ASSERT_TRUE(segmentation.segment(instances));
  for (const int support : setting.supports)
    EXPECT_LT(takenShare(image, instances, support), 0.02) << "support " << support;
  for (const int thing : setting.things)
    EXPECT_GT(bestOverlap(image, instances, thing), 0.8) << "thing " << thing;
}

std::vector<Case>
casesOf(const char* name, Setting (*setting)())
{
  return {{name, setting, 0.003, 0.0}, {name, setting, 0.0045, 0.0}};
}

std::vector<Case>
allCases()
{
  std::vector<Case> cases;
  const auto addAll = [&](const std::vector<Case>& some) {
    cases.insert(cases.end(), some.begin(), some.end());
  };
  addAll(casesOf("Shelf", shelf));
  addAll(casesOf("Bin", bin));
  addAll(casesOf("TiltedTable", tiltedTable));
  addAll(casesOf("BehindABar", behindABar));
  addAll(casesOf("CutByTheImage", cutByTheImage));
  addAll(casesOf("BoxBehindAPost", boxBehindAPost));
  addAll(casesOf("CylinderBehindAPost", cylinderBehindAPost));
  addAll(casesOf("BoxesInLine", boxesInLine));
  addAll(casesOf("BoxesBehindAPost", boxesBehindAPost));
  for (Case wavy : casesOf("WavyTable", tiltedTable)) {
    wavy.ripple = 0.7;
    cases.push_back(wavy);
  }
  return cases;
}

INSTANTIATE_TEST_SUITE_P(
    Settings, SupportsOfScenes, testing::ValuesIn(allCases()), [](const auto& info) {
      return info.param.name + std::to_string(std::lround(1e4 * info.param.spacing));
    });

} // namespace
