// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Points all over a machined part, sampled or reconstructed, with the truth about each.

#include "scene/part_samples.h"

#include "scene/creases.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <unordered_map>

namespace pcl::scene {
namespace {

/** Points in cubes as long as the radius: those within it are in a cube or
 * beside it. */
class NearPoints {
public:
  explicit NearPoints(double radius) : radius_(radius) {}

  void
  add(const Vec3& p)
  {
    cubes_[key(cubeAt(p.x), cubeAt(p.y), cubeAt(p.z))].push_back(points_.size());
    points_.push_back(p);
  }

  bool
  hasNear(const Vec3& p) const
  {
    return findNear(p, [](std::size_t) { return true; });
  }

  /** Calls with the number of each point that is near, the first added being 0.
   */
  template <class Function>
  void
  forEachNear(const Vec3& p, const Function& function) const
  {
    findNear(p, [&](std::size_t point) {
      function(point);
      return false;
    });
  }

private:
  /** Calls until the answer is true; returns whether it was. */
  template <class Predicate>
  bool
  findNear(const Vec3& p, const Predicate& is_wanted) const
  {
    const std::int64_t i = cubeAt(p.x), j = cubeAt(p.y), k = cubeAt(p.z);
    for (std::int64_t x = i - 1; x <= i + 1; ++x)
      for (std::int64_t y = j - 1; y <= j + 1; ++y)
        for (std::int64_t z = k - 1; z <= k + 1; ++z) {
          const auto cube = cubes_.find(key(x, y, z));
          if (cube == cubes_.end())
            continue;
          for (const std::size_t point : cube->second)
            if (squaredNorm(points_[point] - p) < radius_ * radius_ && is_wanted(point))
              return true;
        }
    return false;
  }

  std::int64_t
  cubeAt(double x) const
  {
    return static_cast<std::int64_t>(std::floor(x / radius_));
  }

  static std::int64_t
  key(std::int64_t x, std::int64_t y, std::int64_t z)
  {
    constexpr std::int64_t cubes_a_side = 1 << 20; // parts have at most 20,000
    return (x * cubes_a_side + y) * cubes_a_side + z;
  }

  double radius_;
  std::vector<Vec3> points_;
  std::unordered_map<std::int64_t, std::vector<std::size_t>> cubes_;
};

/** A point of a part, exact. */
struct SurfacePoint {
  Vec3 point;
  std::size_t face; /**< its index in the part */
};

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

void
checkPartOptions(const PartOptions& options)
{
  requireRange("size", options.size, 0.01, 1.0, " m");
  requireRange(
      "spacing", options.spacing, 0.001 * options.size, 0.1 * options.size, " m");
  requireRange("sigma", options.sigma, 0.0, 0.1, " m");
}

constexpr double edge_spacings = 1.5; // nearer points may be on either face
constexpr double no_edge_spacings = 3.0;
constexpr double seam_spacings = 4.0;
constexpr double tight_curve = 10.0;  // spacings: a fillet that may pass for an edge
constexpr double widest_curve = 46.0; // spacings: 5 degrees within 4 of them
constexpr double flat_radius = 1e6;   // spacings

World
worldOf(const Part& part)
{
  World world;
  Solid solid;
  solid.shape = Shape::Part;
  solid.part = std::make_shared<Part>(part);
  world.solids = {solid};
  return world;
}

/** Says what PartSamples says of points of a part. */
class PartTruth {
public:
  explicit PartTruth(const Part& part)
  : part_(part)
  , world_(worldOf(part))
  , creases_(world_, Observer{})
  , seams_(world_)
  {}

  /** Add all but the coordinates of a point; `spacing` is that of the points around it.
   */
  void
  add(const SurfacePoint& at, double spacing, PartSamples& samples) const
  {
    const PartFace& face = *part_.faces()[at.face];
    const Vec3 normal = face.normal(at.point);
    const double crease = creases_.distance(at.point, crease_cap);
    const double radius_s = std::min(flat_radius, face.radius(at.point) / spacing);
    const bool may_be_edge = crease < no_edge_spacings * spacing ||
                             radius_s < tight_curve ||
                             isNearTightCurve(at.point, spacing);
    Scene& scene = samples.scene;
    append(normal, scene.normals);
    scene.instance.push_back(1);
    scene.face.push_back(static_cast<std::uint32_t>(at.face));
    scene.crease_mm.push_back(static_cast<float>(1000.0 * crease));
    scene.edge.push_back(crease < edge_spacings * spacing ? EdgeCrease
                         : may_be_edge                    ? EdgeVoid
                                                          : EdgeNot);
    scene.surface.push_back(surfaceOf(at, normal, radius_s, spacing));
    samples.crease_s.push_back(static_cast<float>(crease / spacing));
    samples.radius_s.push_back(static_cast<float>(radius_s));
    samples.thin_s.push_back(
        static_cast<float>(part_.thickness(at.point, normal) / spacing));
  }

private:
  bool
  isNearTightCurve(const Vec3& p, double spacing) const
  {
    return std::any_of(
        part_.seams().begin(), part_.seams().end(), [&](const Seam& seam) {
          return seam.radius < tight_curve * spacing &&
                 seam.line.distance(p) < no_edge_spacings * spacing;
        });
  }

  Surface
  surfaceOf(const SurfacePoint& at,
            const Vec3& normal,
            double radius_s,
            double spacing) const
  {
    if (!part_.faces()[at.face]->isFlat())
      return radius_s > widest_curve ? SurfaceVoid : SurfaceCurved;
    const Sight sight{1, static_cast<int>(at.face), 0.0, at.point, normal};
    const bool goes_over = seams_.areNear(sight, seam_spacings * spacing);
    return goes_over ? SurfaceVoid : SurfacePlanar;
  }

  const Part& part_;
  World world_;
  Creases creases_;
  ThinPlaces seams_;
};

constexpr std::uint64_t matching_stream = 24;
constexpr double window = 2.5;         // spacings that matching averages over
constexpr double matching_noise = 0.3; // spacings
constexpr double outlier_share = 1.0 / 200.0;
constexpr double outlier_reach = 20.0;  // spacings
constexpr double thinnest = 1.0 / 30.0; // of the best density
constexpr double texture_length = 0.5;  // of the part: from one poor place to the next

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
      p = p + randomDirection(random_) * reach;
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
