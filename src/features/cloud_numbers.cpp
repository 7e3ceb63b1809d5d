// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// What a cloud's parts measure of it: distances, noise, normals.

#include "common/finite.h"
#include "features/local_spacing.h"
#include "features/noise_level.h"

#include <pcl/features/cloud_numbers.h>
#include <pcl/features/impl/neighborhoods.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace pcl {
namespace {

using namespace detail;

pcl::Indices
allOf(const XYZView& points)
{
  pcl::Indices all(points.size);
  std::iota(all.begin(), all.end(), 0);
  return all;
}

/** Some points, and at least those that are within a distance of them. */
class Surroundings {
public:
  Surroundings(const XYZView& points, const pcl::Indices& chosen_points, double reach)
  {
    // Wider than the reach: what is rounded is not missed.
    constexpr double wider = 1.01;
    const auto cell = static_cast<float>(wider * reach);
    const std::vector<Cell> cells = cellsAround(points, chosen_points, cell);
    std::size_t next = 0;
    for (std::size_t i = 0; !cells.empty() && i < points.size; ++i) {
      const bool is_chosen = next < chosen_points.size() &&
                             static_cast<std::size_t>(chosen_points[next]) == i;
      next += is_chosen ? 1 : 0;
      if (is_chosen)
        chosen.push_back(static_cast<pcl::index_t>(positions_.size() / 3));
      if (std::binary_search(cells.begin(), cells.end(), cellOf(points[i], cell)))
        positions_.insert(positions_.end(), points[i], points[i] + 3);
    }
  }

  XYZView
  view() const
  {
    return {positions_.data(), 3, positions_.size() / 3};
  }

  pcl::Indices chosen; ///< of the points in view()

private:
  using Cell = std::array<float, 3>;

  static Cell
  cellOf(const float* p, float cell)
  {
    return {std::floor(p[0] / cell), std::floor(p[1] / cell), std::floor(p[2] / cell)};
  }

  static std::vector<Cell>
  cellsAround(const XYZView& points, const pcl::Indices& chosen, float cell)
  {
    std::vector<Cell> cells;
    for (const pcl::index_t i : chosen) {
      const Cell c = cellOf(points[static_cast<std::size_t>(i)], cell);
      for (const float x : {-1.0f, 0.0f, 1.0f})
        for (const float y : {-1.0f, 0.0f, 1.0f})
          for (const float z : {-1.0f, 0.0f, 1.0f})
            cells.push_back({c[0] + x, c[1] + y, c[2] + z});
    }
    std::sort(cells.begin(), cells.end());
    cells.erase(std::unique(cells.begin(), cells.end()), cells.end());
    return cells;
  }

  std::vector<float> positions_;
};

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
}

void
setNoise(const NoiseMeasures& of_all_parts, CloudNumbers& numbers)
{
  numbers.noise = of_all_parts.variations.empty()
                      ? 0.0
                      : noiseOfVariations(of_all_parts.variations);
  const NoiseLevel level = noiseLevelOf(numbers.noise, of_all_parts.angles);
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
{}

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
  std::vector<float> distances = distancesToTwelfth(
      Neighborhoods(places_, places_, measured, threads_), measured.size());
  for (float& d : distances)
    if (!(d <= reach))
      d = unknown;
  return distances;
}

NoiseMeasures
PartOfCloud::measureNoise(const CloudNumbers& numbers, std::uint64_t places) const
{
  const auto around = [&](const pcl::Indices& chosen, double spacings) {
    pcl::Indices measured;
    for (const pcl::index_t i : chosen)
      if (is_measured_[static_cast<std::size_t>(i)])
        measured.push_back(i);
    return Surroundings(places_,
                        measured,
                        spacingReach(numbers.distance) +
                            spacings * mostSpacing(numbers.distance));
  };
  NoiseMeasures measures;
  const Surroundings flat = around(noisePoints(places_, places), variationReach());
  if (!flat.chosen.empty()) {
    const pcl::Indices all = allOf(flat.view());
    const Neighborhoods neighborhoods(flat.view(), flat.view(), all, threads_);
    measures.variations = variationsAt(
        flat.chosen, neighborhoods, localSpacings(neighborhoods, all.size(), numbers));
  }
  const Surroundings wide = around(anglePoints(places_, places), angleReach());
  if (!wide.chosen.empty()) {
    const pcl::Indices all = allOf(wide.view());
    const Neighborhoods neighborhoods(wide.view(), wide.view(), all, threads_);
    measures.angles =
        normalAngles(wide.chosen,
                     neighborhoods,
                     localSpacings(neighborhoods, all.size(), numbers),
                     segmentation::PointGrid(wide.view(), 2.0f * numbers.spacing));
  }
  return measures;
}

std::vector<float>
PartOfCloud::normals(const CloudNumbers& numbers, double radius) const
{
  const pcl::Indices all = allOf(places_);
  const Neighborhoods neighborhoods(places_, places_, all, threads_);
  std::vector<float> radii = localSpacings(neighborhoods, all.size(), numbers);
  using Limits = std::numeric_limits<float>;
  for (float& r : radii)
    r = std::clamp(r * static_cast<float>(radius), Limits::min(), Limits::max());
  std::vector<float> normals(4 * places_.size);
  neighborhoods.computeNormals(
      NeighborhoodSize::ofRadii(radii.data()), normals.data(), normals.data() + 3, 4);
  return normals;
}

} // namespace pcl
