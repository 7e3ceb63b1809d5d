// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Two-dimensional histograms over (mu, sigma), counted and back-projected.

#include "common/number_text.h"
#include "common/parallel.h"

#include <pcl/exceptions.h>
#include <pcl/features/shape_histogram.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>
#include <utility>

namespace pcl {
namespace {

using detail::numberText;

constexpr std::size_t max_bins = 4096; // 16 million bins, 128 MB

/** The bins of many pairs: numbers that a loop keeps in registers. */
class Binning {
public:
  explicit Binning(const ShapeHistogram& histogram)
  : mu_bins_(static_cast<double>(histogram.muBins()))
  , sigma_bins_(static_cast<double>(histogram.sigmaBins()))
  , mu_range_(histogram.muRange())
  , sigma_range_(histogram.sigmaRange())
  {}

  /** Position of the pair's bin, or the number of bins beyond the ranges. */
  std::size_t
  operator()(const INAD& inad) const
  {
    const double i = inad.mu * mu_bins_ / mu_range_;
    const double j = inad.sigma * sigma_bins_ / sigma_range_;
    const bool is_inside = i >= 0.0 && i < mu_bins_ && j >= 0.0 && j < sigma_bins_;
    const auto row = static_cast<std::int32_t>(is_inside ? i : mu_bins_);
    const auto column = static_cast<std::int32_t>(is_inside ? j : 0.0);
    return static_cast<std::size_t>(row * static_cast<std::int32_t>(sigma_bins_) +
                                    column);
  }

private:
  double mu_bins_, sigma_bins_, mu_range_, sigma_range_;
};

std::string
sizeText(const ShapeHistogram& histogram)
{
  return std::to_string(histogram.muBins()) + " x " +
         std::to_string(histogram.sigmaBins()) + " bins";
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
  for (const auto& [name, bins] :
       {std::pair("mu_bins", mu_bins), std::pair("sigma_bins", sigma_bins)})
    if (bins < 1 || bins > max_bins)
      throw BadArgumentException(std::string(name) + " is " + std::to_string(bins) +
                                 ": it must be 1 to " + std::to_string(max_bins));
  for (const auto& [name, range] :
       {std::pair("mu_range", mu_range), std::pair("sigma_range", sigma_range)})
    if (!(range > 0.0) || !std::isfinite(range))
      throw BadArgumentException(std::string(name) + " is " + numberText(range) +
                                 " rad: it must be positive and finite");
  counts_.resize(mu_bins * sigma_bins);
}

void
ShapeHistogram::add(const INAD& inad)
{
  if (isNaN(inad))
    return;
  const std::size_t bin = Binning(*this)(inad);
  if (bin == counts_.size())
    ++outside_;
  else
    add(bin / sigma_bins_, bin % sigma_bins_, 1);
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
    const std::size_t bin = binning(inad);
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
  const auto name = [&] {
    return "bin (" + std::to_string(mu_bin) + ", " + std::to_string(sigma_bin) + ")";
  };
  if (mu_bin >= mu_bins_ || sigma_bin >= sigma_bins_)
    throw BadArgumentException(name() + " of a histogram of " + sizeText(*this));
  if (count > std::numeric_limits<std::uint64_t>::max() - total_)
    throw BadArgumentException("count " + std::to_string(count) + " of " + name() +
                               ": the sum of all counts must stay below 2^64");
  std::uint64_t& bin = counts_[mu_bin * sigma_bins_ + sigma_bin];
  bin += count;
  total_ += count;
  peak_ = std::max(peak_, bin);
}

void
ShapeHistogram::merge(const ShapeHistogram& other)
{
  if (!sameBins(other))
    throw BadArgumentException("histograms of " + sizeText(*this) + " and " +
                               sizeText(other) +
                               ", or of other ranges, cannot be merged");
  for (std::size_t i = 0; i < mu_bins_; ++i)
    for (std::size_t j = 0; j < sigma_bins_; ++j)
      add(i, j, other.count(i, j));
  outside_ += other.outside_;
}

float
ShapeHistogram::likelihoodOfBin(std::size_t bin) const
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
  return likelihoodOfBin(Binning(*this)(inad));
}

std::vector<float>
ShapeHistogram::backProject(const PointCloud<INAD>& cloud, unsigned threads) const
{
  const bool has_few_bins = counts_.size() < cloud.size();
  std::vector<float> of_bins(has_few_bins ? counts_.size() + 1 : 0);
  for (std::size_t bin = 0; bin < of_bins.size(); ++bin)
    of_bins[bin] = likelihoodOfBin(bin);
  std::vector<float> likelihoods(cloud.size());
  const Binning binning(*this);
  kernels::parallelForRanges(
      cloud.size(), threads, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
          const std::size_t bin = binning(cloud[i]);
          const float known = has_few_bins ? of_bins[bin] : likelihoodOfBin(bin);
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
  const std::size_t bin = Binning(*this)(inad);
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
