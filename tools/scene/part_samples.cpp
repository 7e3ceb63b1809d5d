// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Throws points at the faces of a part and says what is true of each.

#include "scene/part_samples.h"

#include "scene/near_points.h"
#include "scene/part_truth.h"
#include "scene/random_part.h"

#include <algorithm>

namespace pcl::scene {
namespace {

constexpr std::uint64_t throwing_stream = 21, noise_stream = 22;
constexpr double apart = 0.75; // spacings between even points

/** \brief Throws points at all faces, each piece of surface equally often. */
class Thrower {
public:
  Thrower(const Part& part, std::uint64_t seed)
  : part_(part)
  , random_(seed, throwing_stream)
  {
    for (const auto& face : part.faces())
      sums_.push_back((sums_.empty() ? 0.0 : sums_.back()) + face->area());
  }

  SurfacePoint
  next()
  {
    const double at = random_.uniform() * sums_.back();
    const auto face = std::upper_bound(sums_.begin(), sums_.end() - 1, at);
    const auto index = static_cast<std::size_t>(face - sums_.begin());
    return {part_.faces()[index]->randomPoint(random_), index};
  }

private:
  const Part& part_;
  Random random_;
  std::vector<double> sums_;
};

} // namespace

void
checkPartOptions(const PartOptions& options)
{
  requireRange("size", options.size, 0.01, 1.0, " m");
  requireRange(
      "spacing", options.spacing, 0.001 * options.size, 0.1 * options.size, " m");
  requireRange("sigma", options.sigma, 0.0, 0.1, " m");
}

std::vector<SurfacePoint>
spreadPoints(const Part& part, const PartOptions& options)
{
  const auto wanted =
      static_cast<std::size_t>(part.area() / (options.spacing * options.spacing) + 0.5);
  // Even points fill all gaps that they leave after about ten times their number.
  const std::size_t attempts = options.spread == Spread::Even ? 60 * wanted : wanted;
  Thrower thrower(part, options.seed);
  NearPoints kept(apart * options.spacing);
  std::vector<SurfacePoint> points;
  for (std::size_t i = 0; i < attempts && points.size() < wanted; ++i) {
    const SurfacePoint thrown = thrower.next();
    if (options.spread == Spread::Even) {
      if (kept.hasNear(thrown.point))
        continue;
      kept.add(thrown.point);
    }
    points.push_back(thrown);
  }
  return points;
}

PartSamples
samplePart(const PartOptions& options)
{
  checkPartOptions(options);
  Random random(options.seed, part_stream);
  return samplePart(randomPart(options.size, random), options);
}

PartSamples
samplePart(const Part& part, const PartOptions& options)
{
  const PartTruth truth(part);
  Random random(options.seed, noise_stream);
  PartSamples samples;
  for (const SurfacePoint& at : spreadPoints(part, options)) {
    for (const double value : {at.point.x, at.point.y, at.point.z})
      samples.scene.xyz.push_back(
          static_cast<float>(value + options.sigma * random.normal()));
    truth.add(at, options.spacing, samples);
  }
  samples.scene.width = static_cast<unsigned>(samples.scene.surface.size());
  samples.scene.height = 1;
  return samples;
}

} // namespace pcl::scene
