// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Votes of points near creases for where these run, and the places that votes agree on.

#pragma once

#include "features/adaptive_inad.h"
#include "geometry/point_grid.h"

#include <pcl/segmentation/shape_field.h>

#include <Eigen/Core>

#include <vector>

namespace pcl::segmentation {

/** \brief What one candidate says: a crease runs there. */
struct Vote {
  Eigen::Vector3f position;  ///< the point of the crease nearest to the candidate
  Eigen::Vector3f direction; ///< of the crease, unit
  float angle = 0.0f;        ///< by which the surface turns, 0 to pi
  float evidence = 0.0f;     ///< of the candidate
  float spacing = 0.0f;      ///< meters
  /** ln(likelihood of two planes / of a smooth surface), -2 to 10; 0 if not asked. */
  float fit = 0.0f;
};

/** \brief A place that votes agree on: their mean, and the sum of their evidence. */
struct Agreement {
  CreasePoint point;
  float evidence = 0.0f;
  float fit = 0.0f; ///< the mean of the votes'
};

/** \brief The radius in spacings within which a candidate fits two planes. */
float fitSpacings(double noise);

/** \brief The radius of the neighborhood whose points it fits, and how far its vote may
 * be. */
float patchSpacings(double noise, double noise_level);

/** \brief The radius in spacings within which votes agree. */
float agreementSpacings();

/** \brief The votes of all points whose evidence speaks for an edge, and near which two
 * planes meet at an angle.
 * \param[in] edges with normals, spacings and noise
 * \param[in] evidence ln(density(edge) / density(rest)) at each point, NaN unknown
 * \param[in] whiteness how sure it is that noise is of each point for itself, 0 to 1:
 * so much counts what the fit of two planes says beside INAD. Steps that neighbors
 * share look like wedges. */
std::vector<Vote> collectVotes(const detail::FieldInput& input,
                               const ShapeField& edges,
                               const std::vector<float>& evidence,
                               float whiteness,
                               const PointGrid& grid);

/** \brief What the votes around each vote agree on.
 * \param[in] spacing the median of the cloud's, meters */
std::vector<Agreement>
countVotes(const std::vector<Vote>& votes, float spacing, unsigned threads);

} // namespace pcl::segmentation
