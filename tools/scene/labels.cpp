// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Silhouettes, and the labels of what is beside creases, silhouettes and neither.

#include "scene/labels.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace pcl::scene {
namespace {

/** What a pixel covers on the surface it sees, in meters, at grazing angles capped. */
double
pixelFootprint(const Camera& camera, const Sight& sight)
{
  const Vec3 towards_eye = normalized(camera.pose.origin - sight.point);
  return sight.depth / camera.focal / std::max(0.3, dot(towards_eye, sight.normal));
}

bool
meet(const Camera& camera, const Sight& a, const Sight& b)
{
  if (a.object == nothing || b.object == nothing)
    return std::max(a.object, b.object) <= table_index;
  if (a.object == b.object && a.face == b.face)
    return true;
  constexpr double slack = 0.002;
  const double tolerance =
      slack + pixelFootprint(camera, a) + pixelFootprint(camera, b);
  const Vec3 between = b.point - a.point;
  return std::max(std::abs(dot(between, a.normal)), std::abs(dot(between, b.normal))) <=
         tolerance;
}

} // namespace

std::vector<char>
silhouettes(const World& world, const View& view)
{
  const std::size_t width = view.width;
  std::vector<char> marks(view.sights.size(), 0);
  const auto compare = [&](std::size_t i, std::size_t j) {
    if (!meet(world.camera, view.sights[i], view.sights[j]))
      marks[i] = marks[j] = 1;
  };
  for (std::size_t i = 0; i < marks.size(); ++i) {
    if ((i + 1) % width != 0)
      compare(i, i + 1);
    if (i + width < marks.size())
      compare(i, i + width);
  }
  return marks;
}

std::vector<char>
dilated(const std::vector<char>& marks, unsigned width, unsigned height, double radius)
{
  const int reach = static_cast<int>(std::floor(radius));
  std::vector<char> result(marks.size(), 0);
  for (std::size_t i = 0; i < marks.size(); ++i)
    if (marks[i])
      forEachAround(i, width, height, reach, [&](std::size_t other, int squared) {
        if (squared <= radius * radius)
          result[other] = 1;
      });
  return result;
}

void
label(const World& world,
      const View& view,
      const Creases& creases,
      const std::vector<char>& beside_gap,
      Scene& scene)
{
  const ThinPlaces thin_places(world);
  scene.surface.assign(view.sights.size(), SurfaceVoid);
  scene.edge.assign(view.sights.size(), EdgeVoid);
  scene.instance.assign(view.sights.size(), 0);
  scene.face.assign(view.sights.size(), 0);
  scene.crease_mm.assign(view.sights.size(), std::numeric_limits<float>::quiet_NaN());
  for (std::size_t i = 0; i < view.sights.size(); ++i) {
    const Sight& sight = view.sights[i];
    if (sight.object == nothing || std::isnan(scene.xyz[3 * i]))
      continue;
    const double distance = creases.distance(sight.point, crease_cap);
    scene.crease_mm[i] = static_cast<float>(1000.0 * distance);
    scene.instance[i] = static_cast<std::uint32_t>(sight.object);
    scene.face[i] = static_cast<std::uint32_t>(sight.face);
    if (distance < crease_band) {
      scene.surface[i] = SurfaceCrease;
      scene.edge[i] = distance < edge_band ? EdgeCrease : EdgeVoid;
    }
    else if (!beside_gap[i] && !thin_places.areNear(sight, crease_band)) {
      scene.surface[i] = isCurved(world, sight) ? SurfaceCurved : SurfacePlanar;
      scene.edge[i] = EdgeNot;
    }
  }
}

} // namespace pcl::scene
