// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// The plane or quadric under a suction cup.

#pragma once

#include "grasps/target_surface.h"

#include <array>
#include <optional>

namespace pcl::segmentation {

/** \brief A plane or a quadric over a tangent plane: height = c0 + c1 x + c2 y + c3 x^2
 * + c4 x y + c5 y^2 in the frame of its origin, meters. */
struct SurfaceFit {
  Eigen::Vector3f origin = Eigen::Vector3f::Zero();
  Eigen::Matrix3f axes = Eigen::Matrix3f::Identity(); ///< columns x, y, outward normal
  std::array<float, 6> coefficients{};
  float spacing = 0.0f;  ///< of the points, mean, meters
  float variance = 0.0f; ///< of the points' heights about the fit, square meters
  bool is_plane = true;

  float
  height(float x, float y) const
  {
    const auto& c = coefficients;
    return c[0] + c[1] * x + c[2] * y + c[3] * x * x + c[4] * x * y + c[5] * y * y;
  }

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
  Eigen::Vector3f
  normal() const
  {
    return (axes * Eigen::Vector3f(-coefficients[1], -coefficients[2], 1.0f))
        .normalized();
  }

  /** \brief By how much the rim of a disc of this radius is out of a plane, or the
   * surface rises or falls inside of it, whichever is more. */
  float sag(float radius) const;
};

/** \brief What a point may be off a surface. */
struct Tolerance {
  float residual; ///< r.m.s. of many points, meters
  float band;     ///< of one point, meters
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
