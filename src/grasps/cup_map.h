// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// PURPOSE

#pragma once

#include "grasps/quadric_fit.h"

namespace pcl::segmentation {

/** \brief Distances to what a cup must not touch, metres, at most two cup radii
 * and the margin. */
struct Clearance {
  float border = 0.0f, edge = 0.0f, obstacle = 0.0f;

  float least(float margin) const;
};

/** \brief What is around a place on a surface, seen along the approach: a square image
 * of where the surface goes on, where edges are and where something is in the way. */
class CupMap {
public:
  CupMap(const TargetSurface& surface, const SurfaceFit& fit, float radius);

  /** \brief Beside the cup that must be free as well, metres. */
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
  void mark(const TargetSurface& surface, const SurfaceFit& fit);

  /** True if the place is on the image. */
  bool cellOf(float x, float y, std::size_t& cell) const;

  float
  center(int column) const
  {
    return static_cast<float>(column - half_) * cell_;
  }

  void measure();

  float radius_, margin_, cell_, hole_, band_;
  int half_, side_;
  std::vector<char> is_surface_, is_edge_, is_obstacle_;
  std::vector<float> border_, edge_, obstacle_; ///< distances, metres
};

} // namespace pcl::segmentation
