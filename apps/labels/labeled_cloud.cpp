// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// From -confidence, -model and -resolution to labels and their files.

#include "labels/labeled_cloud.h"

#include "cli/filter_app.h"
#include "cli/pcl_errors.h"
#include "detection/detection.h"
#include "detection/inad.h"
#include "detection/model_file.h"
#include "io/errors.h"
#include "io/kitti_file.h"
#include "io/pcd.h"
#include "io/ply.h"

#include <algorithm>
#include <numeric>

namespace pcl::app {
namespace {

using Labeling = pcl::ShapeLabeling<pcl::PointXYZ>;

Labeling
labelingOf(const LabelSettings& settings)
{
  Labeling labeling;
  labeling.setConfidence(settings.confidence);
  labeling.setResolution(settings.resolution);
  labeling.setNumberOfThreads(settings.threads);
  if (settings.model)
    labeling.setModel(*settings.model);
  return labeling;
}

void
reportLabels(const PointLabels& labels,
             const std::vector<std::string>& names,
             Report& report)
{
  std::vector<std::uint64_t> counts(names.size(), 0);
  for (const std::uint32_t label : labels.labels)
    ++counts[label];
  for (std::size_t label = 0; label < names.size(); ++label)
    report.setCount("counts", names[label], counts[label]);
  const double sum =
      std::accumulate(labels.confidence.begin(), labels.confidence.end(), 0.0);
  report.setNumber(
      "", "mean_confidence", sum / static_cast<double>(labels.confidence.size()));
}

bool
isKey(const std::string& name)
{
  return name != "void" && name != "edge" &&
         std::all_of(name.begin(), name.end(), [](unsigned char c) {
           return c > ' ' && c <= '~' && c != '"' && c != '\\';
         });
}

/** Names of classes become keys of JSON and YAML, beside void and edge. */
void
requireNames(const pcl::ShapeModel& model, const std::string& path)
{
  const auto& classes = model.classes();
  const auto bad = std::find_if(
      classes.begin(), classes.end(), [](const auto& of) { return !isKey(of.name); });
  if (bad != classes.end())
    throw InputError(path + ": class '" + bad->name +
                     "': expected a name in ASCII without blanks and quotes, other "
                     "than void and edge");
}

} // namespace

LabelSettings
labelSettings(const Arguments& arguments)
{
  LabelSettings settings;
  settings.threads = arguments.threads();
  settings.confidence =
      arguments.number("confidence", probability).value_or(settings.confidence);
  settings.resolution = resolutionOf(arguments);
  if (!arguments.has("model"))
    return settings;
  const std::string path = arguments.text("model");
  settings.model = loadModel(path);
  requireNames(*settings.model, path);
  const std::string expected =
      "; expected a model of several classes, made with -scale density";
  if (settings.model->classes().size() < 2)
    throw InputError(path + ": has " +
                     std::to_string(settings.model->classes().size()) + " class" +
                     expected);
  const auto mode = settings.model->parameters().radius_mode;
  if (mode != AdaptiveRadius::DENSITY)
    throw InputError(path + ": is of -scale " + nameOfScale(mode) + expected);
  return settings;
}

std::vector<std::string>
labelNames(const LabelSettings& settings)
{
  std::vector<std::string> names{"void"};
  for (const std::string& name : labelingOf(settings).getClasses())
    names.push_back(name);
  return names;
}

std::vector<std::uint32_t>
labelCloud(CloudFile& cloud, const LabelSettings& settings, Report& report)
{
  const auto points = pointsOf(cloud);
  reportPoints(*points, report);
  report.setNumber("parameters", "confidence", settings.confidence);
  report.setCount("parameters", "threads", settings.threads);
  Labeling labeling = labelingOf(settings);
  labeling.setInputCloud(points);
  PointLabels labels;
  report.time("label", [&] {
    labeling.setShapeField(surfaceFieldOf(
        cloud, points, settings.model, settings.resolution, settings.threads, report));
    withPclErrors(cloud.path, [&] {
      labeling.label(labels);
      return labels.labels.size() == cloud.size();
    });
  });
  reportLabels(labels, labelNames(settings), report);
  setField(cloud, "label", labels.labels);
  setField(cloud, "confidence", labels.confidence);
  return std::move(labels.labels);
}

const std::vector<std::string>&
labelFormats()
{
  static const std::vector<std::string> formats{"pcd", "ply", "kitti"};
  return formats;
}

std::vector<std::string>
outputNames(const std::string& format, const std::string& stem)
{
  if (format == "kitti")
    return {"velodyne/" + stem + ".bin", "labels/" + stem + ".label"};
  return {stem + '.' + format};
}

std::vector<std::string>
encodeLabeled(const std::string& format,
              const CloudFile& cloud,
              const std::vector<std::uint32_t>& labels)
{
  if (format == "kitti")
    return {encodeVelodyne(cloud), encodeLabels(labels)};
  if (format == "ply")
    return {encodePly(cloud)};
  return {encodeCloud(cloud, PCDFormat::binary_compressed)};
}

} // namespace pcl::app
