// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// The posteriors of the classes of surfaces, by back-projection inside the faces.

#pragma once

#include "features/adaptive_inad.h"
#include "surfaces/face_evidence.h"

#include <pcl/features/shape_model.h>
#include <pcl/segmentation/shape_field.h>

namespace pcl::detail {

/** \brief Set the classes and their posteriors. See doc/method.md for the steps.
 * \param[in,out] field with its edges, which evidence does not cross */
void
classifySurfaces(const FieldInput& input, const ShapeModel& model, ShapeField& field);

/** \brief For each point by how much the model is for curved, as a logarithm of a
 * ratio; NaN unknown. \param[in] faces the first level \param[in] model of planar and
 * curved */
std::vector<float> modelDifferences(const FieldInput& input,
                                    const ShapeField& field,
                                    const ShapeModel& model,
                                    const segmentation::FacePyramid& faces);

/** \brief How far it looks from a point of a face, or of none. \param[in] edge_reach
 * how far the field's edges look \param[in] normal_reach how far its normals */
double modelReach(const CloudNumbers& numbers,
                  const ShapeModel& model,
                  double edge_reach,
                  double normal_reach);

/** \brief The evidence of planar and curved of each point, from both kinds. Where no
 * face tells, the model decides alone. \param[in] of_faces NaN unknown */
std::vector<float> joinedEvidence(const std::vector<float>& of_model,
                                  const segmentation::FaceEvidence& of_faces);

/** \brief Posteriors in the place of evidence, by Bayes' rule. */
void toPosteriors(const ShapeModel& model, std::vector<float>& values);

} // namespace pcl::detail
