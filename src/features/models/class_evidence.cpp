// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Log densities of a shape model's classes, smoothed and interpolated.

#include "features/models/class_evidence.h"

#include "common/parallel.h"

#include <pcl/features/shape_model.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace pcl::detail {
namespace {

/** Where no floor is set: less than the density of one point in any real sample. */
constexpr double min_density = 1e-12;

/** One pass of a Gaussian along an axis with so many bins, so far apart. What falls off
 * the ends is not lost: weights are divided by the sum of those inside. */
std::vector<double>
smoothed(const std::vector<double>& values,
         std::size_t bins,
         std::size_t stride,
         double deviation)
{
  const auto reach = static_cast<std::ptrdiff_t>(std::ceil(3.0 * deviation));
  std::vector<double> result;
  result.reserve(values.size());
  for (std::size_t at = 0; at < values.size(); ++at) {
    const std::size_t position = at / stride % bins;
    double sum = 0.0, weights = 0.0;
    for (std::ptrdiff_t k = -reach; k <= reach; ++k) {
      const auto steps = static_cast<std::size_t>(k); // wraps around below 0
      if (position + steps >= bins)
        continue;
      const double offset = static_cast<double>(k) / deviation;
      const double weight = std::exp(-0.5 * offset * offset);
      sum += weight * values[at + steps * stride];
      weights += weight;
    }
    result.push_back(sum / weights);
  }
  return result;
}

std::vector<float>
tableOf(const ShapeHistogram& histogram, double smoothing, double floor)
{
  const std::size_t rows = histogram.muBins(), columns = histogram.sigmaBins();
  std::vector<double> counts;
  counts.reserve(rows * columns);
  for (std::size_t i = 0; i < rows; ++i)
    for (std::size_t j = 0; j < columns; ++j)
      counts.push_back(static_cast<double>(histogram.count(i, j)));
  if (smoothing > 0.0) {
    counts = smoothed(counts, rows, columns, smoothing);
    counts = smoothed(counts, columns, 1, smoothing);
  }
  double sum = 0.0;
  for (const double count : counts)
    sum += count;
  const double area = histogram.muRange() / static_cast<double>(rows) *
                      histogram.sigmaRange() / static_cast<double>(columns);
  std::vector<float> logs;
  logs.reserve(counts.size());
  for (const double count : counts)
    logs.push_back(static_cast<float>(
        std::log(count / (sum * area) + std::max(floor, min_density))));
  return logs;
}

/** The two bins that a position is between, and its share of the second. */
struct Between {
  std::size_t first, second;
  float share;
};

Between
between(double position, std::size_t bins)
{
  const auto last = static_cast<double>(bins - 1);
  const double inside = std::clamp(position - 0.5, 0.0, last);
  const auto first = static_cast<std::size_t>(inside);
  return {first,
          std::min(first + 1, bins - 1),
          static_cast<float>(inside - static_cast<double>(first))};
}

} // namespace

ShapeEvidence::ShapeEvidence(const ShapeModel& model)
: parameters_(model.parameters())
, mu_bins_(model.classes().front().histogram.muBins())
, sigma_bins_(model.classes().front().histogram.sigmaBins())
, mu_bin_(model.classes().front().histogram.muRange() / static_cast<double>(mu_bins_))
, sigma_bin_(model.classes().front().histogram.sigmaRange() /
             static_cast<double>(sigma_bins_))
{
  for (const ShapeModel::Class& c : model.classes())
    tables_.push_back(tableOf(c.histogram, model.smoothing(), model.floor()));
}

void
ShapeEvidence::logDensities(float mu, float sigma, float* values) const
{
  if (std::isnan(mu) || std::isnan(sigma)) {
    std::fill_n(values, tables_.size(), std::numeric_limits<float>::quiet_NaN());
    return;
  }
  const Between i = between(mu / mu_bin_, mu_bins_);
  const Between j = between(sigma / sigma_bin_, sigma_bins_);
  for (const std::vector<float>& table : tables_) {
    const auto along = [&](std::size_t row) {
      const float* values_of_row = &table[row * sigma_bins_];
      return values_of_row[j.first] * (1.0f - j.share) +
             values_of_row[j.second] * j.share;
    };
    *values++ = along(i.first) * (1.0f - i.share) + along(i.second) * i.share;
  }
}

std::vector<float>
ShapeEvidence::firstOverSecond(const std::vector<float>& mu_sigma,
                               unsigned threads) const
{
  if (tables_.size() != 2)
    throw std::logic_error("a ratio of densities needs two classes");
  std::vector<float> evidence(mu_sigma.size() / 2);
  kernels::parallelForEach(evidence.size(), threads, [&](std::size_t i) {
    float logs[2];
    logDensities(mu_sigma[2 * i], mu_sigma[2 * i + 1], logs);
    evidence[i] = logs[0] - logs[1];
  });
  return evidence;
}

} // namespace pcl::detail
