// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Normals and INAD at radii that follow the density and the noise of a cloud.

#include "features/adaptive_inad.h"

#include "common/gathered.h"
#include "common/parallel.h"
#include "common/statistics.h"

#include <pcl/features/impl/neighborhoods.hpp>

namespace pcl::detail {
namespace {

/** Towards the origin, where most sensors are: angles between normals on one side take
 * half the time, and what they are is the same. */
void
orient(const XYZView& points, std::vector<Eigen::Vector3f>& normals, unsigned threads)
{
  kernels::parallelForEach(points.size, threads, [&](std::size_t i) {
    Eigen::Vector3f& n = normals[i];
    const float* p = points[i];
    if (n[0] * p[0] + n[1] * p[1] + n[2] * p[2] > 0.0f)
      n = -n;
  });
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

std::vector<Eigen::Vector3f>
estimatedNormals(const Neighborhoods& neighborhoods, const std::vector<float>& radii)
{
  std::vector<Eigen::Vector3f> normals(radii.size());
  std::vector<float> curvature(3 * radii.size());
  neighborhoods.computeNormals(NeighborhoodSize::ofRadii(radii.data()),
                               normals.data()->data(),
                               curvature.data(),
                               3);
  return normals;
}

} // namespace

float
spacingOfCloud(const FieldInput& input, const std::vector<float>& spacings)
{
  return input.of_cloud ? input.of_cloud->spacing
                        : segmentation::medianSpacing(spacings);
}

AdaptiveINAD
adaptiveINAD(const FieldInput& input,
             const std::vector<float>& spacings,
             const INADParameters& parameters)
{
  const std::size_t size = input.points.size;
  AdaptiveINAD result{input.normals.size > 0
                          ? unitNormals(input.normals)
                          : estimatedNormals(input.neighborhoods,
                                             times(parameters.normal_radius, spacings)),
                      std::vector<float>(2 * size)};
  orient(input.points, result.normals, input.threads);
  const std::vector<float> radii = times(parameters.radius, spacings);
  input.neighborhoods.computeINAD(NeighborhoodSize::ofRadii(radii.data()),
                                  {result.normals.data()->data(), 3, size},
                                  parameters.outlier_rate,
                                  result.mu_sigma.data());
  return result;
}

std::vector<float>
adaptiveINADAmong(const pcl::Indices& points,
                  const pcl::Indices& chosen,
                  const FieldInput& input,
                  const std::vector<float>& spacings,
                  const INADParameters& parameters)
{
  std::vector<float> mu_sigma(2 * chosen.size());
  if (chosen.empty())
    return mu_sigma;
  const std::vector<float> some = gathered(spacings, points);
  std::vector<Eigen::Vector3f> normals =
      input.normals.size > 0 ? gathered(unitNormals(input.normals), points)
                             : estimatedNormals(input.neighborhoods.among(points),
                                                times(parameters.normal_radius, some));
  const std::vector<float> positions = positionsAt(input.points, points);
  const XYZView cloud = viewOfPositions(positions);
  orient(cloud, normals, input.threads);
  const std::vector<float> radii = times(parameters.radius, gathered(some, chosen));
  Neighborhoods(cloud, cloud, chosen, input.threads)
      .computeINAD(NeighborhoodSize::ofRadii(radii.data()),
                   {normals.data()->data(), 3, normals.size()},
                   parameters.outlier_rate,
                   mu_sigma.data());
  return mu_sigma;
}

} // namespace pcl::detail
