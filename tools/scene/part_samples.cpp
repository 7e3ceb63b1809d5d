// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Throws points at the faces of a part and says what is true of each.

#include "scene/part_samples.h"

#include "scene/creases.h"
#include "scene/labels.h"
#include "scene/random_part.h"

#include <algorithm>
#include <cmath>
#include <unordered_map>

namespace pcl::scene {
namespace {

constexpr std::uint64_t part_stream = 20, throwing_stream = 21, noise_stream = 22;
constexpr double edge_spacings = 1.5; // nearer points may be on either face
constexpr double no_edge_spacings = 3.0;
constexpr double seam_spacings = 4.0;
constexpr double tight_curve = 10.0;  // spacings: a fillet that may pass for an edge
constexpr double widest_curve = 46.0; // spacings: 5 degrees within 4 of them
constexpr double flat_radius = 1e6;   // spacings
constexpr double apart = 0.75;        // spacings between even points

struct Thrown {
  Vec3 point;
  std::size_t face;
};

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

  Thrown
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

std::vector<Thrown>
spread(const Part& part, const PartOptions& options)
{
  const auto wanted =
      static_cast<std::size_t>(part.area() / (options.spacing * options.spacing) + 0.5);
  // Even points fill all gaps that they leave after about ten times their number.
  const std::size_t attempts = options.spread == Spread::Even ? 60 * wanted : wanted;
  Thrower thrower(part, options.seed);
  Crowd crowd(apart * options.spacing);
  std::vector<Thrown> points;
  for (std::size_t i = 0; i < attempts && points.size() < wanted; ++i) {
    const Thrown thrown = thrower.next();
    if (options.spread == Spread::Random || crowd.add(thrown.point))
      points.push_back(thrown);
  }
  return points;
}

/** \brief Says what is true of points of a part. */
class Describer {
public:
  Describer(const Part& part, const PartOptions& options)
  : part_(part)
  , spacing_(options.spacing)
  , world_(worldOf(part))
  , creases_(world_, Observer{})
  , seams_(world_)
  {
    for (const Seam& seam : part.seams())
      if (seam.radius < tight_curve * spacing_)
        tight_seams_.push_back(seam.line);
  }

  void
  add(const Thrown& at, PartSamples& samples) const
  {
    const PartFace& face = *part_.faces()[at.face];
    const Vec3 normal = face.normal(at.point);
    const double crease = creases_.distance(at.point, crease_cap);
    const double radius = std::min(flat_radius, face.radius(at.point) / spacing_);
    Scene& scene = samples.scene;
    append(normal, scene.normals);
    scene.instance.push_back(1);
    scene.face.push_back(static_cast<std::uint32_t>(at.face));
    scene.crease_mm.push_back(static_cast<float>(1000.0 * crease));
    const bool may_be_edge = crease < no_edge_spacings * spacing_ ||
                             radius < tight_curve || isNearTightCurve(at.point);
    scene.edge.push_back(crease < edge_spacings * spacing_ ? EdgeCrease
                         : may_be_edge                     ? EdgeVoid
                                                           : EdgeNot);
    scene.surface.push_back(surface(at, normal, face.isFlat(), radius));
    samples.crease_s.push_back(static_cast<float>(crease / spacing_));
    samples.radius_s.push_back(static_cast<float>(radius));
    samples.thin_s.push_back(
        static_cast<float>(part_.thickness(at.point, normal) / spacing_));
  }

private:
  static World
  worldOf(const Part& part)
  {
    World world;
    world.table.center.x = 1e9; // there is none
    Solid solid;
    solid.shape = Shape::Part;
    solid.part = std::make_shared<Part>(part);
    world.solids = {solid};
    return world;
  }

  Surface
  surface(const Thrown& at, const Vec3& normal, bool is_flat, double radius) const
  {
    if (!is_flat)
      return radius > widest_curve ? SurfaceVoid : SurfaceCurved;
    const Sight sight{1, static_cast<int>(at.face), 0.0, at.point, normal};
    const bool goes_over = seams_.areNear(sight, seam_spacings * spacing_);
    return goes_over ? SurfaceVoid : SurfacePlanar;
  }

  bool
  isNearTightCurve(const Vec3& p) const
  {
    return std::any_of(
        tight_seams_.begin(), tight_seams_.end(), [&](const Curve& seam) {
          return seam.distance(p) < no_edge_spacings * spacing_;
        });
  }

  const Part& part_;
  double spacing_;
  World world_;
  Creases creases_;
  ThinPlaces seams_;
  std::vector<Curve> tight_seams_;
};

} // namespace

PartSamples
samplePart(const PartOptions& options)
{
  requireRange("size", options.size, 0.01, 1.0, " m");
  requireRange(
      "spacing", options.spacing, 0.001 * options.size, 0.1 * options.size, " m");
  Random random(options.seed, part_stream);
  return samplePart(randomPart(options.size, random), options);
}

PartSamples
samplePart(const Part& part, const PartOptions& options)
{
  requireRange("sigma", options.sigma, 0.0, 0.1, " m");
  const Describer describer(part, options);
  Random random(options.seed, noise_stream);
  PartSamples samples;
  for (const Thrown& at : spread(part, options)) {
    for (const double value : {at.point.x, at.point.y, at.point.z})
      samples.scene.xyz.push_back(
          static_cast<float>(value + options.sigma * random.normal()));
    describer.add(at, samples);
  }
  samples.scene.width = static_cast<unsigned>(samples.scene.surface.size());
  samples.scene.height = 1;
  return samples;
}

} // namespace pcl::scene
