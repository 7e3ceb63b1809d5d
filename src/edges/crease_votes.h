// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// PURPOSE

#pragma once

#include "geometry/point_grid.h"

#include "features/adaptive_inad.h"

#include <pcl/segmentation/shape_field.h>

#include <Eigen/Core>

#include <optional>
#include <vector>

namespace pcl::segmentation {

/** \brief Where two planes that a neighborhood lies on meet. */
struct CreaseFit {
  Eigen::Vector3f foot;      ///< the point of the line that is nearest to the origin
  Eigen::Vector3f direction; ///< of the line, unit
  float angle = 0.0f;        ///< between the planes' normals, 0 to pi/2
  float turn = 0.0f;         ///< by which the surface turns at the line, 0 to pi
};

/** \brief Fit two planes to points by turns: each point to the nearer plane, each plane
 * to its points (k-planes, after Bradley and Mangasarian, "k-Plane Clustering", 2000).
 * It starts from the two normals that differ most.
 * \param[in] points relative to the point in question
 * \param[in] normals theirs, unit, of either sign
 * \return nothing if there are not five points on each plane, or the planes are
 * parallel */
std::optional<CreaseFit> fitCrease(const std::vector<Eigen::Vector3f>& points,
                                   const std::vector<Eigen::Vector3f>& normals);

/** What one candidate says: a crease runs there. */
struct Vote {
  Eigen::Vector3f foot;
  Eigen::Vector3f direction;
  float angle = 0.0f;
  float evidence = 0.0f;
  float spacing = 0.0f;
};

/** A place that votes agree on: their mean, and the sum of their evidence. */
struct Agreement {
  CreasePoint point;
  float evidence = 0.0f;
};

/** \brief The radius in spacings within which a candidate fits two planes. */
float fitSpacings(double noise);

/** \brief The votes of all points whose evidence speaks for an edge, and near which two
 * planes meet at an angle.
 * \param[in] edges with normals, spacings and noise
 * \param[in] evidence ln(density(edge) / density(rest)) at each point, NaN unknown */
std::vector<Vote> collectVotes(const detail::FieldInput& input,
                               const ShapeField& edges,
                               const std::vector<float>& evidence,
                               const PointGrid& grid);

/** \brief What the votes around each vote agree on.
 * \param[in] spacing the median of the cloud's, metres */
std::vector<Agreement>
countVotes(const std::vector<Vote>& votes, float spacing, unsigned threads);

} // namespace pcl::segmentation
