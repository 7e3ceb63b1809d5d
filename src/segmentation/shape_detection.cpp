// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// PURPOSE

#include "common/number_text.h"
#include "common/point_types.h"

#include <pcl/impl/instantiate.hpp>
#include <pcl/segmentation/impl/shape_back_projection.hpp>
#include <pcl/segmentation/impl/shape_edge_detection.hpp>
#include <pcl/segmentation/impl/shape_labeling.hpp>

namespace pcl::detail {

std::string
problemOfModel(const ShapeModel& model,
               double threshold,
               const INADParameters* parameters)
{
  if (model.classes().empty())
    return "the model has no class: add() at least one";
  if (!(threshold >= 0.0 && threshold <= 1.0))
    return "threshold is " + numberText(threshold) + ": 0 to 1 is allowed";
  const std::string disagreement = parameters ? model.disagreement(*parameters) : "";
  return disagreement.empty()
             ? std::string()
             : disagreement + ": leave the setting out, make a model with it, or call "
                              "setIgnoreModelParameters(true)";
}

} // namespace pcl::detail

PCL_INSTANTIATE_PRODUCT(ShapeDetection, (PCL_SHAPE_POINT_TYPES)(PCL_SHAPE_NORMAL_TYPES))
PCL_INSTANTIATE_PRODUCT(ShapeBackProjection,
                        (PCL_SHAPE_POINT_TYPES)(PCL_SHAPE_NORMAL_TYPES))
PCL_INSTANTIATE_PRODUCT(ShapeEdgeDetection,
                        (PCL_SHAPE_POINT_TYPES)(PCL_SHAPE_NORMAL_TYPES))
PCL_INSTANTIATE_PRODUCT(ShapeLabeling, (PCL_SHAPE_POINT_TYPES)(PCL_SHAPE_NORMAL_TYPES))
