// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// PURPOSE

#include "common/errors.h"
#include "common/parallel.h"

#include <pcl/features/shape_histogram.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>

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

namespace {

constexpr std::size_t most_bins = 4096;

void
checkBins(const char* name, std::size_t bins)
{
  if (bins < 1 || bins > most_bins) {
    raise<BadArgumentException>(
        textOf(name, " is ", bins, ": 1 to ", most_bins, " are allowed"));
  }
}

void
checkRange(const char* name, double range)
{
  if (!(range > 0.0) || !std::isfinite(range)) {
    raise<BadArgumentException>(
        textOf(name, " is ", range, " rad: it must be positive and finite"));
  }
}

bool
isNaN(const INAD& inad)
{
  return std::isnan(inad.mu) || std::isnan(inad.sigma);
}

} // namespace

ShapeHistogram::ShapeHistogram(std::size_t mu_bins,
                               std::size_t sigma_bins,
                               double mu_range,
                               double sigma_range)
: mu_bins_(mu_bins)
, sigma_bins_(sigma_bins)
, mu_range_(mu_range)
, sigma_range_(sigma_range)
{
  checkBins("mu_bins", mu_bins);
  checkBins("sigma_bins", sigma_bins);
  checkRange("mu_range", mu_range);
  checkRange("sigma_range", sigma_range);
  counts_.resize(mu_bins * sigma_bins);
}

std::size_t
ShapeHistogram::binOf(const INAD& inad) const
{
  return static_cast<std::size_t>(Binning(*this)(inad));
}

void
ShapeHistogram::add(const INAD& inad)
{
  if (isNaN(inad))
    return;
  const std::size_t bin = binOf(inad);
  if (bin == counts_.size()) {
    ++outside_;
    return;
  }
  peak_ = std::max(peak_, ++counts_[bin]);
  ++total_;
}

void
ShapeHistogram::add(const PointCloud<INAD>& cloud, unsigned threads)
{
  const std::size_t parts = kernels::threadCount(threads);
  if (parts == 1 || cloud.size() < parts * counts_.size()) {
    addRange(cloud, 0, cloud.size());
    return;
  }
  std::vector<ShapeHistogram> histograms(
      parts, ShapeHistogram(mu_bins_, sigma_bins_, mu_range_, sigma_range_));
  kernels::parallelFor(parts, threads, [&](std::size_t i) {
    histograms[i].addRange(
        cloud, i * cloud.size() / parts, (i + 1) * cloud.size() / parts);
  });
  for (const ShapeHistogram& histogram : histograms)
    merge(histogram);
}

void
ShapeHistogram::addRange(const PointCloud<INAD>& cloud,
                         std::size_t begin,
                         std::size_t end)
{
  // Local: a count that is written might be a member.
  std::uint64_t* const counts = counts_.data();
  const Binning binning(*this);
  const std::size_t beyond = counts_.size();
  std::uint64_t added = 0, peak = peak_;
  for (std::size_t i = begin; i < end; ++i) {
    const INAD& inad = cloud[i];
    const auto bin = static_cast<std::size_t>(binning(inad));
    if (bin == beyond) {
      outside_ += isNaN(inad) ? 0 : 1;
      continue;
    }
    peak = std::max(peak, ++counts[bin]);
    ++added;
  }
  total_ += added;
  peak_ = peak;
}

void
ShapeHistogram::add(std::size_t mu_bin, std::size_t sigma_bin, std::uint64_t count)
{
  if (mu_bin >= mu_bins_ || sigma_bin >= sigma_bins_) {
    raise<BadArgumentException>(textOf("bin (",
                                       mu_bin,
                                       ", ",
                                       sigma_bin,
                                       ") of a histogram of ",
                                       mu_bins_,
                                       " x ",
                                       sigma_bins_,
                                       " bins"));
  }
  if (count > std::numeric_limits<std::uint64_t>::max() - total_) {
    raise<BadArgumentException>(
        textOf("count ",
               count,
               " of bin (",
               mu_bin,
               ", ",
               sigma_bin,
               "): the sum of all counts must stay below 2^64"));
  }
  std::uint64_t& bin = counts_[mu_bin * sigma_bins_ + sigma_bin];
  bin += count;
  total_ += count;
  peak_ = std::max(peak_, bin);
}

void
ShapeHistogram::merge(const ShapeHistogram& other)
{
  if (!sameBins(other)) {
    raise<BadArgumentException>(textOf("histograms of ",
                                       mu_bins_,
                                       " x ",
                                       sigma_bins_,
                                       " and ",
                                       other.mu_bins_,
                                       " x ",
                                       other.sigma_bins_,
                                       " bins, or of other ranges, cannot be merged"));
  }
  for (std::size_t i = 0; i < mu_bins_; ++i)
    for (std::size_t j = 0; j < sigma_bins_; ++j)
      add(i, j, other.count(i, j));
  outside_ += other.outside_;
}

float
ShapeHistogram::likelihoodOf(std::size_t bin) const
{
  if (bin == counts_.size() || peak_ == 0)
    return 0.0f;
  return static_cast<float>(static_cast<double>(counts_[bin]) /
                            static_cast<double>(peak_));
}

float
ShapeHistogram::likelihood(const INAD& inad) const
{
  if (isNaN(inad))
    return std::numeric_limits<float>::quiet_NaN();
  return likelihoodOf(binOf(inad));
}

std::vector<float>
ShapeHistogram::backProject(const PointCloud<INAD>& cloud, unsigned threads) const
{
  const bool has_few_bins = counts_.size() < cloud.size();
  std::vector<float> of_bins(has_few_bins ? counts_.size() + 1 : 0);
  for (std::size_t bin = 0; bin < of_bins.size(); ++bin)
    of_bins[bin] = likelihoodOf(bin);
  std::vector<float> likelihoods(cloud.size());
  const Binning binning(*this);
  kernels::parallelForRanges(
      cloud.size(), threads, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
          const auto bin = static_cast<std::size_t>(binning(cloud[i]));
          const float known = has_few_bins ? of_bins[bin] : likelihoodOf(bin);
          likelihoods[i] =
              isNaN(cloud[i]) ? std::numeric_limits<float>::quiet_NaN() : known;
        }
      });
  return likelihoods;
}

double
ShapeHistogram::density(const INAD& inad) const
{
  if (isNaN(inad))
    return std::numeric_limits<double>::quiet_NaN();
  const std::size_t bin = binOf(inad);
  if (bin == counts_.size() || total_ == 0)
    return 0.0;
  const double area = mu_range_ * sigma_range_ / static_cast<double>(counts_.size());
  return static_cast<double>(counts_[bin]) / (static_cast<double>(total_) * area);
}

bool
ShapeHistogram::sameBins(const ShapeHistogram& other) const
{
  return mu_bins_ == other.mu_bins_ && sigma_bins_ == other.sigma_bins_ &&
         mu_range_ == other.mu_range_ && sigma_range_ == other.sigma_range_;
}

} // namespace pcl
