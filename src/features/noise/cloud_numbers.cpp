// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// What a cloud's parts measure of it: distances, noise, normals.

#include "common/finite.h"
#include "features/noise/noise_level.h"
#include "features/noise/part_noise.h"
#include "features/spacing/local_spacing.h"

#include <pcl/features/cloud_numbers.h>
#include <pcl/features/impl/neighborhoods.hpp>

#include <limits>

namespace pcl {
namespace {

using namespace detail;

void
append(const std::vector<float>& from, std::vector<float>& to)
{
  to.insert(to.end(), from.begin(), from.end());
}

} // namespace

void
NoiseMeasures::add(const NoiseMeasures& other)
{
  append(other.variations, variations);
  for (std::size_t level = 0; level < angles.size(); ++level)
    append(other.angles[level], angles[level]);
  for (std::size_t means = 0; means < steps.size(); ++means) {
    steps[means].all += other.steps[means].all;
    steps[means].bent += other.steps[means].bent;
    steps[means].on_steps += other.steps[means].on_steps;
    steps[means].thick += other.steps[means].thick;
  }
  append(other.thicknesses, thicknesses);
}

void
setNoise(const NoiseMeasures& of_all_parts, CloudNumbers& numbers)
{
  numbers.noise = of_all_parts.variations.empty()
                      ? 0.0
                      : noiseOfVariations(of_all_parts.variations);
  const NoiseLevel level = noiseLevelOf(numbers.noise, of_all_parts);
  numbers.noise_level = level.level;
  numbers.noise_correlation = level.correlation;
}

float
spacingAt(float middle, double distance)
{
  return spacingOf(middle, distance);
}

PartOfCloud::PartOfCloud(const XYZView& places,
                         const std::vector<bool>& is_measured,
                         unsigned threads)
: places_(places)
, is_measured_(is_measured)
, threads_(threads)
{
  requireOneEach(places.size, is_measured.size(), "values of is_measured");
}

std::vector<float>
PartOfCloud::measureDistances(double reach) const
{
  pcl::Indices measured;
  for (std::size_t i = 0; i < places_.size; ++i)
    if (is_measured_[i])
      measured.push_back(static_cast<pcl::index_t>(i));
  constexpr float unknown = std::numeric_limits<float>::infinity();
  constexpr std::size_t nearest = 13; // with fewer points each is the 12th of none
  if (measured.empty() || countFinite(places_) < nearest)
    return std::vector<float>(measured.size(), unknown);
  std::vector<float> distances =
      distancesToTwelfth(Neighborhoods(places_, places_, measured, threads_));
  for (float& d : distances)
    if (!(d <= reach))
      d = unknown;
  return distances;
}

NoiseMeasures
PartOfCloud::measureNoise(const CloudNumbers& numbers, std::uint64_t places) const
{
  const auto measured = [&](const PointsNear& /*near*/, const Neighborhoods& among) {
    return localSpacings(among, numbers);
  };
  return noiseOfPart(places_,
                     is_measured_,
                     {spacingReach(numbers.distance), measured},
                     numbers,
                     places,
                     threads_);
}

std::vector<float>
PartOfCloud::normals(const CloudNumbers& numbers, double radius) const
{
  const Neighborhoods neighborhoods(places_, threads_);
  return normalsWithCurvature(
      neighborhoods, radiiInMeters(radius, localSpacings(neighborhoods, numbers)));
}

} // namespace pcl
