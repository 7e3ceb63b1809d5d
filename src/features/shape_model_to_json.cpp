/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * Point Cloud Library (PCL) - www.pointclouds.org
 * Copyright (c) 2026, pcl_shape contributors
 *
 * All rights reserved
 */

#include "shape_model_json.h"

namespace pcl::detail {
namespace {

Json
toJson(const ShapeModel::Class& c)
{
  const ShapeHistogram& histogram = c.histogram;
  Json rows = Json::array();
  for (std::size_t i = 0; i < histogram.muBins(); ++i) {
    Json row = Json::array();
    for (std::size_t j = 0; j < histogram.sigmaBins(); ++j) {
      row.push_back(histogram.count(i, j));
    }
    rows.push_back(row);
  }
  return {{"name", c.name}, {"prior", c.prior}, {"counts", rows}};
}

} // namespace

Json
toJson(const ShapeModel& model)
{
  const INADParameters& p = model.parameters();
  const ShapeHistogram& bins = model.classes().front().histogram;
  Json classes = Json::array();
  for (const ShapeModel::Class& c : model.classes()) {
    classes.push_back(toJson(c));
  }
  Json parameters = {{"normal_radius", p.normal_radius},
                     {"radius", p.radius},
                     {"k", p.k},
                     {"outlier_rate", p.outlier_rate}};
  if (p.radius_mode != AdaptiveRadius::FIXED || model.smoothing() != 0.0) {
    parameters["scale"] = scale_names[p.radius_mode];
    parameters["normal_radius_noise"] = p.normal_radius_noise;
    parameters["radius_noise"] = p.radius_noise;
    parameters["smoothing"] = model.smoothing();
  }
  return {{"format", format_name},
          {"version", format_version},
          {"parameters", parameters},
          {"bins",
           {{"mu", bins.muBins()},
            {"sigma", bins.sigmaBins()},
            {"mu_range", bins.muRange()},
            {"sigma_range", bins.sigmaRange()}}},
          {"floor", model.floor()},
          {"classes", classes}};
}

} // namespace pcl::detail
