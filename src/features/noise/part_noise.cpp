// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// The noise of a part of a cloud, however its spacings are found.

#include "features/noise/part_noise.h"

#include "features/noise/noise_level.h"
#include "features/spacing/local_spacing.h"

#include <stdexcept>

namespace pcl::detail {
namespace {

pcl::Indices
measuredOf(const pcl::Indices& chosen, const std::vector<bool>& is_measured)
{
  pcl::Indices measured;
  for (const pcl::index_t i : chosen)
    if (is_measured[static_cast<std::size_t>(i)])
      measured.push_back(i);
  return measured;
}

} // namespace

void
requireOneEach(std::size_t places, std::size_t count, const std::string& what)
{
  if (count != places)
    throw std::invalid_argument(std::to_string(count) + " " + what + " are given for " +
                                std::to_string(places) +
                                " places: one for each is needed");
}

NoiseMeasures
noiseOfPart(const XYZView& places,
            const std::vector<bool>& is_measured,
            const SpacingsOfPart& spacings,
            const CloudNumbers& numbers,
            std::uint64_t places_of_cloud,
            unsigned threads)
{
  const auto near = [&](const pcl::Indices& chosen, double reach, int cells) {
    return PointsNear(places,
                      measuredOf(chosen, is_measured),
                      spacings.reach + reach,
                      cells,
                      threads);
  };
  NoiseMeasures measures;
  // Few points with many around each, then many with few.
  const PointsNear wide =
      near(levelPoints(places, places_of_cloud), noiseLevelReach(numbers), 3);
  if (!wide.some().empty()) {
    const Neighborhoods neighborhoods(wide.view(), threads);
    measures = levelMeasures(wide.some(),
                             neighborhoods,
                             spacings.of(wide, neighborhoods),
                             numbers,
                             places_of_cloud,
                             threads);
  }
  const PointsNear flat = near(noisePoints(places, places_of_cloud),
                               variationReach() * mostSpacing(numbers.distance),
                               1);
  if (!flat.some().empty()) {
    const Neighborhoods neighborhoods(flat.view(), threads);
    measures.variations =
        variationsAt(flat.some(), neighborhoods, spacings.of(flat, neighborhoods));
  }
  return measures;
}

} // namespace pcl::detail
