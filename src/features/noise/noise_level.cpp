// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// How far radii must grow for normals to be stable in the noise of a cloud.

#include "features/noise/noise_level.h"

#include "common/gathered.h"
#include "common/statistics.h"
#include "features/noise/edge_radii.h"
#include "features/noise/normal_scatter.h"
#include "features/noise/sensor_steps.h"
#include "features/noise/thin_plates.h"
#include "features/spacing/some_points.h"

#include <pcl/features/impl/neighborhoods.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <optional>

namespace pcl::detail {
namespace {

using namespace segmentation;
using namespace edge_radii;

// From one to the next the angles between the normals of white noise fall by a third.
constexpr std::array<double, 8> levels{0.0, 0.05, 0.075, 0.1, 0.15, 0.2, 0.25, 0.3};
constexpr std::size_t some = 500; // a tenth of them is known to 1.4 % of the points
constexpr double flattest = 0.1;  // away from creases even where they are crowded

// Radians, 2 degrees: a fifteenth of the least crease, and normals still tell its
// sides.
constexpr float stable = 0.035f;
// What is left of the scatter at the second level. Of white noise it is (1.2 / 1.7)^2 =
// 0.5; the noise of a depth camera, which neighbors share, leaves 0.65.
constexpr float white_left = 0.52f, correlated_left = 0.62f;

/** How sure it is that neighbors share their noise, 0 to 1. */
float
correlation(float left)
{
  return std::clamp((left - white_left) / (correlated_left - white_left), 0.0f, 1.0f);
}

/** Between two levels, the noise at whose radii normals are stable. */
double
crossing(double low, float at_low, double high, float at_high)
{
  const double share = std::log(at_low / stable) / std::log(at_low / at_high);
  return low + share * (high - low);
}

constexpr double most_radius = inad_radius + inad_radius_noise * levels.back();

/** With the radii for a noise. */
std::vector<float>
anglesAt(double noise, const NormalScatter& scatter)
{
  return scatter(normal_radius + normal_radius_noise * noise,
                 inad_radius + inad_radius_noise * noise);
}

/** Those on the flattest part of a cloud, 0 if nothing is known. */
float
flattestOf(std::vector<float> angles)
{
  return angles.empty() ? 0.0f : quantile(std::move(angles), flattest);
}

/** How sure it is that the shape keeps the scatter from falling, 0 to 1. White noise
 * falls with the area that normals see, a curved surface turns by more within a larger
 * radius: squares of both add up, which two levels give. At the last level that is
 * expected to be more than there is, 1.4 to 4 times, if neighbors share noise. */
template <typename Scatter>
float
curvatureShare(float first, float second, const Scatter& scatter)
{
  const auto square = [](double x) { return x * x; };
  const auto noise_left = [&](double level) { // of its square
    return square(
        square(normal_radius / (normal_radius + normal_radius_noise * level)));
  };
  const auto turn_grown = [&](double level) {
    return square((inad_radius + inad_radius_noise * level) / inad_radius);
  };
  const double left = noise_left(levels[1]), grown = turn_grown(levels[1]);
  const double turn = (square(second) - left * square(first)) / (grown - left);
  if (turn <= 0.0)
    return 0.0f;
  constexpr std::size_t last_level = levels.size() - 1;
  const double last = levels[last_level];
  const double noise = std::max(0.0, square(first) - turn);
  const double expected = std::sqrt(noise_left(last) * noise + turn_grown(last) * turn);
  constexpr double shared = 0.7, curved = 0.85; // of what is expected
  return static_cast<float>(std::clamp(
      (scatter(last_level) / expected - shared) / (curved - shared), 0.0, 1.0));
}

/** Points that are much closer than a sensor can tell apart lie on its steps: normals
 * agree on one step, differ as radii reach others, and agree again where radii hold
 * many of them. Those of a curved surface differ by more the larger the radii are. */
template <typename Scatter>
bool
isOnSteps(float first, const Scatter& scatter)
{
  constexpr std::size_t middle_level = 3;
  constexpr float falls = 0.8f; // on steps it fell to .45 to .65
  if (first > stable)
    return false;
  const float middle = scatter(middle_level);
  return middle > stable && scatter(levels.size() - 1) < falls * middle;
}

/** Whether normals differ even at the largest radii, by more than half as much again as
 * is stable. (Those of curved surfaces do, too, but by no less than at the first ones.)
 */
template <typename Scatter>
bool
isNeverStable(float first, const Scatter& scatter)
{
  constexpr float most = 1.5f * stable;
  constexpr float falls = 0.8f;
  const float last = scatter(levels.size() - 1);
  return last > most && last < falls * first;
}

/** The level at which normals are stable in white noise. If they never are, that at
 * which they differ least: larger radii reach other faces where creases are crowded. */
template <typename Scatter>
double
whiteLevel(double noise, float first, float second, const Scatter& scatter)
{
  if (first <= stable)
    return 0.0;
  double best = levels[0];
  float least = first, before = first, scattered = second;
  for (std::size_t i = 1; i < levels.size() && levels[i - 1] < noise; ++i) {
    scattered = i == 1 ? second : scatter(i);
    if (scattered <= stable)
      return std::min(noise, crossing(levels[i - 1], before, levels[i], scattered));
    if (scattered < least) {
      least = scattered;
      best = levels[i];
    }
    before = scattered;
  }
  return least == scattered ? noise : std::min(noise, best);
}

/** \param[in] scatter how far normals differ at a level, radians */
template <typename Scatter>
NoiseLevel
levelOfScatter(double noise, const Scatter& scatter)
{
  const float first = scatter(0);
  if (isOnSteps(first, scatter))
    return {max_noise, 1.0};
  if (noise == 0.0 || !(first > 0.0f))
    return {};
  const float before = scatter(1);
  float share = correlation(before / first);
  if (share > 0.0f)
    share *= 1.0f - curvatureShare(first, before, scatter);
  if (share == 1.0f)
    return {isNeverStable(first, scatter) ? max_noise : noise, 1.0};
  const double white = whiteLevel(noise, first, before, scatter);
  return {white + static_cast<double>(share) * (noise - white),
          static_cast<double>(share)};
}

/** The level at most at which normals are of one side of thin plates: what they differ
 * by is the other side's then, and neither noise nor steps. */
NoiseLevel
withinPlates(const NoiseLevel& level, double thickness)
{
  constexpr double within = 0.9; // of the thickness
  const double most = (within * thickness - normal_radius) / normal_radius_noise;
  return {std::clamp(level.level, 0.0, std::max(0.0, most)), 0.0};
}

/** \param[in] angles finite ones at a level \param[in] areOnSteps whether points are on
 * wide steps \param[in] thickness of plates, 0 for none; each is asked only if it
 * matters */
template <typename Angles, typename AreOnSteps, typename Thickness>
NoiseLevel
levelOf(double noise,
        const Angles& angles,
        const AreOnSteps& areOnSteps,
        const Thickness& thickness)
{
  const std::vector<float> first = angles(0);
  if (!first.empty() && median(first) <= stable && areOnSteps())
    return {max_noise, 1.0};
  std::array<std::optional<float>, levels.size()> known{flattestOf(first)};
  const NoiseLevel level = levelOfScatter(noise, [&](std::size_t at) {
    if (!known[at])
      known[at] = flattestOf(angles(at));
    return *known[at];
  });
  const double of_plates = level.level > 0.0 ? thickness() : 0.0;
  return of_plates > 0.0 ? withinPlates(level, of_plates) : level;
}

} // namespace

NoiseLevel
noiseLevelOf(const Neighborhoods& neighborhoods,
             const std::vector<float>& spacings,
             double noise,
             unsigned threads)
{
  const NormalScatter scatter(neighborhoods,
                              spacings,
                              somePoints(neighborhoods.input(), some),
                              most_radius,
                              threads);
  const XYZView& points = neighborhoods.input();
  const auto are_on_steps = [&] {
    return areOnWideSteps(stepAreas(somePoints(points, step_points),
                                    neighborhoods,
                                    spacings,
                                    static_cast<double>(medianSpacing(spacings)),
                                    threads));
  };
  return levelOf(
      noise,
      [&](std::size_t level) { return finiteOf(anglesAt(levels[level], scatter)); },
      are_on_steps,
      [&] { return plateThickness(neighborhoods, spacings, threads); });
}

double
shareUnknown(const Neighborhoods& neighborhoods,
             const std::vector<float>& spacings,
             std::size_t points,
             double noise_level,
             unsigned threads)
{
  const NormalScatter scatter(neighborhoods,
                              spacings,
                              somePoints(neighborhoods.input(), points),
                              most_radius,
                              threads);
  const std::vector<float> angles = anglesAt(noise_level, scatter);
  const auto unknown = std::count_if(
      angles.begin(), angles.end(), [](float angle) { return std::isnan(angle); });
  return angles.empty()
             ? 0.0
             : static_cast<double>(unknown) / static_cast<double>(angles.size());
}

pcl::Indices
levelPoints(const XYZView& points, std::uint64_t of_points)
{
  return somePoints(points, some, of_points);
}

NoiseMeasures
levelMeasures(const pcl::Indices& chosen,
              const Neighborhoods& neighborhoods,
              const std::vector<float>& spacings,
              const CloudNumbers& numbers,
              std::uint64_t places,
              unsigned threads)
{
  const auto some_of_them = [&](std::size_t count) {
    const pcl::Indices fewer = somePoints(neighborhoods.input(), count, places);
    pcl::Indices both;
    std::set_intersection(fewer.begin(),
                          fewer.end(),
                          chosen.begin(),
                          chosen.end(),
                          std::back_inserter(both));
    return both;
  };
  NoiseMeasures measures;
  const NormalScatter scatter(neighborhoods, spacings, chosen, most_radius, threads);
  for (std::size_t level = 0; level < levels.size(); ++level)
    measures.angles[level] = finiteOf(anglesAt(levels[level], scatter));
  measures.steps = stepAreas(some_of_them(step_points),
                             neighborhoods,
                             spacings,
                             static_cast<double>(numbers.spacing),
                             threads);
  measures.thicknesses = thicknessesAt(some_of_them(plate_points),
                                       neighborhoods,
                                       spacings,
                                       plate_spacings * numbers.spacing,
                                       threads);
  return measures;
}

double
noiseLevelReach(const CloudNumbers& numbers)
{
  constexpr double angles =
      most_radius + normal_radius + normal_radius_noise * levels.back();
  return std::max(angles * mostSpacing(numbers.distance),
                  stepReach(static_cast<double>(numbers.spacing)));
}

NoiseLevel
noiseLevelOf(double noise, const NoiseMeasures& measures)
{
  return levelOf(
      noise,
      [&](std::size_t level) { return measures.angles[level]; },
      [&] { return areOnWideSteps(measures.steps); },
      [&] { return plateThickness(measures.thicknesses); });
}

INADParameters
withNoiseOfCloud(const INADParameters& parameters,
                 const XYZView& cloud,
                 unsigned threads)
{
  if (parameters.normal_radius_noise == 0.0 && parameters.radius_noise == 0.0)
    return parameters;
  const Neighborhoods neighborhoods(cloud, threads);
  const std::vector<float> spacings =
      adaptiveRadii(AdaptiveRadius::DENSITY, 1.0, neighborhoods);
  const double noise = noiseOf(neighborhoods, spacings);
  return withNoise(parameters,
                   noiseLevelOf(neighborhoods, spacings, noise, threads).level);
}

} // namespace pcl::detail
