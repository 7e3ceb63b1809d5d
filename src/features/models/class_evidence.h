// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Log densities of a shape model's classes, smoothed and interpolated.

#pragma once

#include <pcl/features/shape_model.h>

#include <vector>

namespace pcl::detail {

/** \brief Logarithms of the smoothed densities of a model's classes, ready for look-up.
 *
 * Counts are smoothed by a Gaussian over ShapeModel::smoothing() bins, divided by their
 * sum and the area of a bin, and the model's floor is added. Between the bins' middles
 * the logarithms are interpolated; beyond them the nearest is taken, so that a pair out
 * of range counts as the most extreme one in it. */
class ShapeEvidence {
public:
  explicit ShapeEvidence(const ShapeModel& model);

  std::size_t
  classes() const
  {
    return tables_.size();
  }

  /** \brief The logarithm of each class's density, 1/rad^2; all NaN for NaN. */
  void logDensities(float mu, float sigma, float* values) const;

private:
  std::size_t mu_bins_;
  std::size_t sigma_bins_;
  double mu_bin_;    ///< radians
  double sigma_bin_; ///< radians
  std::vector<std::vector<float>> tables_;
};

} // namespace pcl::detail
