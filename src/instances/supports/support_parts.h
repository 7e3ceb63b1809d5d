// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// The flat parts of a cloud that may be supports.

#pragma once

#include "geometry/point_grid.h"
#include "geometry/principal_axes.h"
#include "instances/pieces/smooth_pieces.h"

#include <cstdint>
#include <vector>

namespace pcl::segmentation {

constexpr float max_ripple = 2.0f; // of a depth camera, in spacings

/** \brief A plane with ripple. */
struct SupportPlane {
  Plane<float> plane;  ///< the normal is towards the viewpoint
  float offset = 0.0f; ///< how far its points are off, at most, in spacings
};

/** \brief Before the plane (above 0) or behind it, in spacings of the node. */
float heightOf(const SurfaceNode& node, const Plane<float>& plane);

bool isOn(const SurfaceNode& node, const SupportPlane& support);

/** \brief How much surface a node stands for. \param[in] unit the median spacing */
double areaOf(const SurfaceNode& node, float unit);

/** \brief A connected part of a plane, and what is on the plane behind a gap of up to a
 * quarter of its width. */
struct SupportPart {
  SupportPlane support; ///< fitted to it
  std::vector<SurfaceNode> nodes;
  double area = 0.0;   ///< square meters
  double points = 0.0; ///< how many the nodes stand for: its size in the image
};

/** \brief Square meters, and points. */
struct PartSize {
  double area = 0.0, points = 0.0;
};

/** \brief The largest area and the most points that any of the parts has. */
PartSize largestOf(const std::vector<SupportPart>& parts);

/** \brief Whether a part has this share of the largest area, or of the most points: a
 * near table is small beside a far floor. */
bool isLarge(const SupportPart& part, const PartSize& largest, double share);

/** \brief Where a part is: some of its nodes, spread over it. */
std::vector<SurfaceNode> placesOf(const std::vector<SurfaceNode>& nodes);

inline bool
isNear(const Eigen::Vector3f& position, const PointGrid& places, float reach)
{
  const auto any = [](std::uint32_t, const Eigen::Vector3f&) { return true; };
  return places.anyWithin(position, reach, any);
}

/** \brief The flat parts one after another, each the largest of the plane that most of
 * the remaining points are on. Planes whose largest part is small are passed over.
 * \param[in] min_offset of the planes \param[in] unit the median spacing, meters */
std::vector<SupportPart>
supportParts(const std::vector<SurfaceNode>& nodes, float min_offset, float unit);

} // namespace pcl::segmentation
