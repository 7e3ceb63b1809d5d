// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// The two methods of back-projection and edge detection: which settings belong to
// which.

#include "common/gathered.h"
#include "common/number_text.h"
#include "edges/edge_types.h"
#include "features/spacing/local_spacing.h"
#include "segmentation/compiled_estimations.h"

#include <pcl/segmentation/impl/shape_back_projection.hpp>
#include <pcl/segmentation/impl/shape_edge_detection.hpp>

namespace pcl {

ShapeModel
ShapeDetectionSettings::getModel() const
{
  if (model_)
    return *model_;
  return mode_ == PAPER ? ShapeModel::idealPlane(paper_) : defaultModel();
}

INADParameters
ShapeDetectionSettings::getParameters() const
{
  if (mode_ == DEFAULT)
    return getModel().parameters();
  INADParameters parameters = model_ ? model_->parameters() : paper_;
  if (has_radius_mode_)
    parameters.radius_mode = radius_mode_;
  parameters.outlier_rate = outlier_rate_.value_or(parameters.outlier_rate);
  const bool is_k = k_ && *k_ != 0;
  const bool is_radius = normal_radius_ || radius_;
  if (is_k) {
    parameters.k = *k_;
    parameters.normal_radius = parameters.radius = 0.0;
  }
  else if (is_radius && parameters.k != 0) {
    parameters.k = 0;
    parameters.normal_radius = parameters.radius = radius_ ? *radius_ : *normal_radius_;
  }
  if (!is_k || is_radius) {
    parameters.normal_radius = normal_radius_.value_or(parameters.normal_radius);
    parameters.radius = radius_.value_or(parameters.radius);
  }
  return parameters;
}

std::string
ShapeDetectionSettings::problemOfMode(const char* of_paper,
                                      const char* of_default) const
{
  if (mode_ == PAPER)
    return of_default ? std::string(of_default) +
                            " is set, which belongs to DEFAULT mode: leave it out, or "
                            "call setMode(DEFAULT)"
                      : std::string();
  const char* const setting = radius_                    ? "a radius"
                              : normal_radius_           ? "a normal radius"
                              : k_ && *k_ != 0           ? "k"
                              : outlier_rate_            ? "an outlier rate"
                              : has_radius_mode_         ? "a radius mode"
                              : ignore_model_parameters_ ? "setIgnoreModelParameters()"
                                                         : of_paper;
  return setting ? std::string(setting) +
                       " is set, which belongs to the paper's method: call "
                       "setMode(PAPER), or leave it out"
                 : std::string();
}

std::string
ShapeDetectionSettings::problemOfModel() const
{
  const ShapeModel model = getModel();
  if (model.classes().empty())
    return "the model has no class: add() at least one";
  if (!(threshold_ >= 0.0 && threshold_ <= 1.0))
    return "threshold is " + detail::numberText(threshold_) + ": it must be 0 to 1";
  if (model_ && mode_ == PAPER && !ignore_model_parameters_) {
    const std::string disagreement = model.disagreement(getParameters());
    if (!disagreement.empty())
      return disagreement + ": leave the setting out, make a model with it, or call "
                            "setIgnoreModelParameters(true)";
  }
  return problemOfClasses(model);
}

std::vector<EdgeType>
detail::edgeTypesOf(const ShapeField& field, double threshold, unsigned threads)
{
  if (!field.base)
    return edgeTypes(field, threshold, threads);
  return gathered(
      edgeTypes(*field.base, threshold, threads), field.base_points, EdgeType::None);
}

} // namespace pcl

PCL_INSTANTIATE_PRODUCT(ShapeDetection, (PCL_SHAPE_POINT_TYPES)(PCL_SHAPE_NORMAL_TYPES))
PCL_INSTANTIATE_PRODUCT(ShapeBackProjection,
                        (PCL_SHAPE_POINT_TYPES)(PCL_SHAPE_NORMAL_TYPES))
PCL_INSTANTIATE_PRODUCT(ShapeEdgeDetection,
                        (PCL_SHAPE_POINT_TYPES)(PCL_SHAPE_NORMAL_TYPES))
