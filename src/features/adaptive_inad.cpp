// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Normals and INAD at radii that follow the density and the noise of a cloud.

#include "features/adaptive_inad.h"

#include <pcl/features/impl/neighborhoods.hpp>

namespace pcl::detail {
namespace {

/** Towards the origin, where most sensors are: angles between normals on one side take
 * half the time, and what they are is the same. */
void
orient(const XYZView& points, std::vector<Eigen::Vector3f>& normals)
{
  for (std::size_t i = 0; i < points.size; ++i) {
    Eigen::Vector3f& n = normals[i];
    const float* p = points[i];
    if (n[0] * p[0] + n[1] * p[1] + n[2] * p[2] > 0.0f)
      n = -n;
  }
}

std::vector<Eigen::Vector3f>
unitNormals(const XYZView& given)
{
  std::vector<Eigen::Vector3f> normals;
  normals.reserve(given.size);
  for (std::size_t i = 0; i < given.size; ++i) {
    const Eigen::Vector3f normal(given[i]);
    normals.emplace_back(normal / normal.norm());
  }
  return normals;
}

} // namespace

AdaptiveINAD
adaptiveINAD(const FieldInput& input,
             const std::vector<float>& spacings,
             const INADParameters& parameters)
{
  const std::size_t size = input.points.size;
  std::vector<float> radii(size);
  const auto ofSpacings = [&](double count) {
    for (std::size_t i = 0; i < size; ++i)
      radii[i] = static_cast<float>(count) * spacings[i];
    return NeighborhoodSize::ofRadii(radii.data());
  };
  AdaptiveINAD result{{}, std::vector<float>(2 * size)};
  if (input.normals.size > 0)
    result.normals = unitNormals(input.normals);
  else {
    result.normals.resize(size);
    std::vector<float> curvature(3 * size);
    input.neighborhoods.computeNormals(ofSpacings(parameters.normal_radius),
                                       result.normals.data()->data(),
                                       curvature.data(),
                                       3);
  }
  orient(input.points, result.normals);
  input.neighborhoods.computeINAD(ofSpacings(parameters.radius),
                                  {result.normals.data()->data(), 3, size},
                                  parameters.outlier_rate,
                                  result.mu_sigma.data());
  return result;
}

} // namespace pcl::detail
