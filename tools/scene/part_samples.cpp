// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Throws points at the faces of a part and says what is true of each.

#include "scene/part_samples.h"

#include "scene/part_truth.h"
#include "scene/random_part.h"

#include <algorithm>
#include <cmath>
#include <unordered_map>

namespace pcl::scene {
namespace {

constexpr std::uint64_t throwing_stream = 21, noise_stream = 22;
constexpr double apart = 0.75; // spacings between even points

/** \brief Points that keep their distance. */
class Crowd {
public:
  explicit Crowd(double distance) : distance_(distance) {}

  /** \return false, and nothing is added, if another one is too near */
  bool
  add(const Vec3& p)
  {
    const auto cell = [&](double x) {
      return static_cast<std::int64_t>(std::floor(x / distance_));
    };
    const std::int64_t i = cell(p.x), j = cell(p.y), k = cell(p.z);
    for (std::int64_t x = i - 1; x <= i + 1; ++x)
      for (std::int64_t y = j - 1; y <= j + 1; ++y)
        for (std::int64_t z = k - 1; z <= k + 1; ++z)
          if (isNear(p, key(x, y, z)))
            return false;
    cells_[key(i, j, k)].push_back(p);
    return true;
  }

private:
  static std::int64_t
  key(std::int64_t x, std::int64_t y, std::int64_t z)
  {
    constexpr std::int64_t cells_a_side = 1 << 20; // parts have at most 20,000
    return (x * cells_a_side + y) * cells_a_side + z;
  }

  bool
  isNear(const Vec3& p, std::int64_t cell) const
  {
    const auto found = cells_.find(cell);
    return found != cells_.end() &&
           std::any_of(found->second.begin(), found->second.end(), [&](const Vec3& q) {
             return squaredNorm(p - q) < distance_ * distance_;
           });
  }

  double distance_;
  std::unordered_map<std::int64_t, std::vector<Vec3>> cells_;
};

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

std::vector<SurfacePoint>
spreadPoints(const Part& part, const PartOptions& options)
{
  const auto wanted =
      static_cast<std::size_t>(part.area() / (options.spacing * options.spacing) + 0.5);
  // Even points fill all gaps that they leave after about ten times their number.
  const std::size_t attempts = options.spread == Spread::Even ? 60 * wanted : wanted;
  Thrower thrower(part, options.seed);
  Crowd crowd(apart * options.spacing);
  std::vector<SurfacePoint> points;
  for (std::size_t i = 0; i < attempts && points.size() < wanted; ++i) {
    const SurfacePoint thrown = thrower.next();
    if (options.spread == Spread::Random || crowd.add(thrown.point))
      points.push_back(thrown);
  }
  return points;
}

void
checkPartOptions(const PartOptions& options)
{
  requireRange("size", options.size, 0.01, 1.0, " m");
  requireRange(
      "spacing", options.spacing, 0.001 * options.size, 0.1 * options.size, " m");
  requireRange("sigma", options.sigma, 0.0, 0.1, " m");
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
