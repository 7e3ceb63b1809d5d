// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// What finding edges needs to know of a cloud, and of the voxel means that stand for
// it.

#include "edges/measured_cloud.h"

#include "common/gathered.h"
#include "geometry/voxel_means.h"

#include <pcl/features/impl/neighborhoods.hpp>

#include <utility>

namespace pcl::detail {
namespace {

// Half of the points are left, so that creases stay, and the noise that a few neighbors
// share is another one.
constexpr double next_voxel = 0.7; // spacings
// From the mean of a voxel to the 12th on a plane that fills its voxels.
constexpr double means_distance = 1.9; // voxels

} // namespace

MeasuredCloud
measureCloud(const FieldInput& input, ShapeField& field)
{
  return measureCloud(input,
                      input.of_cloud
                          ? localSpacings(input.neighborhoods, *input.of_cloud)
                          : localSpacings(input.neighborhoods, input.is_even),
                      field);
}

MeasuredCloud
measureCloud(const FieldInput& input, std::vector<float> spacings, ShapeField& field)
{
  const CloudNumbers* const of_cloud = input.of_cloud;
  field.spacings = std::move(spacings);
  const float spacing = spacingOfCloud(input, field.spacings);
  MeasuredCloud measured{spacing, {}, countFinite(input.points)};
  field.noise =
      of_cloud ? of_cloud->noise : noiseOf(input.neighborhoods, field.spacings);
  // Of normals of one's own it is not known which noise is left in them.
  measured.noise =
      of_cloud ? NoiseLevel{of_cloud->noise_level, of_cloud->noise_correlation}
      : input.normals.size > 0
          ? NoiseLevel{field.noise, 1.0}
          : noiseLevelOf(
                input.neighborhoods, field.spacings, field.noise, input.threads);
  field.noise_level = measured.noise.level;
  return measured;
}

void
setNoiseLevel(const NoiseLevel& noise, CloudNumbers& numbers)
{
  numbers.noise_level = noise.level;
  numbers.noise_correlation = noise.correlation;
}

NextLevel
nextLevel(const CloudNumbers& numbers)
{
  NextLevel level;
  level.size = next_voxel * static_cast<double>(numbers.spacing);
  level.numbers.distance = means_distance * level.size;
  level.numbers.spacing = static_cast<float>(level.numbers.distance);
  // As thick as it was, for neighbors share it.
  level.numbers.noise = numbers.noise / (means_distance * next_voxel);
  level.numbers.noise_level = level.numbers.noise;
  level.numbers.noise_correlation = 1.0;
  return level;
}

MeansOfCloud
meansOfCloud(const FieldInput& input, const MeasuredCloud& measured, double noise)
{
  CloudNumbers numbers;
  numbers.spacing = measured.spacing;
  numbers.noise = noise;
  const NextLevel level = nextLevel(numbers);
  MeansOfCloud means;
  means.positions = voxelMeans(input.points, level.size, input.threads);
  means.points = viewOfPositions(means.positions);
  means.neighborhoods =
      std::make_shared<const Neighborhoods>(means.points, input.threads);
  means.field.spacings = input.is_even
                             ? localSpacings(*means.neighborhoods, true)
                             : localSpacings(*means.neighborhoods, level.numbers);
  means.field.noise = level.numbers.noise;
  means.field.noise_level = level.numbers.noise_level;
  means.measured = {
      level.numbers.spacing, {means.field.noise_level, 1.0}, means.points.size};
  return means;
}

} // namespace pcl::detail
