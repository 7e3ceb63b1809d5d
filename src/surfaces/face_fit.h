// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// How a window of a face bends: a quadric that outliers do not move.

#pragma once

#include "surfaces/face_pyramid.h"

#include <Eigen/Cholesky>

#include <cstdint>
#include <optional>
#include <vector>

namespace pcl::segmentation {

/** \brief How the nodes of a window lie about a quadric, in the direction in which it
 * bulges most. Lengths in meters, angles in radians. */
struct FaceFit {
  float half_width = 0.0f;    ///< of the window in that direction
  float bulge = 0.0f;         ///< of the quadric out of a plane there: its sagitta
  float bulge_error = 0.0f;   ///< standard error, of noise that nodes do not share
  float residual = 0.0f;      ///< of the nodes, r.m.s.
  float freedom = 0.0f;       ///< degrees of freedom of the residual, at least 1
  float inliers = 0.0f;       ///< share of nodes that count: all of up to twelve
  float center_offset = 0.0f; ///< of the window's first node from the quadric
  float center_cosine = 0.0f; ///< of the angle between their normals

  /** \brief By which the normal turns across the window. */
  float
  turn() const
  {
    return 4.0f * bulge / half_width;
  }
};

/** \brief The value that so many of a few values are less than, as std::nth_element
 * finds it: that waits for a branch at each value, this counts whole vectors of few.
 * \param[in] values not negative, not NaN; more than the rank */
float ranked(const std::vector<float>& values, std::size_t rank);

/** \brief Fits quadrics over the tangent planes of windows' first nodes, by least
 * squares with biweights. */
class FaceFitter {
public:
  /** \param[in] level of the windows, which must outlive this */
  explicit FaceFitter(const FaceLevel& level) : level_(level) {}

  /** \return nothing where nodes are too few, or nearly on a curve */
  std::optional<FaceFit> fit(const std::vector<std::uint32_t>& window);

  /** \brief Those nodes of the window of the last fit that are on its quadric. */
  std::vector<std::uint32_t> nodesOn(const std::vector<std::uint32_t>& window) const;

private:
  void place(const std::vector<std::uint32_t>& window);
  void setShares(const std::vector<std::uint32_t>& window);
  bool solve();
  void setWeights();
  Eigen::Matrix2d spread() const;
  FaceFit describe() const;

  const FaceLevel& level_;
  /** Of each node, in the frame of the first one and in cells. */
  std::vector<float> x_, y_, z_, weights_, residuals_;
  std::vector<float> shares_; ///< of each, what it weighs at most
  std::vector<float> sizes_;  ///< of the residuals
  Eigen::LDLT<Eigen::Matrix<double, 6, 6>> equations_;
  Eigen::Matrix<double, 6, 1> solution_;
};

} // namespace pcl::segmentation
