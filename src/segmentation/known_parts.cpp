// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// The noise and the edges of a part of a cloud whose neighbors were found before.

#include "common/gathered.h"
#include "edges/edge_detection.h"
#include "features/models/class_evidence.h"
#include "features/noise/part_noise.h"
#include "features/spacing/local_spacing.h"

#include <pcl/features/shape_model.h>
#include <pcl/segmentation/known_parts.h>
#include <pcl/features/impl/neighborhoods.hpp>

#include <cmath>
#include <limits>

namespace pcl {
namespace {

using namespace detail;

void
requireOneEach(const KnownPart& part)
{
  detail::requireOneEach(
      part.places.size, part.is_measured.size(), "values of is_measured");
  detail::requireOneEach(part.places.size, part.distances.size(), "distances");
}

std::vector<float>
spacingsOf(std::vector<float> distances, const CloudNumbers& numbers)
{
  for (float& d : distances)
    d = spacingOf(std::isinf(d) ? std::numeric_limits<float>::max() : d,
                  numbers.distance);
  return distances;
}

} // namespace

NoiseMeasures
measureNoise(const KnownPart& part,
             const CloudNumbers& numbers,
             std::uint64_t places,
             unsigned threads)
{
  requireOneEach(part);
  const auto known = [&](const PointsNear& near, const Neighborhoods& /*among*/) {
    return spacingsOf(gathered(part.distances, near.indices()), numbers);
  };
  constexpr double reach = 0.0;
  return noiseOfPart(
      part.places, part.is_measured, {reach, known}, numbers, places, threads);
}

ShapeField
edgesOf(const KnownPart& part,
        const shared_ptr<const void>& cloud,
        const CloudNumbers& numbers,
        unsigned threads)
{
  requireOneEach(part);
  const Neighborhoods neighborhoods(part.places, threads);
  const FieldInput input{neighborhoods, part.places, {}, threads, false, &numbers};
  ShapeField field;
  field.cloud = cloud;
  field.points = part.places;
  const MeasuredCloud measured =
      measureCloud(input, spacingsOf(part.distances, numbers), field);
  findEdges(input, measured, ShapeEvidence(ShapeModel::defaultEdges()), field);
  return field;
}

} // namespace pcl
