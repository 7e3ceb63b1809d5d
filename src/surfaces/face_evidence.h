// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Whether a face bends by more than its noise explains, at any scale.

#pragma once

#include "geometry/point_grid.h"
#include "surfaces/face_noise.h"

#include <pcl/features/cloud_numbers.h>

#include <vector>

namespace pcl::segmentation {

// Windows of the fifth level are 53 spacings in radius without noise.
constexpr std::size_t face_levels = 5;

/** \brief How far a window reaches from a node. \param[in] cell of its level
 * \param[in] spacing of the node */
double windowRadius(double cell, double spacing);

/** \brief How the windows of the nodes of a level that are wanted bend; of the first
 * two levels one for each node of the next. \param[in] threads 0 for all cores */
FaceFits fitsOf(const FacePyramid& pyramid,
                std::size_t of_level,
                const std::vector<bool>& wanted,
                unsigned threads);

/** \brief What windows say of nodes, or of points. */
struct FaceEvidence {
  /** For curved against planar: the logarithm of a ratio, from -4 to 4; NaN where no
   * window tells. */
  std::vector<float> curved;
  /** How much of what is around is in a large flat window, from 0 to 1; NaN where
   * curved is, too. */
  std::vector<float> flat;
};

/** \brief Whether a point or node is planar whatever its INAD: all around it is in
 * large flat windows, and no window bends. */
inline bool
isSurelyFlat(const FaceEvidence& evidence, std::size_t i)
{
  return evidence.flat[i] == 1.0f && evidence.curved[i] <= 0.0f;
}

/** \brief The evidence of each node of the first level. See doc/method.md.
 * \param[in] pyramid with levels \param[in] spacing of the cloud, median \param[in]
 * threads 0 for all cores */
FaceEvidence faceEvidence(const FacePyramid& pyramid, float spacing, unsigned threads);

/** \brief The same with what fitsOf() and noiseOfCloud() say of each level. */
FaceEvidence faceEvidence(const FacePyramid& pyramid,
                          std::vector<FaceFits> fits,
                          const std::vector<float>& noise_of_cloud,
                          float spacing,
                          unsigned threads);

/** \brief How far the pieces of faces are whose evidence a point takes: along each
 * axis, from the point to their means, meters. */
double evidenceReach(const CloudNumbers& numbers);

/** \brief The evidence at each point. A point of an edge takes that of the nearest
 * face. \param[in] of_nodes see faceEvidence() \param[in] spacing median
 * \param[in] threads 0 for all cores \return NaN unknown */
FaceEvidence evidenceOfFaces(const XYZView& points,
                             const FacePyramid& faces,
                             const FaceEvidence& of_nodes,
                             float spacing,
                             unsigned threads);

} // namespace pcl::segmentation
