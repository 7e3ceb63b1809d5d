/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * Point Cloud Library (PCL) - www.pointclouds.org
 * Copyright (c) 2026, pcl_shape contributors
 *
 * All rights reserved
 */

#pragma once

#include "surface_graph.h"

namespace pcl::segmentation {

/** \brief A member that stands for those around it. */
struct SurfaceNode {
  Eigen::Vector3f center;
  Eigen::Vector3f normal; ///< unit, of either sign
  float spacing = 0.0f;   ///< metres
  float on_step = 0.0f;   ///< 1 if the surface has a step there
};

/** \brief For each node the nodes that the surface runs to; none for a node that is not
 * inside a surface. */
using Links = std::vector<std::vector<std::uint32_t>>;

/** \brief Nodes on a surface, and which of them it runs between without a step or a
 * crease. */
class SurfaceNodes {
public:
  /** \param[in] members the points that nodes stand for */
  SurfaceNodes(const detail::InstanceInput& input,
               const PointGrid& points,
               const std::vector<char>& members);

  const std::vector<SurfaceNode>&
  nodes() const
  {
    return nodes_;
  }

  /** \brief Between nodes that are inside a surface, in both directions or one. */
  Links links() const;

  /** \brief visit(node, squared distance) for the nodes nearer than the radius. */
  template <typename Visit>
  void
  forEachWithin(const Eigen::Vector3f& center, float radius, const Visit& visit) const
  {
    grid_.forEachWithin(center, radius, visit);
  }

  /** \brief The label of the nearest node with one whose surface a point is on; -1 if
   * there is none. */
  std::int32_t labelAt(std::size_t point, const Labels& labels) const;

private:
  std::vector<SurfaceNode> fit(const PointGrid& points,
                               const std::vector<char>& members) const;

  /** Without a spacing if there are too few members. */
  SurfaceNode
  fitAt(std::size_t i, const PointGrid& points, const std::vector<char>& members) const;

  bool isOnStep(std::size_t i,
                const PointGrid& points,
                const std::vector<char>& members) const;

  XYZView positions() const;

  /** None unless the surface runs to enough of the nodes around. */
  std::vector<std::uint32_t> linksOf(std::size_t k) const;

  bool isSmooth(const SurfaceNode& a, const SurfaceNode& b) const;

  bool hasMiddle(const SurfaceNode& a, const SurfaceNode& b) const;

  const detail::InstanceInput& input_;
  float step_limit_;
  float offset_limit_;
  std::vector<SurfaceNode> nodes_;
  PointGrid grid_;
};

/** \brief A label for each node, -1 for those without links. */
Labels componentsOf(const Links& links);

} // namespace pcl::segmentation
