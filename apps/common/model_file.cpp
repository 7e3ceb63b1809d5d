/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * Point Cloud Library (PCL) - www.pointclouds.org
 * Copyright (c) 2026, pcl_shape contributors
 *
 * All rights reserved
 */

#include "model_file.h"

#include "errors.h"
#include "inad_options.h"
#include "inad_stages.h"

#include <pcl/exceptions.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <limits>

namespace pcl::app {
namespace {

constexpr double degrees_per_radian = 180.0 / 3.14159265358979323846;

/** The message, before which PCLException puts ": ". */
std::string
messageOf(const pcl::PCLException& error)
{
  const std::string text = error.what();
  return text.rfind(": ", 0) == 0 ? text.substr(2) : text;
}

pcl::ShapeModel
startModel(const std::string& path, const Arguments& arguments)
{
  if (std::filesystem::exists(path)) {
    pcl::ShapeModel model = loadModel(path);
    const std::string disagreement =
        model.disagreement(inadParameters(arguments, model.parameters()));
    if (!disagreement.empty())
      throw InputError(path + ": " + disagreement +
                       ": allowed is the model's own value, or a new model file");
    return model;
  }
  if (!arguments.has("radius") && !arguments.has("k"))
    throw UsageError("-radius and -k are missing for the new model '" + path +
                     "': allowed is one of the two");
  return pcl::ShapeModel(inadParameters(arguments, {}));
}

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

} // namespace

pcl::ShapeModel
loadModel(const std::string& path)
{
  try {
    return pcl::ShapeModel::load(path);
  }
  catch (const pcl::PCLException& error) {
    throw InputError(messageOf(error));
  }
}

SampleOptions
sampleOptions(const Arguments& arguments)
{
  SampleOptions options;
  options.name = arguments.text("name", options.name);
  const auto allowed = [](unsigned char c) {
    return std::isalnum(c) != 0 || c == '_' || c == '-';
  };
  if (!std::all_of(options.name.begin(), options.name.end(), allowed))
    throw UsageError("-name '" + options.name +
                     "': allowed are letters, digits, _ and -");
  if (arguments.has("field") != arguments.has("value"))
    throw UsageError("-field '" + arguments.text("field") + "' and -value '" +
                     arguments.text("value") + "': allowed is both or neither");
  options.field = arguments.text("field");
  options.value = static_cast<std::uint32_t>(
      arguments.integer("value", 0, std::numeric_limits<std::uint32_t>::max())
          .value_or(0));
  return options;
}

ModelFile::ModelFile(const std::string& path, const Arguments& arguments)
: path_(path)
, arguments_(arguments)
, model_(startModel(path, arguments))
, histogram_(emptyHistogram())
{
  arguments_.number("prior", positive_number);
}

pcl::ShapeHistogram
ModelFile::emptyHistogram() const
{
  constexpr std::uint64_t most_bins = 4096;
  const pcl::ShapeHistogram like = model_.classes().empty()
                                       ? pcl::ShapeHistogram()
                                       : model_.classes().front().histogram;
  const auto bins = arguments_.integer("bins", 1, most_bins);
  pcl::ShapeHistogram histogram(bins.value_or(like.muBins()),
                                bins.value_or(like.sigmaBins()),
                                radians(arguments_, "mu_range", like.muRange()),
                                radians(arguments_, "sigma_range", like.sigmaRange()));
  if (!model_.classes().empty() && !histogram.sameBins(like))
    throw InputError(path_ + ": " + std::to_string(histogram.muBins()) + " x " +
                     std::to_string(histogram.sigmaBins()) + " bins over " +
                     std::to_string(histogram.muRange() * degrees_per_radian) + " x " +
                     std::to_string(histogram.sigmaRange() * degrees_per_radian) +
                     " degrees are asked for: allowed are the model's " +
                     std::to_string(like.muBins()) + " x " +
                     std::to_string(like.sigmaBins()) + " over " +
                     std::to_string(like.muRange() * degrees_per_radian) + " x " +
                     std::to_string(like.sigmaRange() * degrees_per_radian));
  return histogram;
}

void
ModelFile::add(CloudFile& sample, const SampleOptions& options, Report& report)
{
  const InadCloud cloud = estimateInad(sample, arguments_, model_.parameters(), report);
  const std::vector<std::uint32_t> labels =
      options.field.empty() ? std::vector<std::uint32_t>(sample.size(), options.value)
                            : labelsOf(sample, options.field);
  const std::uint64_t before = histogram_.total();
  for (std::size_t i = 0; i < labels.size(); ++i)
    if (labels[i] == options.value)
      histogram_.add((*cloud.inad)[i]);
  const std::uint64_t counted = histogram_.total() - before;
  report.setCount("counts", "counted", counted);
  if (counted == 0)
    throw InputError(sample.path + ": no point has a known INAD" +
                     (options.field.empty()
                          ? std::string()
                          : " and the value " + std::to_string(options.value) +
                                " in field '" + options.field + "'") +
                     ": allowed is a sample with at least one");
}

double
ModelFile::priorOf(const std::string& name) const
{
  double prior = 1.0;
  for (const auto& of : model_.classes())
    if (of.name == name)
      prior = of.prior;
  return arguments_.number("prior", positive_number).value_or(prior);
}

void
ModelFile::save(const SampleOptions& options, Report& report)
{
  const double prior = priorOf(options.name);
  model_.add(options.name, histogram_, prior);
  try {
    model_.save(path_);
  }
  catch (const pcl::PCLException& error) {
    throw InputError(messageOf(error));
  }
  report.setText("", "model", path_);
  report.setCount("", "classes", model_.classes().size());
  reportParameters(model_.parameters(), report);
  report.setText("parameters", "name", options.name);
  report.setNumber("parameters", "prior", prior);
  for (const auto& of : model_.classes())
    if (of.name == options.name)
      reportHistogram(of.histogram, report);
}

} // namespace pcl::app
