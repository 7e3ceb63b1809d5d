// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Places the camera so that all points are seen, and reads and writes -camera.

#include "viewer/camera.h"

#include "cli/arguments.h"
#include "io/errors.h"
#include "io/text.h"

#include <pcl/common/common.h>
#include <pcl/common/point_tests.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>
#include <vector>

namespace pcl::app {
namespace {

using Cloud = pcl::PointCloud<pcl::PointXYZ>;

constexpr float usual_angle = 30.0f; // degrees
constexpr float degrees_per_radian = 57.2957795f;
constexpr float margin = 1.04f;

float
quantile(std::vector<float> values, double share)
{
  const auto at = values.begin() + static_cast<std::ptrdiff_t>(
                                       share * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

/** Columns: right, up, backwards. */
Eigen::Matrix3f
axesOf(const Camera& camera)
{
  const Eigen::Vector3f back = (camera.position - camera.focus).normalized();
  const Eigen::Vector3f right = camera.up.cross(back).normalized();
  Eigen::Matrix3f axes;
  axes << right, back.cross(right), back;
  return axes;
}

/** Where points are in a picture at distance 1: the least and the largest x and y. */
Eigen::AlignedBox2f
pictureOf(const Camera& camera, const Cloud& points)
{
  const Eigen::Matrix3f to_camera = axesOf(camera).transpose();
  Eigen::AlignedBox2f picture;
  for (const pcl::PointXYZ& point : points) {
    if (!pcl::isXYZFinite(point))
      continue;
    const Eigen::Vector3f seen = to_camera * (point.getVector3fMap() - camera.position);
    if (seen.z() < 0.0f)
      picture.extend(seen.head<2>() / -seen.z());
  }
  return picture;
}

/** Turn the camera to the middle of the points and widen its view to hold them all. */
void
frame(Camera& camera, const Cloud& points, float aspect)
{
  const Eigen::Vector2f middle = pictureOf(camera, points).center();
  const float distance = (camera.focus - camera.position).norm();
  camera.focus = camera.position + axesOf(camera) *
                                       Eigen::Vector3f(middle.x(), middle.y(), -1.0f) *
                                       distance;
  const Eigen::AlignedBox2f picture = pictureOf(camera, points);
  const Eigen::Vector2f half =
      picture.min().cwiseAbs().cwiseMax(picture.max().cwiseAbs());
  const float height = std::max({half.y(), half.x() / aspect, 1e-4f});
  camera.angle =
      std::min(2.0f * std::atan(margin * height) * degrees_per_radian, 120.0f);
}

/** Whether a sensor at the viewpoint could have seen the cloud as it is drawn. */
bool
isInFront(const Cloud& points, const Eigen::AlignedBox3f& box)
{
  constexpr float farthest = 20.0f; // times the cloud's size
  const Eigen::Vector3f eye = points.sensor_origin_.head<3>();
  const Eigen::Vector3f forward = points.sensor_orientation_ * Eigen::Vector3f::UnitZ();
  const Eigen::Vector3f ray = box.center() - eye;
  return !box.contains(eye) && ray.norm() < farthest * box.diagonal().norm() &&
         ray.dot(forward) > 0.5f * ray.norm();
}

} // namespace

Eigen::AlignedBox3f
boxOf(const Cloud& points)
{
  Eigen::AlignedBox3f box;
  for (const pcl::PointXYZ& point : points)
    if (pcl::isXYZFinite(point))
      box.extend(point.getVector3fMap());
  return box;
}

std::size_t
hideStrays(Cloud& points)
{
  constexpr double usual_share = 0.95; // of the points ...
  constexpr double farthest = 10.0; // ... are no further than a tenth of what is shown
  std::vector<float> coordinates[3];
  for (const pcl::PointXYZ& point : points)
    for (int axis = 0; axis < 3 && pcl::isXYZFinite(point); ++axis)
      coordinates[axis].push_back(point.data[axis]);
  Eigen::Vector3d middle;
  for (int axis = 0; axis < 3; ++axis)
    middle[axis] = quantile(coordinates[axis], 0.5);
  const auto distanceOf = [&](const pcl::PointXYZ& point) {
    return (point.getVector3fMap().cast<double>() - middle).cwiseAbs().maxCoeff();
  };
  std::vector<float> distances;
  for (const pcl::PointXYZ& point : points)
    if (pcl::isXYZFinite(point))
      distances.push_back(static_cast<float>(distanceOf(point)));
  const double usual = quantile(std::move(distances), usual_share);
  std::size_t hidden = 0;
  for (pcl::PointXYZ& point : points)
    if (usual > 0.0 && pcl::isXYZFinite(point) &&
        distanceOf(point) > farthest * usual) {
      point.getVector3fMap().setConstant(std::numeric_limits<float>::quiet_NaN());
      points.is_dense = false;
      ++hidden;
    }
  return hidden;
}

Camera
defaultCamera(const Cloud& points, float aspect)
{
  const Eigen::AlignedBox3f box = boxOf(points);
  // Of a point alone, so large that float tells the camera from it.
  const float min_size = std::max(1e-4f * box.center().norm(), 1e-6f);
  const float size = std::max(box.diagonal().norm(), min_size);
  Camera camera{points.sensor_origin_.head<3>(), box.center(), {}, usual_angle};
  if (isInFront(points, box))
    camera.up = points.sensor_orientation_ * -Eigen::Vector3f::UnitY();
  else {
    camera.position = box.center() + 2.0f * size * Eigen::Vector3f(-0.5f, -0.7f, 0.5f);
    camera.up = Eigen::Vector3f::UnitZ();
  }
  frame(camera, points, aspect);
  return camera;
}

Camera
parseCamera(const std::string& text)
{
  constexpr const char* expected =
      ": expected x,y,z of the position, of the focus (another point) and of up (not "
      "along the view), and perhaps the angle of view, above 0 and below 180 degrees";
  std::vector<float> values;
  std::istringstream words(text);
  for (std::string word; std::getline(words, word, ',');) {
    const auto value = parseNumber(word);
    if (!value)
      throw UsageError("-camera '" + text + "'" + expected);
    values.push_back(static_cast<float>(*value));
  }
  if (values.size() == 9)
    values.push_back(usual_angle);
  if (values.size() != 10 || !(values[9] > 0.0f && values[9] < 180.0f))
    throw UsageError("-camera '" + text + "'" + expected);
  const Camera camera{Eigen::Vector3f(values.data()),
                      Eigen::Vector3f(values.data() + 3),
                      Eigen::Vector3f(values.data() + 6),
                      values[9]};
  const Eigen::Vector3f view = camera.focus - camera.position;
  if (!(view.cross(camera.up).norm() > 1e-6f * view.norm() * camera.up.norm()))
    throw UsageError("-camera '" + text + "'" + expected);
  return camera;
}

std::string
toText(const Camera& camera)
{
  std::string text;
  for (const Eigen::Vector3f& vector : {camera.position, camera.focus, camera.up})
    for (const float value : vector) {
      appendNumber(value, text);
      text += ',';
    }
  appendNumber(camera.angle, text);
  return text;
}

} // namespace pcl::app
