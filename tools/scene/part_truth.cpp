// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Distances from creases and seams, and the classes that follow from them.

#include "scene/part_truth.h"

#include "scene/labels.h"

#include <algorithm>
#include <cmath>
#include <memory>

namespace pcl::scene {
namespace {

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

} // namespace pcl::scene
