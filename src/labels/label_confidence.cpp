// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// PURPOSE

#include "labels/label_weights.h"

#include "labels/label_evidence.h"

#include <algorithm>
#include <cmath>

namespace pcl::detail {
namespace {

using segmentation::LabelWeights;

/** Other classes are taken for curved: that asks for more. */
const LabelWeights&
weightsOf(std::uint32_t label, std::uint32_t planar_label, std::uint32_t edge_label)
{
  if (label == edge_label)
    return segmentation::edge_weights;
  return label == planar_label ? segmentation::planar_weights
                               : segmentation::curved_weights;
}

float
confidenceOf(const LabelFeatures& features, const LabelWeights& weights)
{
  double sum = weights.constant;
  for (std::size_t f = 0; f < features.size(); ++f)
    sum += weights.features[f] * static_cast<double>(features[f]);
  return static_cast<float>(1.0 / (1.0 + std::exp(-sum)));
}

} // namespace

PointLabels
labelPoints(const LabelInput& input, double confidence)
{
  LabelEvidence evidence = labelEvidence(input);
  const auto edge_label =
      static_cast<std::uint32_t>(input.field.likelihoods.size() + 1);
  PointLabels result{std::move(evidence.labels), {}};
  result.confidence.resize(result.labels.size(), 0.0f);
  for (std::size_t i = 0; i < result.labels.size(); ++i) {
    if (result.labels[i] == 0)
      continue;
    result.confidence[i] =
        confidenceOf(evidence.features[i],
                     weightsOf(result.labels[i], input.planar_label, edge_label));
    if (result.confidence[i] < confidence)
      result.labels[i] = 0;
  }
  return result;
}

} // namespace pcl::detail
