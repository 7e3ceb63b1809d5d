// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Uneven density, smoothing, noise and outliers of dense matching.

#include "scene/sensors/photogrammetry.h"

#include "scene/sensors/near_points.h"

#include <array>
#include <cmath>

namespace pcl::scene {
namespace {

constexpr std::uint64_t matching_stream = 24;
constexpr double window = 2.5;         // spacings that matching averages over
constexpr double matching_noise = 0.3; // spacings
constexpr double outlier_share = 1.0 / 200.0;
constexpr double outlier_reach = 20.0;  // spacings
constexpr double thinnest = 1.0 / 30.0; // of the best density
constexpr double texture_length = 0.5;  // of the part: from one poor place to the next

/** \brief How good the texture is: a share of the best density. */
struct Texture {
  std::array<Vec3, 3> waves; /**< turns a meter */
  std::array<double, 3> phases;

  Texture(double size, Random& random)
  {
    for (std::size_t i = 0; i < waves.size(); ++i) {
      waves[i] = random.direction() * (1.0 / (texture_length * size));
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
  , averaged_(window * options.spacing)
  {
    for (const SurfacePoint& at : surface_) {
      averaged_.add(at.point);
      normals_.push_back(part.faces()[at.face]->normal(at.point));
    }
  }

  PartSamples
  run(const Part& part)
  {
    const PartTruth truth(part);
    PartSamples samples;
    for (std::size_t i = 0; i < surface_.size(); ++i) {
      const double density = texture_.density(surface_[i].point);
      if (!random_.chance(density))
        continue;
      truth.add(surface_[i], options_.spacing / std::sqrt(density), samples);
      append(matched(i, samples.scene), samples.scene.xyz);
    }
    samples.scene.width = static_cast<unsigned>(samples.scene.surface.size());
    samples.scene.height = 1;
    return samples;
  }

private:
  Vec3
  matched(std::size_t i, Scene& scene)
  {
    Vec3 p = smoothed(i);
    const double sigma = matching_noise * options_.spacing;
    p = p + Vec3{random_.normal(), random_.normal(), random_.normal()} * sigma;
    if (random_.chance(outlier_share)) {
      const double reach = outlier_reach * options_.spacing * random_.uniform();
      p = p + random_.direction() * reach;
      scene.surface.back() = SurfaceVoid;
      scene.edge.back() = EdgeVoid;
    }
    return p;
  }

  /** The mean of what is around a point, but not on the other side of a wall. */
  Vec3
  smoothed(std::size_t i) const
  {
    constexpr double same_side = -0.2; // cosine: a little more than a right angle
    Vec3 sum;
    double count = 0.0;
    averaged_.forEachNear(surface_[i].point, [&](std::size_t j) {
      if (dot(normals_[i], normals_[j]) > same_side) {
        sum = sum + surface_[j].point;
        count += 1.0;
      }
    });
    return sum * (1.0 / count); // it is a neighbor of itself
  }

  PartOptions options_;
  Random random_;
  Texture texture_;
  std::vector<SurfacePoint> surface_;
  NearPoints averaged_;
  std::vector<Vec3> normals_;
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
