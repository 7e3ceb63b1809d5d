// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Labels of a field: their names, and what is refused.

#include "common/number_text.h"
#include "labels/label_evidence.h"
#include "segmentation/compiled_estimations.h"
#include "segmentation/field_places.h"

#include <pcl/segmentation/impl/shape_labeling.hpp>

#include <algorithm>
#include <cmath>

namespace pcl::detail {
namespace {

const char* const edge_class = "edge";
const char* const planar_class = "planar";

} // namespace

std::vector<std::string>
labelNames(std::vector<std::string> classes)
{
  classes.emplace_back(edge_class);
  return classes;
}

std::string
problemOfLabels(const std::vector<std::string>& classes, double confidence)
{
  if (!(confidence >= 0.0 && confidence <= 1.0))
    return "confidence is " + numberText(confidence) + ": it must be 0 to 1";
  if (classes.size() == 1)
    return "the field has no classes: it was made for edges only";
  if (std::count(classes.begin(), classes.end(), edge_class) > 1)
    return "the model has a class 'edge': edges are a class of their own, use another "
           "name";
  return {};
}

PointLabels
labelsOf(const ShapeField& field, double confidence, unsigned threads)
{
  const auto planar =
      std::find(field.classes.begin(), field.classes.end(), planar_class);
  const auto label =
      planar == field.classes.end()
          ? 0
          : static_cast<std::uint32_t>(planar - field.classes.begin() + 1);
  const FieldPlaces places(field);
  const PointLabels of_places =
      labelPoints({places.field(), threads, label}, confidence);
  if (!places.hasRepeats())
    return of_places;
  PointLabels labels;
  for (std::size_t i = 0; i < field.points.size; ++i) {
    // With indices some points of a place may be unknown, whatever the others are.
    const bool is_known = !std::isnan(field.edge_likelihood[i]);
    const std::size_t place = places.placeOf(i);
    labels.labels.push_back(is_known ? of_places.labels[place] : 0);
    labels.confidence.push_back(is_known ? of_places.confidence[place] : 0.0f);
  }
  return labels;
}

} // namespace pcl::detail

PCL_INSTANTIATE(ShapeLabeling, PCL_SHAPE_POINT_TYPES)
