// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// PURPOSE

#pragma once

#include "geometry/point_grid.h"

#include <pcl/features/neighborhood_sweep.h>
#include "features/adaptive_inad.h"

#include <pcl/segmentation/shape_field.h>

#include <vector>

namespace pcl::segmentation {

/** \brief Where creases of clearly different directions meet. See doc/method.md. */
class CreaseCorners {
public:
  /** \param[in] edges kept, not copied */
  explicit CreaseCorners(const ShapeField& edges);

  /** \brief True if the creases around say different directions, and creases of
   * different directions lead there. \param[in] spacing of the points there, metres */
  bool areAt(const Eigen::Vector3f& center, float spacing) const;

private:
  using Directions = std::vector<Eigen::Vector3f>;

  Directions around(const Eigen::Vector3f& center, float reach) const;

  Directions leadingTo(const Eigen::Vector3f& center, float spacing) const;

  const std::vector<CreasePoint>& creases_;
  float fit_; ///< its radius in spacings
  PointGrid grid_;
};

/** \brief Where crease points are. Nothing is copied. */
inline XYZView
positionsOf(const std::vector<CreasePoint>& creases)
{
  return {creases.empty() ? nullptr : creases[0].position.data(),
          sizeof(CreasePoint) / sizeof(float),
          creases.size()};
}

} // namespace pcl::segmentation

namespace pcl::detail {

/** \brief What kind of edge each point is. \param[in] threshold as
 * ShapeDetection::setThreshold() \param[in] threads 0 for all cores */
std::vector<EdgeType>
edgeTypes(const ShapeField& edges, double threshold, unsigned threads);

} // namespace pcl::detail
