// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// The histogram of one class: its bins from the options, its report.

#include "detection/class_histogram.h"

#include "cli/errors.h"

#include <cstddef>
#include <cstdint>

namespace pcl::app {
namespace {

constexpr double degrees_per_radian = 180.0 / 3.14159265358979323846;

double
radians(const Arguments& arguments, const std::string& name, double fallback)
{
  const auto degrees = arguments.number(name, right_angle);
  return degrees ? *degrees / degrees_per_radian : fallback;
}

struct Peak {
  std::size_t mu_bin = 0;
  std::size_t sigma_bin = 0;
};

Peak
peakOf(const pcl::ShapeHistogram& histogram)
{
  Peak peak;
  for (std::size_t i = 0; i < histogram.muBins(); ++i)
    for (std::size_t j = 0; j < histogram.sigmaBins(); ++j)
      if (histogram.count(i, j) > histogram.count(peak.mu_bin, peak.sigma_bin))
        peak = {i, j};
  return peak;
}

} // namespace

pcl::ShapeHistogram
emptyHistogram(const pcl::ShapeModel& model,
               const std::string& path,
               const Arguments& arguments)
{
  constexpr std::uint64_t max_bins = 4096;
  const pcl::ShapeHistogram like = model.classes().empty()
                                       ? pcl::ShapeHistogram()
                                       : model.classes().front().histogram;
  const auto bins = arguments.integer("bins", 1, max_bins);
  pcl::ShapeHistogram histogram(bins.value_or(like.muBins()),
                                bins.value_or(like.sigmaBins()),
                                radians(arguments, "mu_range", like.muRange()),
                                radians(arguments, "sigma_range", like.sigmaRange()));
  if (!model.classes().empty() && !histogram.sameBins(like))
    throw InputError(path + ": " + std::to_string(histogram.muBins()) + " x " +
                     std::to_string(histogram.sigmaBins()) + " bins over " +
                     std::to_string(histogram.muRange() * degrees_per_radian) + " x " +
                     std::to_string(histogram.sigmaRange() * degrees_per_radian) +
                     " degrees are asked for; expected the model's " +
                     std::to_string(like.muBins()) + " x " +
                     std::to_string(like.sigmaBins()) + " over " +
                     std::to_string(like.muRange() * degrees_per_radian) + " x " +
                     std::to_string(like.sigmaRange() * degrees_per_radian));
  return histogram;
}

void
reportHistogram(const pcl::ShapeHistogram& histogram, Report& report)
{
  const Peak peak = peakOf(histogram);
  const auto middle = [](std::size_t bin, std::size_t bins, double range) {
    return (static_cast<double>(bin) + 0.5) / static_cast<double>(bins) * range *
           degrees_per_radian;
  };
  report.setCount("histogram", "mu_bins", histogram.muBins());
  report.setCount("histogram", "sigma_bins", histogram.sigmaBins());
  report.setNumber("histogram", "mu_range", histogram.muRange() * degrees_per_radian);
  report.setNumber(
      "histogram", "sigma_range", histogram.sigmaRange() * degrees_per_radian);
  report.setCount("histogram", "total", histogram.total());
  report.setCount("histogram", "outside", histogram.outside());
  report.setCount("histogram", "peak", histogram.peak());
  report.setNumber("histogram",
                   "peak_mu",
                   middle(peak.mu_bin, histogram.muBins(), histogram.muRange()));
  report.setNumber(
      "histogram",
      "peak_sigma",
      middle(peak.sigma_bin, histogram.sigmaBins(), histogram.sigmaRange()));
}

} // namespace pcl::app
