// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// PURPOSE

#pragma once

#include "grasps/target_surface.h"

#include <array>
#include <optional>

namespace pcl::segmentation {

/** \brief A plane or a quadric over a tangent plane: height = c0 + c1 x + c2 y + c3 x^2
 * + c4 x y + c5 y^2 in the frame of its origin, metres. */
struct SurfaceFit {
  Eigen::Vector3f origin = Eigen::Vector3f::Zero();
  Eigen::Matrix3f axes = Eigen::Matrix3f::Identity(); ///< columns x, y, outward normal
  std::array<float, 6> coefficients{};
  float spacing = 0.0f;  ///< of the points, mean, metres
  float variance = 0.0f; ///< of the points' heights about the fit, square metres
  bool is_plane = true;

  float height(float x, float y) const;

  /** \brief Of the point, from the frame's origin. */
  Eigen::Vector3f
  toLocal(const Eigen::Vector3f& point) const
  {
    return axes.transpose() * (point - origin);
  }

  /** \brief The point of the surface over a place of the tangent plane. */
  Eigen::Vector3f
  at(float x, float y) const
  {
    return origin + axes * Eigen::Vector3f(x, y, height(x, y));
  }

  /** \brief Outward, of the surface at the frame's origin; by symmetry the mean over a
   * disc around it. */
  Eigen::Vector3f normal() const;

  /** \brief By how much the rim of a disc of this radius is out of a plane, or the
   * surface rises or falls inside of it, whichever is more. */
  float sag(float radius) const;
};

/** \brief What a point may be off a surface. */
struct Tolerance {
  float residual = 0.0f; ///< r.m.s. of many points, metres
  float band = 0.0f;     ///< of one point, metres
};

/** \param[in] noise in spacings \param[in] radius of the cup */
Tolerance toleranceOf(float noise, float spacing, float radius);

/** \brief Fit the surface under a cup. The origin of the result is on the fit.
 * \return nothing where there are too few points */
std::optional<SurfaceFit> fitSurface(const TargetSurface& surface,
                                     const Eigen::Vector3f& center,
                                     const Eigen::Vector3f& normal,
                                     float radius);

} // namespace pcl::segmentation
