// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// The spacing of points, the noise of a cloud, and radii measured in them.

#include "features/spacing/local_spacing.h"

#include "common/finite.h"
#include "common/gathered.h"
#include "common/statistics.h"
#include "features/spacing/some_points.h"

#include <pcl/features/impl/neighborhoods.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace pcl::detail {
namespace {

constexpr std::size_t nearest = 13; // the point itself and 12 neighbors
constexpr double min_ratio = 0.6;
constexpr double max_ratio = 3.0;
constexpr double max_contrast = 10.0; // of spacings that are taken as they are
constexpr float full_depth = 0.8f;    // meters
constexpr double noise_spacings = 1.5;
constexpr std::size_t noise_points = 20000; // the percentile is then known to 1 %

/** The value that a share of the finite ones is below; 0 if there is none. */
float
quantileOfFinite(std::vector<float> values, double share)
{
  values = segmentation::finiteOf(std::move(values));
  return values.empty() ? 0.0f : segmentation::quantile(std::move(values), share);
}

/** In multiples of the radius. */
std::vector<float>
depthFactors(const Neighborhoods& neighborhoods)
{
  std::vector<float> factors;
  factors.reserve(neighborhoods.size());
  for (std::size_t i = 0; i < neighborhoods.size(); ++i) {
    const auto point = static_cast<std::size_t>(neighborhoods.pointAt(i));
    const float z = neighborhoods.input()[point][2];
    factors.push_back(std::isfinite(z) ? std::max(1.0f, z / full_depth) : 1.0f);
  }
  return factors;
}

double
medianOf(const std::vector<float>& distances)
{
  std::vector<float> positive;
  for (const float d : distances)
    if (d > 0.0f)
      positive.push_back(d);
  return positive.empty() ? 1.0 : quantileOfFinite(std::move(positive), 0.5);
}

} // namespace

float
spacingOf(float distance, double median)
{
  const double ratio = std::isfinite(distance) ? distance / median : 1.0;
  return static_cast<float>(median *
                            std::sqrt(std::clamp(ratio, min_ratio, max_ratio)));
}

double
mostSpacing(double median)
{
  return median * std::sqrt(max_ratio);
}

double
spacingReach(double median)
{
  return median * max_ratio;
}

std::vector<float>
spacingsOf(std::vector<float> distances)
{
  const double median = medianOf(distances);
  for (float& d : distances)
    d = spacingOf(d, median);
  return distances;
}

std::vector<float>
evenSpacingsOf(std::vector<float> distances)
{
  const double median = medianOf(distances);
  for (float& d : distances)
    d = static_cast<float>(
        median * (std::isfinite(d)
                      ? std::clamp(d / median, 1.0 / max_contrast, max_contrast)
                      : 1.0));
  return distances;
}

std::vector<float>
distancesToTwelfth(const Neighborhoods& neighborhoods)
{
  std::vector<float> distances(neighborhoods.size());
  neighborhoods.computeDistanceToNearest(nearest, distances.data());
  return distances;
}

std::vector<float>
localSpacings(const Neighborhoods& neighborhoods, const CloudNumbers& of_cloud)
{
  std::vector<float> distances = distancesToTwelfth(neighborhoods);
  const bool are_few = countFinite(neighborhoods.input()) < nearest;
  for (std::size_t i = 0; i < distances.size(); ++i) {
    const bool is_far = are_few && kernels::isFinite(neighborhoods.input()[i]);
    distances[i] = spacingOf(is_far ? std::numeric_limits<float>::max() : distances[i],
                             of_cloud.distance);
  }
  return distances;
}

std::vector<float>
localSpacings(const Neighborhoods& neighborhoods, bool is_even)
{
  std::vector<float> distances = distancesToTwelfth(neighborhoods);
  return is_even ? evenSpacingsOf(std::move(distances))
                 : spacingsOf(std::move(distances));
}

std::vector<float>
times(double factor, std::vector<float> lengths)
{
  for (float& length : lengths)
    length *= static_cast<float>(factor);
  return lengths;
}

std::vector<float>
radiiInMeters(double radius, std::vector<float> units)
{
  using Limits = std::numeric_limits<float>;
  for (float& r : units)
    r = std::clamp(static_cast<float>(radius) * r, Limits::min(), Limits::max());
  return units;
}

std::vector<float>
adaptiveRadii(AdaptiveRadius::RadiusMode mode,
              double radius,
              const Neighborhoods& neighborhoods)
{
  return radiiInMeters(radius,
                       mode == AdaptiveRadius::DEPTH ? depthFactors(neighborhoods)
                                                     : localSpacings(neighborhoods));
}

std::vector<float>
normalsWithCurvature(const Neighborhoods& neighborhoods,
                     const std::vector<float>& radii)
{
  std::vector<float> normals(4 * radii.size());
  neighborhoods.computeNormals(
      NeighborhoodSize::ofRadii(radii.data()), normals.data(), normals.data() + 3, 4);
  return normals;
}

double
noiseOf(const Neighborhoods& neighborhoods, const std::vector<float>& spacings)
{
  const XYZView& points = neighborhoods.input();
  return noiseOfVariations(
      variationsAt(noisePoints(points, countFinite(points)), neighborhoods, spacings));
}

pcl::Indices
noisePoints(const XYZView& points, std::uint64_t of_points)
{
  return somePoints(points, noise_points, of_points);
}

double
variationReach()
{
  return noise_spacings;
}

std::vector<float>
variationsAt(const pcl::Indices& chosen,
             const Neighborhoods& neighborhoods,
             const std::vector<float>& spacings)
{
  if (chosen.empty())
    return {};
  const std::vector<float> normals = normalsWithCurvature(
      neighborhoods.among(chosen), times(noise_spacings, gathered(spacings, chosen)));
  std::vector<float> variations;
  for (std::size_t i = 0; i < chosen.size(); ++i)
    variations.push_back(normals[4 * i + 3]);
  return variations;
}

double
noiseOfVariations(std::vector<float> variations)
{
  const double variation = quantileOfFinite(std::move(variations), 0.2);
  return std::min(max_noise, 1.55 * noise_spacings * std::sqrt(0.5 * variation));
}

INADParameters
withNoise(INADParameters parameters, double noise)
{
  parameters.normal_radius += parameters.normal_radius_noise * noise;
  parameters.radius += parameters.radius_noise * noise;
  parameters.normal_radius_noise = parameters.radius_noise = 0.0;
  return parameters;
}

} // namespace pcl::detail
