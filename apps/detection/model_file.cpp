// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Reads, extends and writes model files.

#include "detection/model_file.h"

#include "detection/inad.h"
#include "io/errors.h"

#include <pcl/exceptions.h>

#include <filesystem>

namespace pcl::app {
namespace {

constexpr NumberRange smoothing_range{
    0.0, 100.0, false, "a number of bins from 0 to 100"};

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
                       "; expected the model's own value, or a new model file");
    return model;
  }
  if (!arguments.has("radius") && !arguments.has("k"))
    throw UsageError("-radius and -k are missing for the new model '" + path +
                     "'; expected one of the two");
  INADParameters parameters = inadParameters(arguments, {});
  parameters.normal_radius_noise =
      arguments.number("normal_radius_noise", non_negative).value_or(0.0);
  parameters.radius_noise =
      arguments.number("radius_noise", non_negative).value_or(0.0);
  const double growth = parameters.normal_radius_noise + parameters.radius_noise;
  if (growth > 0.0 && parameters.radius_mode != AdaptiveRadius::DENSITY)
    throw UsageError("-normal_radius_noise or -radius_noise without -scale density; "
                     "expected 0, or -scale density");
  return pcl::ShapeModel(parameters);
}

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

/** The bins of the model's classes, without a count; of a model without a class those
 * of -bins, -mu_range and -sigma_range. */
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

/** Bins, counts and peak, angles in degrees. */
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

ModelFile::ModelFile(const std::string& path,
                     const Arguments& arguments,
                     std::vector<SampleOptions> classes)
: path_(path)
, arguments_(arguments)
, model_(startModel(path, arguments))
, classes_(std::move(classes))
, histograms_(classes_.size(), emptyHistogram(model_, path, arguments))
{
  arguments_.number("prior", positive_number);
  const auto floor = arguments_.number("floor", non_negative);
  const auto smoothing = arguments_.number("smoothing", smoothing_range);
  model_.setFloor(floor.value_or(model_.floor()));
  model_.setSmoothing(smoothing.value_or(model_.smoothing()));
  if (model_.smoothing() > 0.0 &&
      model_.parameters().radius_mode == AdaptiveRadius::FIXED)
    throw UsageError("-smoothing '" + arguments_.text("smoothing") +
                     "' with -scale fixed; expected -scale density");
}

void
ModelFile::add(CloudFile& sample, Report& report)
{
  const InadCloud cloud = estimateInad(sample, arguments_, model_.parameters(), report);
  std::uint64_t counted = 0;
  for (std::size_t c = 0; c < classes_.size(); ++c) {
    const SampleOptions& options = classes_[c];
    const std::vector<std::uint32_t> labels =
        options.field.empty() ? std::vector<std::uint32_t>(sample.size(), options.value)
                              : labelsOf(sample, options.field);
    const std::uint64_t before = histograms_[c].total();
    for (std::size_t i = 0; i < labels.size(); ++i)
      if (labels[i] == options.value)
        histograms_[c].add((*cloud.inad)[i]);
    counted += histograms_[c].total() - before;
  }
  report.setCount("counts", "counted", counted);
  const SampleOptions& first = classes_.front();
  if (counted == 0)
    throw InputError(sample.path + ": no point has a known INAD" +
                     (first.field.empty() ? std::string()
                      : classes_.size() > 1
                          ? " and a value of -classes in field '" + first.field + "'"
                          : " and the value " + std::to_string(first.value) +
                                " in field '" + first.field + "'") +
                     "; expected a sample with at least one");
}

double
ModelFile::priorOf(const SampleOptions& options) const
{
  if (options.prior)
    return *options.prior;
  double prior = 1.0;
  for (const auto& of : model_.classes())
    if (of.name == options.name)
      prior = of.prior;
  return arguments_.number("prior", positive_number).value_or(prior);
}

void
ModelFile::addClasses()
{
  for (std::size_t c = 0; c < classes_.size(); ++c) {
    const SampleOptions& options = classes_[c];
    if (histograms_[c].total() == 0)
      throw InputError("class '" + options.name +
                       "': no point of any sample has the value " +
                       std::to_string(options.value) + " in field '" + options.field +
                       "'; expected samples with at least one");
    model_.add(options.name, histograms_[c], priorOf(options));
  }
}

void
ModelFile::save(Report& report)
{
  addClasses();
  try {
    model_.save(path_);
  }
  catch (const pcl::PCLException& error) {
    throw InputError(messageOf(error));
  }
  const std::string name = classes_.front().name;
  report.setText("", "model", path_);
  report.setCount("", "classes", model_.classes().size());
  reportParameters(model_.parameters(), report);
  report.setText("parameters", "name", name);
  report.setNumber("parameters", "prior", priorOf(classes_.front()));
  for (const auto& of : model_.classes())
    if (of.name == name)
      reportHistogram(of.histogram, report);
}

} // namespace pcl::app
