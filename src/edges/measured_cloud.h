// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// What finding edges needs to know of a cloud, and of the voxel means that stand for
// it.

#pragma once

#include "features/adaptive_inad.h"
#include "features/noise/noise_level.h"

#include <pcl/segmentation/shape_field.h>

#include <memory>
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

/** \brief The voxel means of a cloud whose creases say which of the cloud's persist. */
struct NextLevel {
  double size = 0.0;    ///< of a voxel, meters
  CloudNumbers numbers; ///< that are expected of the means
};

/** \param[in] numbers of the cloud */
NextLevel nextLevel(const CloudNumbers& numbers);

/** \brief The next level of a cloud, and what is expected of it. */
struct MeansOfCloud {
  MeansOfCloud() = default;
  MeansOfCloud(MeansOfCloud&&) = default; // a copy's points would be the original's
  MeansOfCloud& operator=(MeansOfCloud&&) = default;

  std::vector<float> positions; ///< three each
  XYZView points;               ///< of them
  std::shared_ptr<const Neighborhoods> neighborhoods;
  MeasuredCloud measured;
  ShapeField field; ///< with spacings and noise
};
MeansOfCloud
meansOfCloud(const FieldInput& input, const MeasuredCloud& measured, double noise);

} // namespace pcl::detail
