// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// The settings of the detectors and what a model file says of them.

#include "detection/detection.h"

#include "detection/model_file.h"
#include "detection/resolution.h"

namespace pcl::app {
void
addDetectionOptions(CommandLine& command_line)
{
  command_line.option("model", "F", "a model file instead of the default model")
      .option("mode", "M", "default (default), or paper: the published method")
      .option("bins", "N", "N x N bins for an ideal plane, as in paper mode (10)")
      .option(
          "threshold", "T", "likelihood from which a point is of the surface (0.5)");
  addInadOptions(command_line);
  addResolutionOption(command_line);
  command_line
      .flag("ignore_model_parameters",
            "use a model at other radii than it was made with")
      .flag("normals", "write normal_x normal_y normal_z curvature too");
}

namespace {

/** All but the resolution. */
DetectionSettings
settingsOf(const Arguments& arguments, const INADParameters& defaults)
{
  constexpr std::uint64_t default_bins = 10;
  constexpr std::uint64_t most_bins = 4096;
  arguments.exclude("model", "bins");
  arguments.exclude("use_normals", "normals");
  DetectionSettings settings;
  settings.paper = arguments.choice("mode", {"default", "paper"}) == "paper";
  settings.threshold =
      arguments.number("threshold", probability).value_or(settings.threshold);
  const auto bins = arguments.integer("bins", 1, most_bins).value_or(default_bins);
  const bool is_own = settings.paper || hasInadParameters(arguments) ||
                      arguments.has("use_normals") || arguments.has("bins");
  const bool is_density =
      !arguments.has("scale") || radiusMode(arguments) == AdaptiveRadius::DENSITY;
  if (!arguments.has("model")) {
    settings.adaptive = !is_own && is_density;
    settings.parameters = inadParameters(arguments, defaults);
    settings.model = pcl::ShapeModel::idealPlane(settings.parameters, bins);
    return settings;
  }
  const std::string path = arguments.text("model");
  settings.model = loadModel(path);
  settings.adaptive =
      !is_own && is_density && settings.model.classes().size() > 1 &&
      settings.model.parameters().radius_mode == AdaptiveRadius::DENSITY;
  settings.parameters = inadParameters(arguments, settings.model.parameters());
  const std::string disagreement = settings.model.disagreement(settings.parameters);
  if (!disagreement.empty() && !arguments.has("ignore_model_parameters"))
    throw InputError(path + ": " + disagreement +
                     "; expected the model's own value, or -ignore_model_parameters");
  return settings;
}

} // namespace

DetectionSettings
detectionSettings(const Arguments& arguments, const INADParameters& defaults)
{
  DetectionSettings settings = settingsOf(arguments, defaults);
  settings.resolution = resolutionOf(arguments);
  if (settings.resolution > 0.0 && !settings.adaptive)
    throw UsageError("-resolution '" + arguments.text("resolution") +
                     "' with radii, -k, -outlier_rate, -bins, -use_normals, -scale, "
                     "-mode paper or a model not made with -scale density; use the "
                     "default mode without them");
  return settings;
}

} // namespace pcl::app
