/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * Point Cloud Library (PCL) - www.pointclouds.org
 * Copyright (c) 2026, pcl_shape contributors
 *
 * All rights reserved
 */

#pragma once

#include <pcl/features/shape_histogram.h>

#include <cstdint>

namespace pcl {

/** \brief The bins of many pairs: numbers that a loop keeps in registers. */
class Binning {
public:
  explicit Binning(const ShapeHistogram& histogram)
  : mu_bins_(static_cast<double>(histogram.muBins()))
  , sigma_bins_(static_cast<double>(histogram.sigmaBins()))
  , mu_range_(histogram.muRange())
  , sigma_range_(histogram.sigmaRange())
  {}

  /** \brief Position of the pair's bin, or the number of bins beyond the ranges. */
  std::int32_t
  operator()(const INAD& inad) const
  {
    const double i = inad.mu * mu_bins_ / mu_range_;
    const double j = inad.sigma * sigma_bins_ / sigma_range_;
    const bool is_inside = i >= 0.0 && i < mu_bins_ && j >= 0.0 && j < sigma_bins_;
    const auto row = static_cast<std::int32_t>(is_inside ? i : mu_bins_);
    const auto column = static_cast<std::int32_t>(is_inside ? j : 0.0);
    return row * static_cast<std::int32_t>(sigma_bins_) + column;
  }

private:
  double mu_bins_, sigma_bins_, mu_range_, sigma_range_;
};

} // namespace pcl
