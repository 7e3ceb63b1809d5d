// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Finds the creases of a cloud: candidates by INAD, votes for where two planes meet.

#pragma once

#include "features/adaptive_inad.h"
#include "features/noise/noise_level.h"
#include "geometry/point_grid.h"

#include <pcl/features/shape_model.h>
#include <pcl/segmentation/shape_field.h>

#include <vector>

namespace pcl::detail {

/** \brief What finding edges needs to know of a cloud. */
struct MeasuredCloud {
  float spacing; ///< the median, meters
  NoiseLevel noise;
  std::size_t places; ///< that are finite
  const std::vector<float>* distances =
      nullptr; ///< of the points to their 12th neighbors, if these are known
};

/** \brief Measure a cloud: sets the spacings, noise and noise level of a field. */
MeasuredCloud measureCloud(const FieldInput& input, ShapeField& field);

/** \brief The same with spacings that are known. */
MeasuredCloud
measureCloud(const FieldInput& input, std::vector<float> spacings, ShapeField& field);

/** \brief Sets the noise level among the numbers of a cloud. */
void setNoiseLevel(const NoiseLevel& noise, CloudNumbers& numbers);

/** \brief Find the creases of a cloud: sets normals, edge likelihood and creases. See
 * doc/method.md for the steps.
 * \param[in] model two classes, the first of which is the edge */
void findEdges(const FieldInput& input,
               const MeasuredCloud& measured,
               const ShapeModel& model,
               ShapeField& field);

/** \brief The voxel means of a cloud whose creases say which of the cloud's persist. */
struct NextLevel {
  double size = 0.0;    ///< of a voxel, meters
  CloudNumbers numbers; ///< that are expected of the means
};

/** \param[in] numbers of the cloud */
NextLevel nextLevel(const CloudNumbers& numbers);

/** \brief How much the fits of two planes count, and whether creases are followed: 0
 * where neighbors share noise, to 1. At the limit of the noise that is measured, it is
 * not known how much of a fit's deviation the noise explains. */
float whitenessOf(double correlation, double noise);

/** \brief How far from a crease the next level must have one, in the larger one of the
 * local spacing and the cloud's. */
float persistenceSpacings();

} // namespace pcl::detail
