// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Fits two planes to a neighborhood, and compares their wedge with a smooth surface.

#pragma once

#include <Eigen/Core>

#include <optional>
#include <vector>

namespace pcl::segmentation {

/** \brief A neighborhood about its center in units of the spacing there. */
struct Patch {
  std::vector<Eigen::Vector3f> points;
  std::vector<Eigen::Vector3f> normals; ///< unit, of either sign
};

/** \brief The line where the two planes of a patch meet. */
struct CreaseFit {
  Eigen::Vector3f foot;       ///< the point nearest to the center
  Eigen::Vector3f direction;  ///< unit
  float angle = 0.0f;         ///< between the planes' normals, 0 to pi/2
  float turn = 0.0f;          ///< by which the surface turns there, 0 to pi
  float plane_squares = 0.0f; ///< sum of the squared distances from the nearer plane
  float wedge_squares = 0.0f; ///< the same from the wedge that they bound
};

/** \brief Fit two planes to a patch by turns: each point to the nearer plane, each
 * plane to its points (k-planes, after Bradley and Mangasarian, "k-Plane Clustering",
 * 2000). \return nothing where there are too few points, or planes that are parallel */
std::optional<CreaseFit> fitCrease(const Patch& patch);

/** \brief Root mean square distance of the points from the wedge, in spacings. */
float wedgeDeviation(const Patch& patch, const CreaseFit& crease);

/** \brief The same from the nearer plane: less where planes cross. */
float planeDeviation(const Patch& patch, const CreaseFit& crease);

/** \brief How much better the wedge explains the points than a quadric does, which has
 * as many parameters: the logarithm of the ratio of their likelihoods for normally
 * distributed distances of unknown size, n / 2 ln(squares of quadric / of wedge). */
float wedgeOverQuadric(const Patch& patch, const CreaseFit& crease);

} // namespace pcl::segmentation
