// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Checks and reports the parameters of INAD.

#include "detection/inad_options.h"

#include "cli/errors.h"

#include <limits>

namespace pcl::app {

void
addInadOptions(CommandLine& command_line, const std::string& condition)
{
  command_line.option("radius", "R", condition + "of the neighborhoods of INAD")
      .option("normal_radius", "R", condition + "of the neighborhoods of the normals")
      .option("scale",
              "S",
              condition + "of the radii: fixed (meters), depth (meters up to\n0.8 m "
                          "away, growing with z), density (local spacings)")
      .option("k", "N", condition + "the nearest N points instead of both radii")
      .option("outlier_rate",
              "C",
              condition + "leave angles out beyond C sigma, 0 for none (2)")
      .flag("use_normals", "take the file's normals instead of estimating them");
}

AdaptiveRadius::RadiusMode
radiusMode(const Arguments& arguments)
{
  const std::string scale = arguments.choice("scale", {"fixed", "depth", "density"});
  if (scale == "depth")
    return AdaptiveRadius::DEPTH;
  return scale == "density" ? AdaptiveRadius::DENSITY : AdaptiveRadius::FIXED;
}

std::string
nameOfScale(AdaptiveRadius::RadiusMode mode)
{
  const char* const scales[] = {"fixed", "depth", "density"};
  return scales[mode];
}

INADParameters
inadParameters(const Arguments& arguments, const INADParameters& defaults)
{
  arguments.exclude("k", "radius");
  arguments.exclude("k", "normal_radius");
  arguments.exclude("use_normals", "normal_radius");
  arguments.exclude("k", "scale");
  constexpr std::uint64_t most = std::numeric_limits<int>::max();
  const auto radius = arguments.number("radius", positive_length);
  const auto normal_radius = arguments.number("normal_radius", positive_length);
  const auto k = arguments.integer("k", 1, most);
  INADParameters parameters = defaults;
  if (arguments.has("scale"))
    parameters.radius_mode = radiusMode(arguments);
  parameters.outlier_rate =
      arguments.number("outlier_rate", non_negative).value_or(defaults.outlier_rate);
  if (k) {
    parameters.k = static_cast<int>(*k);
    parameters.radius_mode = AdaptiveRadius::FIXED;
    parameters.radius = 0.0;
    parameters.normal_radius = 0.0;
  }
  else if (radius || normal_radius) {
    if (!radius && defaults.radius <= 0.0)
      throw UsageError("-normal_radius '" + arguments.text("normal_radius") +
                       "' without -radius; expected both, or -radius alone");
    const bool one_radius = defaults.normal_radius == defaults.radius;
    parameters.k = 0;
    parameters.radius = radius.value_or(defaults.radius);
    parameters.normal_radius =
        normal_radius.value_or(one_radius ? parameters.radius : defaults.normal_radius);
  }
  return parameters;
}

void
reportParameters(const INADParameters& parameters, Report& report)
{
  if (parameters.k > 0)
    report.setCount("parameters", "k", static_cast<std::uint64_t>(parameters.k));
  else {
    report.setNumber("parameters", "normal_radius", parameters.normal_radius);
    report.setNumber("parameters", "radius", parameters.radius);
  }
  report.setText("parameters", "scale", nameOfScale(parameters.radius_mode));
  report.setNumber("parameters", "outlier_rate", parameters.outlier_rate);
}

void
requireEnoughPoints(const INADParameters& parameters,
                    const CloudFile& cloud,
                    const pcl::PointCloud<pcl::PointXYZ>& points)
{
  const std::size_t finite = countFinite(points);
  if (parameters.k > 0 && static_cast<std::size_t>(parameters.k) > finite)
    throw InputError(cloud.path + ": -k '" + std::to_string(parameters.k) +
                     "': expected 1 to the number of its finite points, " +
                     std::to_string(finite));
}

} // namespace pcl::app
