// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// The two ends of a box on either side of a gap, which a post may hide.

#pragma once

#include "instances/instance_points.h"
#include "small_surfaces.h"

#include <numeric>
#include <random>

namespace pcl::test {

/** \brief Faces that a viewpoint sees; the spacing is 1. */
struct FaceScene {
  Surface surface;
  segmentation::Labels faces; ///< of the points

  void
  add(const Surface& face)
  {
    const std::int32_t label = faces.empty() ? 0 : faces.back() + 1;
    surface.append(face);
    faces.resize(surface.size(), label);
  }

  detail::InstanceInput
  input(unsigned threads = 1) const
  {
    detail::InstanceInput input = inputOf(surface);
    input.view_point = {0.0f, -60.0f, 30.0f};
    input.threads = threads;
    return input;
  }
};

/** \brief A level face, 20 by 10. \param[in] x of its left side */
inline Surface
topAt(double x, double z = 0.0)
{
  return floorPatch(x, 0.0, z, 41, 21);
}

/** \brief The face below its front edge. */
inline Surface
frontAt(double x)
{
  return patch({x, 0, -10}, Eigen::Vector3d::UnitX(), Eigen::Vector3d::UnitZ(), 41, 20);
}

/** \brief A post before x = -half_width to half_width, as the viewpoint sees it. */
inline Surface
post(double half_width)
{
  const int columns = static_cast<int>(4.0 * half_width) + 1;
  return patch({-half_width, -10, -12},
               Eigen::Vector3d::UnitX(),
               Eigen::Vector3d::UnitZ(),
               columns,
               60);
}

/** \brief Tops are faces 0 and 2, fronts 1 and 3. */
inline FaceScene
endsOfABox(double gap)
{
  FaceScene scene;
  for (const double x : {-20.0 - 0.5 * gap, 0.5 * gap}) {
    scene.add(topAt(x));
    scene.add(frontAt(x));
  }
  return scene;
}

/** \brief The same points in another order. */
inline FaceScene
shuffled(const FaceScene& scene)
{
  std::vector<std::size_t> order(scene.faces.size());
  std::iota(order.begin(), order.end(), 0U);
  std::shuffle(order.begin(), order.end(), std::mt19937(7));
  FaceScene other;
  for (const std::size_t i : order) {
    other.surface.add({scene.surface.position(i), scene.surface.normal(i)});
    other.faces.push_back(scene.faces[i]);
  }
  return other;
}

} // namespace pcl::test
