// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// What a suction cup would touch at a place: borders, edges and obstacles around it.

#pragma once

#include "grasps/quadric_fit.h"
#include "grasps/surface_gaps.h"

#include <algorithm>
#include <optional>
#include <vector>

namespace pcl::segmentation {

/** \brief Distances to what a cup must not touch, meters, at most two cup radii
 * and the margin. */
struct Clearance {
  float border = 0.0f, edge = 0.0f, obstacle = 0.0f;

  /** \param[in] margin beside the cup that must be free of borders and obstacles */
  float
  smallest(float margin) const
  {
    return std::min({border - margin, edge, obstacle - margin});
  }
};

/** \brief What is around a place on a surface, seen along the approach: a square image
 * of where the surface goes on, where edges are and where something is in the way. */
class CupMap {
public:
  CupMap(const TargetSurface& surface, const SurfaceFit& fit, float radius);

  /** \brief Beside the cup that must be free as well, meters. */
  float
  margin() const
  {
    return margin_;
  }

  Clearance at(float x, float y) const;

  /** \brief The place within one radius with the greatest clearance; of several the
   * nearest. The middle, if none is clearer by more than a cell. */
  Eigen::Vector2f clearestPlace() const;

  /** \brief The share of a disc in the middle where the surface goes on. */
  float covered(float radius) const;

private:
  struct Marks {
    std::vector<char> surface, edge, obstacle;
  };

  /** The target's points on the surface under the cup and around it. */
  std::vector<Eigen::Vector2f> pointsOf(const TargetSurface& surface,
                                        const SurfaceFit& fit) const;

  /** What is narrower than the image tells, exactly. */
  void addGaps(const std::vector<Gap>& gaps);

  Marks marksOf(const TargetSurface& surface, const SurfaceFit& fit) const;

  /** The cell of a place, or nothing if it is not on the image. */
  std::optional<std::size_t> cellOf(float x, float y) const;

  float
  center(int column) const
  {
    return static_cast<float>(column - half_) * cell_;
  }

  float radius_, margin_, cell_;
  int half_, side_;                             ///< cells
  std::vector<float> border_, edge_, obstacle_; ///< distances, meters
};

} // namespace pcl::segmentation
