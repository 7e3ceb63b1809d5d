/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * Point Cloud Library (PCL) - www.pointclouds.org
 * Copyright (c) 2026, pcl_shape contributors
 *
 * All rights reserved
 */

#pragma once

#include <pcl/features/inad_point.h>
#include <pcl/pcl_shape_alignment.h>
#include <pcl/pcl_shape_exports.h>
#include <pcl/point_cloud.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace pcl {

/** \brief A two-dimensional histogram over (mu, sigma): the shape of a sample surface.
 *
 * Bin (i, j) holds mu in [i, i+1) * mu_range / mu_bins and sigma likewise. The
 * likelihood of a pair is the count of its bin over the largest count (Kumar, Behera
 * and Venkatesh, "Shape Back-Projection in 3D Scenes"). \ingroup features
 */
class PCL_SHAPE_EXPORTS ShapeHistogram {
public:
  static constexpr double default_range = 1.57079632679489661923; ///< pi/2, radians

  /** \brief An empty histogram.
   * \param[in] mu_bins, sigma_bins numbers of bins, 1 to 4096
   * \param[in] mu_range, sigma_range radians, the first angle beyond the last bin
   * \throws pcl::BadArgumentException outside of these
   */
  explicit ShapeHistogram(std::size_t mu_bins = 10,
                          std::size_t sigma_bins = 10,
                          double mu_range = default_range,
                          double sigma_range = default_range);

  /** \brief Count one pair. NaN is ignored; a pair beyond the ranges counts as
   * outside().
   */
  void add(const INAD& inad);

  /** \brief Count all pairs of a cloud.
   * \param[in] cloud its pairs count as with add() of one
   * \param[in] threads 0 for all cores */
  void add(const PointCloud<INAD>& cloud, unsigned threads = 1);

  /** \brief Add `count` to one bin. \throws pcl::BadArgumentException if it is out of
   * range */
  void add(std::size_t mu_bin, std::size_t sigma_bin, std::uint64_t count);

  /** \brief Add the counts of another histogram.
   * \throws pcl::BadArgumentException if it has other bins */
  void merge(const ShapeHistogram& other);

  /** \brief Count of the pair's bin over the largest count, in [0, 1]; 0 beyond the
   * ranges and in an empty histogram, NaN for NaN. */
  float likelihood(const INAD& inad) const;

  /** \brief The likelihood of each pair of a cloud: its back-projection.
   * \param[in] cloud pairs that are NaN give NaN
   * \param[in] threads 0 for all cores */
  std::vector<float> backProject(const PointCloud<INAD>& cloud,
                                 unsigned threads = 1) const;

  /** \brief Probability density of the pair, 1/rad^2; 0 beyond the ranges and in an
   * empty histogram, NaN for NaN. */
  double density(const INAD& inad) const;

  /** \brief Whether the other one has as many bins over the same ranges. */
  bool sameBins(const ShapeHistogram& other) const;

  /** \brief How many pairs are in a bin. \param[in] mu_bin, sigma_bin below muBins()
   * and sigmaBins(): not checked, undefined beyond */
  std::uint64_t
  count(std::size_t mu_bin, std::size_t sigma_bin) const
  {
    return counts_[mu_bin * sigma_bins_ + sigma_bin];
  }

  /** \brief The number of bins along mu. */
  std::size_t
  muBins() const
  {
    return mu_bins_;
  }

  /** \brief The number of bins along sigma. */
  std::size_t
  sigmaBins() const
  {
    return sigma_bins_;
  }

  /** \brief The first mu beyond the last bin, radians. */
  double
  muRange() const
  {
    return mu_range_;
  }

  /** \brief The first sigma beyond the last bin, radians. */
  double
  sigmaRange() const
  {
    return sigma_range_;
  }

  /** \brief Sum of the counts of all bins. */
  std::uint64_t
  total() const
  {
    return total_;
  }

  /** \brief Pairs that were beyond the ranges. */
  std::uint64_t
  outside() const
  {
    return outside_;
  }

  /** \brief The largest count. */
  std::uint64_t
  peak() const
  {
    return peak_;
  }

private:
  float likelihoodOfBin(std::size_t bin) const;

  void addRange(const PointCloud<INAD>& cloud, std::size_t begin, std::size_t end);

  std::size_t mu_bins_;
  std::size_t sigma_bins_;
  double mu_range_;
  double sigma_range_;
  std::uint64_t total_ = 0;
  std::uint64_t outside_ = 0;
  std::uint64_t peak_ = 0;
  std::vector<std::uint64_t> counts_;
};

} // namespace pcl
