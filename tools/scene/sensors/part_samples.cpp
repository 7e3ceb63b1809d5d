// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Throws points at the faces of a part and says what is true of each.

#include "scene/sensors/part_samples.h"

#include "scene/labels.h"
#include "scene/sensors/near_points.h"

#include <algorithm>
#include <memory>

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
  world.solids = {{Shape::Part, {}, {}, std::make_shared<Part>(part)}};
  return world;
}

} // namespace

PartTruth::PartTruth(const Part& part)
: part_(part)
, world_(worldOf(part))
, creases_(world_, Observer{})
, seams_(world_)
{}

void
PartTruth::add(const SurfacePoint& at, double spacing, PartSamples& samples) const
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

bool
PartTruth::isNearTightCurve(const Vec3& p, double spacing) const
{
  return std::any_of(part_.seams().begin(), part_.seams().end(), [&](const Seam& seam) {
    return seam.radius < tight_curve * spacing &&
           seam.line.distance(p) < no_edge_spacings * spacing;
  });
}

Surface
PartTruth::surfaceOf(const SurfacePoint& at,
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
