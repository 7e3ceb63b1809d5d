// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// PURPOSE

#pragma once

#include "geometry/primitives.h"
#include "instances/smooth_pieces.h"

namespace pcl::segmentation {

using NodeIndices = std::vector<std::uint32_t>; ///< ascending

/** \brief Nodes on a plane, cylinder or sphere. */
struct SurfacePart {
  ShapePrimitive surface;
  NodeIndices nodes;
};

/** \brief A smooth piece of surface as primitives see it: about one of its nodes, in
 * units of their mean spacing, so that no result depends on what else there is. */
class SurfacePiece {
public:
  /** \param[in] least_noise of the piece, in spacings; more if its nodes say so, as
   * depth cameras see far pieces */
  SurfacePiece(std::vector<SurfaceNode> nodes, float least_noise);

  std::uint32_t
  size() const
  {
    return static_cast<std::uint32_t>(nodes_.size());
  }

  /** \brief All nodes. */
  NodeIndices nodes() const;

  const SurfaceNode&
  operator[](std::uint32_t node) const
  {
    return nodes_[node];
  }

  /** \brief The least size of a part that is a surface of its own, in nodes. */
  std::size_t leastSize() const;

  /** \brief How far a node may be off the surface that it is on, in spacings. */
  float
  tolerance() const
  {
    return tolerance_;
  }

  /** \brief What noise makes of the distance of nodes from the surface that they are
   * on: they are means of some 25 points, but noise may be correlated. */
  float
  nodeNoise() const
  {
    return node_noise_;
  }

  /** \brief How far two parts of one surface may be apart where they meet. */
  float
  gapLimit() const
  {
    return gap_limit_;
  }

  /** \brief Whether a primitive describes all of some nodes, the larger errors near the
   * limbs of curved ones included. */
  bool isOne(const NodeIndices& nodes) const;

  /** \brief Root mean square distance from the cylinder or sphere nearest to all of
   * some nodes, in spacings. */
  float residualAsOne(const NodeIndices& nodes) const;

  /** \brief Root mean square distance of nodes from a surface, in spacings. */
  float residualOf(const ShapePrimitive& surface, const NodeIndices& nodes) const;

  /** \brief Parts of the piece, the largest first (sequential RANSAC). */
  std::vector<SurfacePart> parts() const;

  /** \brief Fit the part's primitive to its nodes anew. */
  void refit(SurfacePart& part) const;

  /** \brief In spacings; infinite where the normals disagree. */
  float distanceTo(const ShapePrimitive& surface, std::uint32_t node) const;

  template <typename Visit>
  void
  forEachAround(std::uint32_t node, const Visit& visit) const
  {
    grid_.forEachWithin(nodes_[node].center,
                        around_spacings * nodes_[node].spacing,
                        [&](std::uint32_t other, float) { visit(other); });
  }

private:
  static constexpr float around_spacings = 3.0f; // two cells of nodes
  // doc/instances.md has the reason of each number.
  static constexpr std::size_t least_nodes = 12;
  static constexpr double all_but_noise = 0.95; // of the nodes

  SurfacePart largestPart(const NodeIndices& nodes) const;
  PrimitiveSample sampleOf(const NodeIndices& nodes) const;
  NodeIndices inliersOf(const ShapePrimitive& surface, const NodeIndices& nodes) const;
  NodeIndices mostConnected(const NodeIndices& nodes) const;

  std::vector<SurfaceNode> nodes_;
  PointGrid grid_;
  float tolerance_;
  float gap_limit_;
  float node_noise_;
};

inline bool
isCurved(const SurfacePart& part)
{
  return part.surface.type != PrimitiveType::Plane;
}

} // namespace pcl::segmentation
