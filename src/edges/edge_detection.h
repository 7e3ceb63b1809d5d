// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Finds the creases of a cloud: candidates by INAD, votes for where two planes meet.

#pragma once

#include "edges/measured_cloud.h"

namespace pcl {

namespace segmentation {

/** \brief How far edge points are from their crease, in spacings. Without noise it is
 * two mean distances between points; with noise, the width that INAD can tell apart. */
inline float
edgeBand(double noise)
{
  return 1.02f + 4.0f * static_cast<float>(noise);
}

} // namespace segmentation

namespace detail {

class ShapeEvidence;

/** \brief Find the creases of a cloud: sets normals, edge likelihood and creases. See
 * doc/method.md for the steps.
 * \param[in] densities of two classes, the first of which is the edge */
void findEdges(const FieldInput& input,
               const MeasuredCloud& measured,
               const ShapeEvidence& densities,
               ShapeField& field);

/** \brief How much the fits of two planes count, and whether creases are followed: 0
 * where neighbors share noise, to 1. At the limit of the noise that is measured, it is
 * not known how much of a fit's deviation the noise explains. */
float whitenessOf(double correlation, double noise);

/** \brief How far from a crease the next level must have one, in the larger one of the
 * local spacing and the cloud's. */
float persistenceSpacings();

} // namespace detail
} // namespace pcl
