// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Says why many points are unknown.

#include "detection/unknown.h"

#include "cli/command_line.h"

#include <pcl/segmentation/unknown_points.h>
#include <pcl/features/impl/neighborhoods.hpp>

#include <cmath>
#include <sstream>
#include <vector>

namespace pcl::app {
namespace {

constexpr std::size_t one_of = 20; // 5 %: scans have as many strays and border points

std::string
meters(float length)
{
  std::ostringstream text;
  text.precision(2);
  text << length << " m";
  return text.str();
}

/** The reasons that apply, each with the number of points that it explains. */
std::string
reasonsOf(const pcl::UnknownPoints& points)
{
  std::string text;
  const auto add = [&](std::size_t count, const std::string& reason) {
    if (count > 0)
      text += (text.empty() ? "" : "; ") + std::to_string(count) + ' ' + reason;
  };
  const std::string spacing = meters(points.spacing);
  add(points.rounded,
      "have coordinates too large for float, whose spacing is " +
          meters(points.float_spacing) + " there and the cloud's " + spacing +
          ": subtract an offset before they become floats");
  add(points.at_one_place, "are at one place with others, and nothing around it");
  add(points.few_neighbors,
      "have fewer than 5 neighbors within their radius" +
          (points.radius > 0.0f ? ", " + meters(points.radius) : "") + " (median)" +
          (points.spacing > 0.0f ? ", where the cloud's spacing is " + spacing : ""));
  add(points.on_a_line, "have all neighbors on a line");
  add(points.unknown_neighbors, "have too few neighbors that are known");
  return text;
}

/** Whether enough points are unknown to look for the reasons, which takes longer. */
bool
areMany(const pcl::XYZView& points, const std::vector<float>& values)
{
  std::size_t finite = 0, unknown = 0;
  for (std::size_t i = 0; i < points.size; ++i) {
    const float* const p = points[i];
    const bool is_finite =
        std::isfinite(p[0]) && std::isfinite(p[1]) && std::isfinite(p[2]);
    finite += is_finite ? 1 : 0;
    unknown += is_finite && std::isnan(values[i]) ? 1 : 0;
  }
  return unknown * one_of > finite;
}

void
addReasons(const std::string& path, const pcl::UnknownPoints& points, Report& report)
{
  const bool is_said = report.hasFlag("parameters", "rounded_coordinates");
  if (points.rounded < points.unknown || !is_said) // by chooseOffset()
    logLine(path + ": warning: " + std::to_string(points.unknown) + " of " +
            std::to_string(points.finite) +
            " points got no answer: " + reasonsOf(points));
  const std::string section = "unknown";
  report.setCount(section, "float_rounding", points.rounded);
  report.setCount(section, "at_one_place", points.at_one_place);
  report.setCount(section, "few_neighbors", points.few_neighbors);
  report.setCount(section, "on_a_line", points.on_a_line);
  report.setCount(section, "unknown_neighbors", points.unknown_neighbors);
  report.setNumber(section, "spacing", points.spacing);
  report.setNumber(section, "float_spacing", points.float_spacing);
  report.setNumber(section, "radius", points.radius);
}

} // namespace

void
reportUnknown(const std::string& path,
              const pcl::ShapeField& field,
              unsigned threads,
              Report& report)
{
  const bool has_classes = !field.likelihoods.empty();
  if (areMany(field.points,
              has_classes ? field.likelihoods.front() : field.edge_likelihood))
    addReasons(path, pcl::unknownPoints(field, threads), report);
}

void
reportUnknown(const std::string& path,
              const pcl::PointCloud<pcl::PointXYZ>& points,
              const pcl::PointCloud<pcl::INAD>& inad,
              const pcl::INADParameters& parameters,
              unsigned threads,
              Report& report)
{
  std::vector<float> mu;
  mu.reserve(inad.size());
  for (const pcl::INAD& point : inad)
    mu.push_back(point.mu);
  const pcl::XYZView view = pcl::detail::xyzOf(points);
  if (areMany(view, mu))
    addReasons(path, pcl::unknownPoints(view, mu, parameters, threads), report);
}

} // namespace pcl::app
