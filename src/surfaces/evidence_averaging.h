// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// PURPOSE

#pragma once

#include "geometry/point_grid.h"

#include "features/adaptive_inad.h"

#include <pcl/segmentation/shape_field.h>

#include <cstddef>
#include <vector>

namespace pcl::segmentation {

/** \brief Average the evidence of each class over neighborhoods, without crossing
 * edges.
 *
 * A few points stand for all: of the known ones in each cell of space the one nearest
 * to its middle. The averages of averages there reach further than one neighborhood
 * would, around corners of the surface but not across its edges. \param[in] evidence
 * logarithms of densities, point by point; NaN stays NaN */
std::vector<float> averageEvidence(const detail::FieldInput& input,
                                   const ShapeField& edges,
                                   std::vector<float> evidence,
                                   std::size_t classes);

/** \brief A few points that stand for all: of the known ones in each cell of space the
 * one nearest to its middle. */
class EvidenceNodes {
public:
  /** \param[in] is_known for each point */
  EvidenceNodes(const detail::FieldInput& input,
                const ShapeField& edges,
                const std::vector<bool>& is_known);

  std::size_t
  size() const
  {
    return points_.size();
  }

  /** \brief The point that a node is. */
  std::size_t
  point(std::size_t node) const
  {
    return points_[node];
  }

  /** \brief use(first, weights) for ranges of nodes among which all are that a point
   * hears of; of the others the weight is 0. */
  template <typename Use>
  void
  forEachRange(std::size_t point, std::vector<float>& weights, const Use& use) const
  {
    const Eigen::Vector3f position = positionOf(input_.points, point);
    const float radius = reachOf(point);
    grid_.forEachRangeWithin(
        position, radius, [&](std::uint32_t begin, std::uint32_t end) {
          weights.resize(end - begin);
          weigh(begin, point, radius * radius, weights);
          use(begin, weights);
        });
  }

private:
  float reachOf(std::size_t point) const;

  void weigh(std::size_t first,
             std::size_t point,
             float squared_radius,
             std::vector<float>& weights) const;

  const detail::FieldInput& input_;
  const ShapeField& edges_;
  std::vector<std::size_t> points_;
  PointGrid grid_;
  std::vector<float> positions_[3], normals_[3]; ///< x, y, z of each node
  std::vector<float> weights_; ///< of each node, whatever its direction
};

} // namespace pcl::segmentation
