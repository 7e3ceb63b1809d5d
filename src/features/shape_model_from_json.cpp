/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * Point Cloud Library (PCL) - www.pointclouds.org
 * Copyright (c) 2026, pcl_shape contributors
 *
 * All rights reserved
 */

#include "errors.h"
#include "shape_model_json.h"

#include <cstdint>
#include <string>

namespace pcl::detail {
namespace {

AdaptiveRadius::RadiusMode
scaleFrom(const JsonReader& reader)
{
  const std::string name = reader.text("scale");
  for (const auto mode :
       {AdaptiveRadius::FIXED, AdaptiveRadius::DEPTH, AdaptiveRadius::DENSITY}) {
    if (name == scale_names[mode]) {
      return mode;
    }
  }
  reader.fail("'scale' is \"" + name + "\": it must be fixed, depth or density");
}

/** \brief The parameters; the model's smoothing is among them in the file, since mostly
 * models of another scale than metres have it. */
INADParameters
parametersFrom(const Json& json, double& smoothing)
{
  const bool has_scale = json.is_object() && json.contains("scale");
  const JsonReader reader =
      has_scale ? JsonReader(json,
                             "'parameters'",
                             {"normal_radius",
                              "radius",
                              "k",
                              "outlier_rate",
                              "scale",
                              "normal_radius_noise",
                              "radius_noise",
                              "smoothing"})
                : JsonReader(json,
                             "'parameters'",
                             {"normal_radius", "radius", "k", "outlier_rate"});
  const std::uint64_t k = reader.count("k");
  if (k > 0x7fffffff) {
    reader.fail("'k' is " + std::to_string(k) + ": at most 2^31 - 1 is allowed");
  }
  INADParameters parameters;
  parameters.normal_radius = reader.number("normal_radius");
  parameters.radius = reader.number("radius");
  parameters.k = static_cast<int>(k);
  parameters.outlier_rate = reader.number("outlier_rate");
  if (has_scale) {
    parameters.radius_mode = scaleFrom(reader);
    parameters.normal_radius_noise = reader.number("normal_radius_noise");
    parameters.radius_noise = reader.number("radius_noise");
    smoothing = reader.number("smoothing");
  }
  return parameters;
}

ShapeHistogram
emptyHistogramFrom(const Json& json)
{
  const JsonReader reader(json, "'bins'", {"mu", "sigma", "mu_range", "sigma_range"});
  return ShapeHistogram(reader.count("mu"),
                        reader.count("sigma"),
                        reader.number("mu_range"),
                        reader.number("sigma_range"));
}

void
readRow(const Json& row,
        std::size_t i,
        const std::string& where,
        ShapeHistogram& histogram)
{
  const auto fail = [&](const std::string& problem) {
    raise<BadArgumentException>(textOf(where, " ", problem));
  };
  if (!row.is_array() || row.size() != histogram.sigmaBins()) {
    fail("must have " + std::to_string(histogram.sigmaBins()) +
         " counts in each row, as 'bins' says; row " + std::to_string(i) + " has not");
  }
  for (std::size_t j = 0; j < row.size(); ++j) {
    if (!row[j].is_number_unsigned()) {
      fail("has the count " + row[j].dump().substr(0, 40) + " in bin (" +
           std::to_string(i) + ", " + std::to_string(j) +
           "): counts must be whole numbers, not negative");
    }
    histogram.add(i, j, row[j].get<std::uint64_t>());
  }
}

void
addClass(const Json& json, const ShapeHistogram& empty, ShapeModel& model)
{
  const JsonReader reader(json, "a class", {"name", "prior", "counts"});
  const std::string name = reader.text("name");
  for (const ShapeModel::Class& known : model.classes()) {
    if (known.name == name) {
      reader.fail("'" + name + "' occurs twice");
    }
  }
  const Json& rows = reader.array("counts");
  const std::string where = "'counts' of class '" + name + "'";
  if (rows.size() != empty.muBins()) {
    raise<BadArgumentException>(textOf(where,
                                       " must have ",
                                       empty.muBins(),
                                       " rows, as 'bins' says, not ",
                                       rows.size()));
  }
  ShapeHistogram histogram = empty;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    readRow(rows[i], i, where, histogram);
  }
  model.add(name, histogram, reader.number("prior"));
}

} // namespace

ShapeModel
modelFrom(const Json& json)
{
  if (!json.is_object() || !json.contains("format") || json["format"] != format_name) {
    raise<BadArgumentException>(textOf(
        R"(it is not a shape model: "format": ")", format_name, R"(" is missing)"));
  }
  if (!json.contains("version") || json["version"] != format_version) {
    raise<BadArgumentException>(textOf(
        "its version is ",
        (json.contains("version") ? json["version"].dump().substr(0, 40) : "missing"),
        ": only version ",
        format_version,
        " can be read; make the model again with pcl_shape_histogram"));
  }
  const JsonReader reader(
      json,
      "the model",
      {"format", "version", "parameters", "bins", "floor", "classes"});
  double smoothing = 0.0;
  ShapeModel model(parametersFrom(reader.member("parameters"), smoothing));
  model.setSmoothing(smoothing);
  model.setFloor(reader.number("floor"));
  const ShapeHistogram empty = emptyHistogramFrom(reader.member("bins"));
  for (const Json& c : reader.array("classes")) {
    addClass(c, empty, model);
  }
  if (model.classes().empty()) {
    reader.fail("has no class: at least one is needed");
  }
  return model;
}

} // namespace pcl::detail
