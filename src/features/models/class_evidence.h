// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Log densities of a shape model's classes, smoothed and interpolated.

#pragma once

#include <pcl/features/inad_parameters.h>

#include <cstddef>
#include <vector>

namespace pcl {

class ShapeModel;

namespace detail {

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

  /** \brief Those that the model was made with. */
  const INADParameters&
  parameters() const
  {
    return parameters_;
  }

  /** \brief The logarithm of each class's density, 1/rad^2; all NaN for NaN. */
  void logDensities(float mu, float sigma, float* values) const;

  /** \brief Of two classes ln(density of the first / of the second); NaN unknown.
   * \param[in] mu_sigma two for each point \param[in] threads 0 for all cores */
  std::vector<float> firstOverSecond(const std::vector<float>& mu_sigma,
                                     unsigned threads) const;

private:
  INADParameters parameters_;
  std::size_t mu_bins_;
  std::size_t sigma_bins_;
  double mu_bin_;    ///< radians
  double sigma_bin_; ///< radians
  std::vector<std::vector<float>> tables_;
};

} // namespace detail
} // namespace pcl
