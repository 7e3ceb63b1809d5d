// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// The posteriors of the classes of surfaces, by back-projection inside the faces.

#include "surfaces/surface_classification.h"

#include "common/finite.h"
#include "common/gathered.h"
#include "common/statistics.h"
#include "features/models/class_evidence.h"
#include "surfaces/evidence_averaging.h"

#include <pcl/features/distinct_points.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace pcl::detail {
namespace {

using namespace segmentation;

/** The evidence of each class at the points wanted, by their INAD and that of others on
 * their faces: logarithms of densities, NaN unknown. */
std::vector<float>
evidenceOfModel(const FieldInput& input,
                const ShapeField& field,
                const ShapeModel& model,
                const std::vector<std::uint32_t>& known,
                const std::vector<std::uint32_t>& wanted)
{
  const pcl::Indices points = evidencePoints(input, field, known);
  const INADParameters radii = withNoise(model.parameters(), field.noise_level);
  const NeededPoints needed = neededPoints(input, field, points, wanted, radii.radius);
  const std::vector<float> inad = adaptiveINADAmong(
      gathered(points, needed.points), needed.evidence, input, field.spacings, radii);
  const ShapeEvidence densities(model);
  std::vector<float> evidence(points.size() * densities.classes(),
                              std::numeric_limits<float>::quiet_NaN());
  for (std::size_t k = 0; k < needed.evidence.size(); ++k) {
    const auto point = needed.points[static_cast<std::size_t>(needed.evidence[k])];
    densities.logDensities(
        inad[2 * k], inad[2 * k + 1], &evidence[point * densities.classes()]);
  }
  return averageEvidence(input, field, points, evidence, densities.classes(), wanted);
}

/** Whether the classes are those that the bend of a face decides between. */
bool
arePlanarAndCurved(const ShapeModel& model)
{
  const auto& classes = model.classes();
  return classes.size() == 2 && classes[0].name == "planar" &&
         classes[1].name == "curved";
}

/** Each point's own, or for a point of a face the one that stands for its node. */
std::vector<std::uint32_t>
pointsOfNodes(const FacePyramid& faces, const std::vector<std::uint32_t>& known)
{
  std::vector<std::uint32_t> points = faces.point_of_node;
  for (const std::uint32_t i : known)
    if (faces.node_of_point[i] == FacePyramid::none)
      points.push_back(i);
  return points;
}

/** For each point by how much the model is for curved; NaN unknown. */
std::vector<float>
differencesAt(const FieldInput& input,
              const ShapeField& field,
              const FacePyramid& faces,
              const std::vector<float>& of_model)
{
  std::vector<float> differences;
  differences.reserve(input.points.size);
  for (std::size_t i = 0; i < input.points.size; ++i) {
    const std::uint32_t node = faces.node_of_point[i];
    const std::size_t from = node == FacePyramid::none ? i : faces.point_of_node[node];
    const float difference = of_model[2 * from + 1] - of_model[2 * from];
    // In a sparse place too few points stand for others: no evidence.
    const bool is_sparse =
        std::isnan(difference) && kernels::isFinite(field.normals[i].data());
    differences.push_back(is_sparse ? 0.0f : difference);
  }
  return differences;
}

/** The evidence of planar and curved: that of the model, and of how faces bend. */
std::vector<float>
evidenceWithFaces(const FieldInput& input,
                  const ShapeField& field,
                  const ShapeModel& model,
                  const std::vector<std::uint32_t>& known)
{
  const float spacing = spacingOfCloud(input, field.spacings);
  FacePyramid faces = firstFaces(input.points, field, spacing, input.threads);
  if (faces.levels.empty())
    return evidenceOfModel(input, field, model, known, known);
  addLevels(face_levels, faces, input.threads);
  const FaceEvidence of_faces =
      evidenceOfFaces(input.points,
                      faces,
                      faceEvidence(faces, spacing, input.threads),
                      spacing,
                      input.threads);
  std::vector<std::uint32_t> wanted = pointsOfNodes(faces, known);
  wanted.erase(
      std::remove_if(wanted.begin(),
                     wanted.end(),
                     [&](std::uint32_t i) { return isSurelyFlat(of_faces, i); }),
      wanted.end());
  const std::vector<float> of_model =
      evidenceOfModel(input, field, model, known, wanted);
  return joinedEvidence(differencesAt(input, field, faces, of_model), of_faces);
}

} // namespace

std::vector<float>
modelDifferences(const FieldInput& input,
                 const ShapeField& field,
                 const ShapeModel& model,
                 const FacePyramid& faces)
{
  const std::vector<std::uint32_t> known = knownPoints(input, field);
  return differencesAt(
      input,
      field,
      faces,
      evidenceOfModel(input, field, model, known, pointsOfNodes(faces, known)));
}

double
modelReach(const CloudNumbers& numbers,
           const ShapeModel& model,
           double edge_reach,
           double normal_reach)
{
  const double most = mostSpacing(numbers.distance);
  const INADParameters radii = withNoise(model.parameters(), numbers.noise_level);
  const double choice = evidencePointReach(numbers.spacing);
  // Which points stand for others depends on where the field has normals.
  const double normal = std::max(
      {radii.normal_radius * most, spacingReach(numbers.distance), normal_reach});
  const double inad = radii.radius * most + choice + normal;
  return averagingReach(numbers.spacing, most) + choice + std::max(inad, edge_reach);
}

std::vector<float>
joinedEvidence(const std::vector<float>& of_model, const FaceEvidence& of_faces)
{
  // Waves and near creases look curved to the model: it decides where the bend of a
  // face is in doubt, and may not overrule clear evidence of it by itself. That it sees
  // none says little: it looks no farther than 7 spacings. For the same reason it has
  // nothing to add for curved where a large window is flat; where that is all around,
  // nothing at all.
  constexpr float model_weight = 0.6f;
  constexpr float min_of_model = -2.0f;
  constexpr float max_of_model = 4.8f;
  std::vector<float> evidence(2 * of_model.size(),
                              std::numeric_limits<float>::quiet_NaN());
  for (std::size_t i = 0; i < of_model.size(); ++i) {
    const float difference = of_model[i];
    if (std::isnan(difference))
      continue;
    evidence[2 * i] = 0.0f;
    if (std::isnan(of_faces.curved[i])) {
      evidence[2 * i + 1] = difference;
      continue;
    }
    evidence[2 * i + 1] = of_faces.curved[i];
    if (isSurelyFlat(of_faces, i))
      continue;
    const float most = max_of_model * (1.0f - of_faces.flat[i]);
    evidence[2 * i + 1] += std::clamp(model_weight * difference, min_of_model, most);
  }
  return evidence;
}

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

void
classifySurfaces(const FieldInput& input, const ShapeModel& model, ShapeField& field)
{
  const std::size_t classes = model.classes().size();
  const std::vector<std::uint32_t> known = knownPoints(input, field);
  std::vector<float> values = arePlanarAndCurved(model)
                                  ? evidenceWithFaces(input, field, model, known)
                                  : evidenceOfModel(input, field, model, known, known);
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
  // Across the largest windows, 50 spacings in radius, 350 turns by 16 degrees.
  constexpr float curved_spacings = 300.0f;
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
