// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Uneven density, smoothing, noise and outliers of dense matching.

#include "scene/photogrammetry.h"

#include "scene/part_truth.h"
#include "scene/random_part.h"

#include <algorithm>
#include <cmath>
#include <unordered_map>

namespace pcl::scene {
namespace {

constexpr std::uint64_t matching_stream = 24;
constexpr double window = 2.5;         // spacings that matching averages over
constexpr double matching_noise = 0.3; // spacings
constexpr double outlier_share = 1.0 / 200.0;
constexpr double outlier_reach = 20.0;  // spacings
constexpr double thinnest = 1.0 / 30.0; // of the best density
constexpr double texture_length = 0.5;  // of the part: from one poor place to the next

/** \brief Points to find those near a place. */
class Neighborhood {
public:
  Neighborhood(const std::vector<Vec3>& points, double radius)
  : points_(points)
  , radius_(radius)
  {
    for (std::size_t i = 0; i < points.size(); ++i)
      cells_[key(cell(points[i].x), cell(points[i].y), cell(points[i].z))].push_back(i);
  }

  template <class Function>
  void
  forEach(const Vec3& p, const Function& function) const
  {
    const std::int64_t i = cell(p.x), j = cell(p.y), k = cell(p.z);
    for (std::int64_t x = i - 1; x <= i + 1; ++x)
      for (std::int64_t y = j - 1; y <= j + 1; ++y)
        for (std::int64_t z = k - 1; z <= k + 1; ++z) {
          const auto found = cells_.find(key(x, y, z));
          if (found == cells_.end())
            continue;
          for (const std::size_t index : found->second)
            if (squaredNorm(points_[index] - p) < radius_ * radius_)
              function(index);
        }
  }

private:
  std::int64_t
  cell(double x) const
  {
    return static_cast<std::int64_t>(std::floor(x / radius_));
  }

  static std::int64_t
  key(std::int64_t x, std::int64_t y, std::int64_t z)
  {
    constexpr std::int64_t cells_a_side = 1 << 20; // parts have fewer
    return (x * cells_a_side + y) * cells_a_side + z;
  }

  const std::vector<Vec3>& points_;
  double radius_;
  std::unordered_map<std::int64_t, std::vector<std::size_t>> cells_;
};

Vec3
randomDirection(Random& random)
{
  const double z = random.uniform(-1.0, 1.0), level = std::sqrt(1.0 - z * z);
  const UnitVector heading = fromTurns(random.uniform());
  return {level * heading.cosine, level * heading.sine, z};
}

/** \brief How good the texture is: a share of the best density. */
struct Texture {
  std::array<Vec3, 3> waves; /**< turns a meter */
  std::array<double, 3> phases;

  Texture(double size, Random& random)
  {
    for (std::size_t i = 0; i < waves.size(); ++i) {
      waves[i] = randomDirection(random) * (1.0 / (texture_length * size));
      phases[i] = random.uniform();
    }
  }

  double
  density(const Vec3& p) const
  {
    double poor = 1.0; // 0 to 1
    for (std::size_t i = 0; i < waves.size(); ++i)
      poor *= 0.5 + 0.5 * fromTurns(dot(p, waves[i]) + phases[i]).cosine;
    return 1.0 / (1.0 + (1.0 / thinnest - 1.0) * poor);
  }
};

/** \brief Matches points of a surface. */
class Matcher {
public:
  Matcher(const Part& part, const PartOptions& options)
  : options_(options)
  , random_(options.seed, matching_stream)
  , texture_(options.size, random_)
  , surface_(spreadPoints(part, options))
  {
    for (const SurfacePoint& at : surface_) {
      points_.push_back(at.point);
      normals_.push_back(part.faces()[at.face]->normal(at.point));
    }
  }

  PartSamples
  run(const Part& part)
  {
    const PartTruth truth(part);
    const Neighborhood neighborhood(points_, window * options_.spacing);
    PartSamples samples;
    for (std::size_t i = 0; i < surface_.size(); ++i) {
      const double density = texture_.density(points_[i]);
      if (!random_.chance(density))
        continue;
      truth.add(surface_[i], options_.spacing / std::sqrt(density), samples);
      append(matched(i, neighborhood, samples.scene), samples.scene.xyz);
    }
    samples.scene.width = static_cast<unsigned>(samples.scene.surface.size());
    samples.scene.height = 1;
    return samples;
  }

private:
  Vec3
  matched(std::size_t i, const Neighborhood& neighborhood, Scene& scene)
  {
    Vec3 p = smoothed(i, neighborhood);
    const double sigma = matching_noise * options_.spacing;
    p = p + Vec3{random_.normal(), random_.normal(), random_.normal()} * sigma;
    if (random_.chance(outlier_share)) {
      const double reach = outlier_reach * options_.spacing * random_.uniform();
      p = p + randomDirection(random_) * reach;
      scene.surface.back() = SurfaceVoid;
      scene.edge.back() = EdgeVoid;
    }
    return p;
  }

  /** The mean of what is around a point, but not on the other side of a wall. */
  Vec3
  smoothed(std::size_t i, const Neighborhood& neighborhood) const
  {
    constexpr double same_side = -0.2; // cosine: a little more than a right angle
    Vec3 sum;
    double count = 0.0;
    neighborhood.forEach(points_[i], [&](std::size_t j) {
      if (dot(normals_[i], normals_[j]) > same_side) {
        sum = sum + points_[j];
        count += 1.0;
      }
    });
    return sum * (1.0 / count); // it is a neighbor of itself
  }

  PartOptions options_;
  Random random_;
  Texture texture_;
  std::vector<SurfacePoint> surface_;
  std::vector<Vec3> points_, normals_;
};

} // namespace

PartSamples
reconstructPart(const PartOptions& options)
{
  checkPartOptions(options);
  PartOptions all = options;
  all.spread = Spread::Random;
  Random random(options.seed, part_stream);
  const Part part = randomPart(options.size, random);
  return Matcher(part, all).run(part);
}

} // namespace pcl::scene
