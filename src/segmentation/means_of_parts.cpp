// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Voxel means of a part of a cloud, and which of them stands for a point.

#include "common/gathered.h"
#include "common/number_text.h"
#include "features/noise/noise_level.h"
#include "features/spacing/local_spacing.h"
#include "geometry/voxel_means.h"

#include <pcl/segmentation/means_of_parts.h>

#include <algorithm>
#include <cmath>

namespace pcl {
namespace {

double
voxelDiagonal(double resolution)
{
  return std::sqrt(3.0) * resolution;
}

} // namespace

MeansOfPart
meansOfPart(const XYZView& places, const std::vector<bool>& is_own, double resolution)
{
  return {detail::voxelMeans(places, resolution),
          detail::gathered(is_own, detail::firstInVoxels(places, resolution))};
}

std::vector<std::int32_t>
nearestMeans(const XYZView& points,
             const XYZView& means,
             std::vector<float> spacings,
             double resolution,
             unsigned threads)
{
  for (float& spacing : spacings)
    spacing = std::max(spacing, static_cast<float>(voxelDiagonal(resolution)));
  return detail::representatives(points, means, spacings, threads);
}

double
reachOfMeans(double distance, double resolution)
{
  return std::max(detail::mostSpacing(distance), voxelDiagonal(resolution));
}

double
coarserResolution(const CloudNumbers& numbers, std::uint64_t places, double resolution)
{
  constexpr double voxel = 0.8; // spacings: half of the points on a surface are left
  // Where the means of a surface have half of the places, voxels are 1.4 times as wide.
  constexpr double grows = 1.2;
  constexpr std::uint64_t dense = 20000; // fewer are not closer than a sensor can tell
  const double size = voxel * static_cast<double>(numbers.spacing);
  const detail::NoiseLevel noise{numbers.noise_level, numbers.noise_correlation};
  if (!noise.isBeyondRadii() || places < dense || size <= grows * resolution)
    return 0.0;
  return detail::twoDigits(size);
}

std::string
problemOfResolution(double resolution, const std::vector<float>& corners)
{
  return detail::problemOfResolution(resolution, detail::viewOfPositions(corners));
}

} // namespace pcl
