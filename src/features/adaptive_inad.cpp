// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// PURPOSE

#include "features/adaptive_inad.h"

namespace pcl::segmentation {
namespace {

/** Towards the origin, where most sensors are: angles between normals on one side take
 * half the time, and what they are is the same. */
void
orient(const XYZView& points, std::vector<float>& normals)
{
  for (std::size_t i = 0; i < points.size; ++i) {
    float* n = &normals[3 * i];
    const float* p = points[i];
    const bool is_away = n[0] * p[0] + n[1] * p[1] + n[2] * p[2] > 0.0f;
    for (int axis = 0; is_away && axis < 3; ++axis)
      n[axis] = -n[axis];
  }
}

} // namespace

AdaptiveINAD
adaptiveINAD(const detail::AdaptiveInput& input,
             const detail::AdaptiveEdges& edges,
             const INADParameters& parameters)
{
  const std::size_t size = input.points.size;
  const INADParameters p = detail::withNoise(parameters, edges.noise);
  std::vector<float> radii(size), curvature(3 * size);
  const auto ofSpacings = [&](double spacings) {
    for (std::size_t i = 0; i < size; ++i)
      radii[i] = static_cast<float>(spacings) * edges.spacings[i];
    return NeighborhoodSize::ofRadii(radii.data());
  };
  AdaptiveINAD result{std::vector<float>(3 * size), std::vector<float>(2 * size)};
  input.neighborhoods.computeNormals(
      ofSpacings(p.normal_radius), result.normals.data(), curvature.data(), 3);
  orient(input.points, result.normals);
  input.neighborhoods.computeINAD(ofSpacings(p.radius),
                                  {result.normals.data(), 3, size},
                                  p.outlier_rate,
                                  result.mu_sigma.data());
  return result;
}

} // namespace pcl::segmentation
