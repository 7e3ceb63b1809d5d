// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// A smooth piece of surface as planes, cylinders, spheres and cones see it.

#pragma once

#include "instances/pieces/smooth_pieces.h"
#include "instances/primitives/primitives.h"

#include <cstdint>
#include <map>
#include <optional>
#include <vector>

namespace pcl::segmentation {

using NodeIndices = std::vector<std::uint32_t>; ///< ascending

constexpr std::size_t min_part_nodes = 12; // fewer are no surface: chance, or a rim

/** \brief Nodes on a plane, cylinder or sphere. */
struct SurfacePart {
  ShapePrimitive surface;
  NodeIndices nodes;
};

inline bool
isCurved(const SurfacePart& part)
{
  return part.surface.type != PrimitiveType::Plane;
}

/** \brief A smooth piece of surface as primitives see it: about one of its nodes, in
 * units of their mean spacing, so that no result depends on what else there is. */
struct SurfacePiece {
  /** \param[in] min_noise of the piece, in spacings; more if its nodes say so, as depth
   * cameras see far pieces */
  SurfacePiece(std::vector<SurfaceNode> nodes, float min_noise);

  NodeIndices allNodes() const;

  /** \brief Whether a primitive describes all of some nodes, the larger errors near the
   * limbs of curved ones included. */
  bool isOne(const NodeIndices& some) const;

  /** \brief Root mean square distance from the cylinder, sphere or cone nearest to all
   * of some nodes, in spacings. */
  float residualAsOne(const NodeIndices& some) const;

  /** \brief Root mean square distance of nodes from a surface, in spacings. */
  float residualOf(const ShapePrimitive& surface, const NodeIndices& some) const;

  /** \brief Parts of the piece, one primitive after the other, the largest first
   * (sequential RANSAC); none if it is nothing that a few primitives describe. */
  std::vector<SurfacePart> parts() const;

  /** \brief Fit the part's primitive to its nodes anew. */
  void refit(SurfacePart& part) const;

  /** \brief In spacings; infinite where the normals disagree. */
  float distanceTo(const ShapePrimitive& surface, std::uint32_t node) const;

  template <typename Visit>
  void
  forEachAround(std::uint32_t node, const Visit& visit) const
  {
    if (begins_.empty())
      findAround();
    for (std::uint32_t k = begins_[node]; k < begins_[node + 1]; ++k)
      visit(around_[k]);
  }

  static constexpr float around_spacings = 3.0f; // two cells of nodes

  const std::vector<SurfaceNode> nodes;
  const float noise;     ///< in spacings, as all below
  const float tolerance; ///< how far a node may be off the surface that it is on
  /** What noise makes of that: nodes are means of some 25 points, but noise may be
   * correlated. */
  const float node_noise;
  const float gap_limit;      ///< between two parts of one surface where they meet
  const std::size_t min_size; ///< of a part that is a surface of its own, in nodes

private:
  void findAround() const;
  SurfacePart largestPart(const NodeIndices& some) const;
  /** `sample` is taken of the nodes when a fit first needs it. */
  ShapePrimitive fitted(const NodeIndices& some,
                        PrimitiveType type,
                        std::optional<PrimitiveSample>& sample) const;

  /** Those to all nodes: asked for to see whether the piece is one, and for its first
   * part. A piece is looked at by one thread. */
  mutable std::map<PrimitiveType, ShapePrimitive> fits_of_all_;
  /** The nodes around each, one after the other, and where each one's begin: found once
   * they are asked for, as few pieces need them, but these many times. */
  mutable std::vector<std::uint32_t> around_, begins_;
};

} // namespace pcl::segmentation
