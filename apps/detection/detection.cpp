// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// The method and its settings, from the options, and the field that it makes.

#include "detection/detection.h"

#include "cli/filter_app.h"
#include "cli/pcl_errors.h"
#include "detection/model_file.h"
#include "detection/unknown.h"
#include "io/errors.h"

#include <pcl/segmentation/shape_field_estimation.h>

#include <sstream>

namespace pcl::app {
namespace {

using FieldEstimation = pcl::ShapeFieldEstimation<pcl::PointXYZ>;

/** Note the resolution of a field, and print why it is not the one that was set. */
void
reportResolution(const std::string& path,
                 const pcl::ShapeField& field,
                 double given,
                 Report& report)
{
  report.setNumber("parameters", "resolution", field.resolution);
  if (field.resolution == given)
    return;
  std::ostringstream text;
  text << path << ": note: ";
  if (field.finest_resolution < field.resolution) {
    report.setNumber("parameters", "finest_resolution", field.finest_resolution);
    text << "noise grows with the distances between points: resolutions are "
         << field.finest_resolution << " m where these are least, to "
         << field.resolution << " m";
  }
  else
    text << noteOfResolution(field.resolution);
  logLine(text.str());
}

pcl::ShapeField::ConstPtr
compute(FieldEstimation& estimation,
        const std::string& path,
        const PointsPtr& points,
        double resolution,
        unsigned threads,
        Report& report)
{
  estimation.setInputCloud(points);
  estimation.setResolution(resolution);
  estimation.setNumberOfThreads(threads);
  const auto field = pcl::make_shared<pcl::ShapeField>();
  withPclErrors(path, [&] { return estimation.compute(*field); });
  reportResolution(path, *field, resolution, report);
  reportUnknown(path, *field, threads, report);
  return field;
}

struct PaperOption {
  const char* name;
  bool has_value;
};

constexpr PaperOption paper_options[] = {{"radius", true},
                                         {"normal_radius", true},
                                         {"k", true},
                                         {"outlier_rate", true},
                                         {"scale", true},
                                         {"bins", true},
                                         {"use_normals", false},
                                         {"ignore_model_parameters", false}};

/** Refuse options of the method that is not in use. */
void
checkMethod(const Arguments& arguments, bool paper)
{
  if (paper && arguments.has("resolution"))
    throw UsageError(
        "-resolution '" + arguments.text("resolution") +
        "' belongs to the default method; it cannot be used with -mode paper");
  for (const auto& [option, has_value] : paper_options)
    if (!paper && arguments.has(option))
      throw UsageError("-" + std::string(option) +
                       (has_value ? " '" + arguments.text(option) + "'" : "") +
                       " belongs to the paper's method; add -mode paper, or leave it "
                       "out");
}

void
loadDefaultModel(const std::string& path, DetectionSettings& settings)
{
  settings.model = loadModel(path);
  if (settings.model.classes().size() < 2 ||
      settings.model.parameters().radius_mode != AdaptiveRadius::DENSITY)
    throw InputError(path +
                     ": a model of the paper's method; add -mode paper, or use a "
                     "model of two classes or more, made with -scale density");
}

void
loadPaperModel(const Arguments& arguments, DetectionSettings& settings)
{
  const std::string path = arguments.text("model");
  settings.model = loadModel(path);
  settings.parameters = inadParameters(arguments, settings.model.parameters());
  const std::string disagreement = settings.model.disagreement(settings.parameters);
  if (!disagreement.empty() && !arguments.has("ignore_model_parameters"))
    throw InputError(path + ": " + disagreement +
                     "; leave the option out, or add -ignore_model_parameters");
}

} // namespace

std::string
noteOfResolution(double resolution)
{
  std::ostringstream text;
  text << "neighbors share noise that is larger than the distances between points: "
          "the result is that of -resolution "
       << resolution;
  return text.str();
}

void
addResolutionOption(CommandLine& command_line)
{
  command_line.option(
      "resolution", "L", "look no finer than L meters, in clouds with many points");
}

double
resolutionOf(const Arguments& arguments)
{
  return arguments.number("resolution", positive_length).value_or(0.0);
}

void
addDetectionOptions(CommandLine& command_line)
{
  command_line.option("model", "F", "a model file instead of the default model")
      .option("mode", "M", "default (default), or paper: the published method");
  addResolutionOption(command_line);
  command_line.flag("normals", "write normal_x normal_y normal_z curvature too")
      .option("threshold",
              "T",
              "likelihood from which a point is of the surface (0.5); edges, or with "
              "-mode paper")
      .option("bins", "N", "with -mode paper: N x N bins for an ideal plane (10)");
  addInadOptions(command_line, "with -mode paper: ");
  command_line.flag(
      "ignore_model_parameters",
      "with -mode paper: use a model at other radii than it was made with");
}

DetectionSettings
detectionSettings(const Arguments& arguments, const INADParameters& paper)
{
  constexpr std::uint64_t default_bins = 10, max_bins = 4096;
  arguments.exclude("model", "bins");
  arguments.exclude("use_normals", "normals");
  DetectionSettings settings;
  settings.paper = arguments.choice("mode", {"default", "paper"}) == "paper";
  settings.has_model = arguments.has("model");
  settings.threshold =
      arguments.number("threshold", probability).value_or(settings.threshold);
  settings.resolution = resolutionOf(arguments);
  settings.parameters = inadParameters(arguments, paper);
  const auto bins = arguments.integer("bins", 1, max_bins).value_or(default_bins);
  checkMethod(arguments, settings.paper);
  if (settings.has_model && settings.paper)
    loadPaperModel(arguments, settings);
  else if (settings.has_model)
    loadDefaultModel(arguments.text("model"), settings);
  else if (settings.paper)
    settings.model = pcl::ShapeModel::idealPlane(settings.parameters, bins);
  return settings;
}

pcl::ShapeField::ConstPtr
fieldOf(CloudFile& file,
        const PointsPtr& points,
        const DetectionSettings& settings,
        bool edges_only,
        const Arguments& arguments,
        Report& report)
{
  reportPoints(*points, report);
  report.setText("parameters", "mode", "default");
  report.setText("parameters", "scale", "density");
  report.setNumber("parameters", "threshold", settings.threshold);
  report.setText("parameters", "model", arguments.text("model", "default"));
  report.setCount("parameters", "threads", arguments.threads());
  FieldEstimation estimation;
  estimation.setEdgesOnly(edges_only);
  estimation.setOneResolution(settings.one_resolution);
  if (settings.has_model && edges_only)
    estimation.setEdgeModel(settings.model);
  else if (settings.has_model)
    estimation.setSurfaceModel(settings.model);
  const auto field = compute(
      estimation, file.path, points, settings.resolution, arguments.threads(), report);
  if (arguments.has("normals")) {
    const pcl::ShapeModel& model =
        edges_only ? estimation.getEdgeModel() : estimation.getSurfaceModel();
    addNormals(file, points, model.parameters(), arguments.threads());
  }
  return field;
}

PointsPtr
prepare(Detector& detector,
        CloudFile& file,
        const DetectionSettings& settings,
        const Arguments& arguments,
        Report& report)
{
  detector.setNumberOfThreads(arguments.threads());
  detector.setMode(settings.paper ? Detector::PAPER : Detector::DEFAULT);
  detector.setThreshold(settings.threshold);
  if (!settings.paper) {
    const PointsPtr points = pointsOf(file);
    detector.setInputCloud(points);
    return points;
  }
  const InadCloud cloud = estimateInad(file, arguments, settings.parameters, report);
  report.setText("parameters", "mode", "paper");
  report.setNumber("parameters", "threshold", settings.threshold);
  report.setText("parameters", "model", arguments.text("model", "ideal plane"));
  report.setCount(
      "parameters", "bins", settings.model.classes().front().histogram.muBins());
  detector.setInputCloud(cloud.points);
  detector.setInputNormals(cloud.normals);
  detector.setInputINAD(cloud.inad);
  detector.setModel(settings.model);
  detector.setIgnoreModelParameters(arguments.has("ignore_model_parameters"));
  return cloud.points;
}

void
reportClasses(const std::vector<std::string>& names,
              const std::vector<pcl::PointIndices>& members,
              Report& report)
{
  std::uint64_t unknown = report.count("", "finite_points");
  for (std::size_t c = 0; c < names.size(); ++c) {
    report.setCount("counts", names[c], members[c].indices.size());
    unknown -= members[c].indices.size();
  }
  report.setCount("counts", "unknown", unknown);
}

pcl::ShapeField::ConstPtr
surfaceFieldOf(const CloudFile& file,
               const PointsPtr& points,
               const std::optional<pcl::ShapeModel>& model,
               double resolution,
               unsigned threads,
               Report& report)
{
  FieldEstimation estimation;
  if (model)
    estimation.setSurfaceModel(*model);
  return compute(estimation, file.path, points, resolution, threads, report);
}

} // namespace pcl::app
