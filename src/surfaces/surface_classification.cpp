// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// The posteriors of the classes of surfaces, by back-projection inside the faces.

#include "surfaces/surface_classification.h"

#include "common/parallel.h"
#include "common/statistics.h"
#include "features/class_evidence.h"
#include "surfaces/evidence_averaging.h"

#include <pcl/features/distinct_points.h>

#include <algorithm>
#include <cmath>

namespace pcl::detail {
namespace {

using namespace segmentation;

/** The evidence of each class at each point: logarithms of densities, NaN unknown. */
std::vector<float>
evidenceOf(const FieldInput& input, const ShapeField& field, const ShapeModel& model)
{
  const INADParameters parameters = withNoise(model.parameters(), field.noise_level);
  const std::vector<float> inad =
      adaptiveINAD(input, field.spacings, parameters).mu_sigma;
  const ShapeEvidence densities(model);
  std::vector<float> evidence(input.points.size * densities.classes());
  kernels::parallelForRanges(
      input.points.size, input.threads, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i)
          densities.logDensities(
              inad[2 * i], inad[2 * i + 1], &evidence[i * densities.classes()]);
      });
  return evidence;
}

/** Posteriors in the place of evidence, by Bayes' rule. */
void
toPosteriors(const ShapeModel& model, std::vector<float>& values)
{
  const std::size_t classes = model.classes().size();
  for (std::size_t i = 0; i < values.size(); i += classes) {
    float* of_point = &values[i];
    for (std::size_t c = 0; c < classes; ++c)
      of_point[c] += static_cast<float>(std::log(model.classes()[c].prior));
    const float most = *std::max_element(of_point, of_point + classes);
    float sum = 0.0f;
    for (std::size_t c = 0; c < classes; ++c)
      sum += of_point[c] = std::exp(of_point[c] - most);
    for (std::size_t c = 0; c < classes; ++c)
      of_point[c] /= sum;
  }
}

} // namespace

void
classifySurfaces(const FieldInput& input, const ShapeModel& model, ShapeField& field)
{
  const std::size_t classes = model.classes().size();
  std::vector<float> values =
      averageEvidence(input, field, evidenceOf(input, field, model), classes);
  toPosteriors(model, values);
  field.likelihoods.assign(classes, std::vector<float>(input.points.size));
  for (std::size_t c = 0; c < classes; ++c) {
    field.classes.push_back(model.classes()[c].name);
    for (std::size_t i = 0; i < input.points.size; ++i)
      field.likelihoods[c][i] = values[classes * i + c];
  }
}

} // namespace pcl::detail

float
pcl::largestCurvedRadius(const ShapeField& field)
{
  constexpr float curved_spacings = 20.0f; // see doc/method.md
  std::vector<float> spacings = field.spacings;
  if (field.base) { // each place counts once
    const DistinctPoints distinct = distinctPoints(field.points);
    for (std::size_t k = 0; k < distinct.first.size(); ++k)
      spacings[k] = field.spacings[static_cast<std::size_t>(distinct.first[k])];
    if (distinct.hasRepeats())
      spacings.resize(distinct.first.size());
  }
  spacings = segmentation::finiteOf(std::move(spacings));
  return spacings.empty() ? 0.0f
                          : curved_spacings * segmentation::median(std::move(spacings));
}
