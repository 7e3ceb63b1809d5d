// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Labels for training: the likeliest one of each point, what speaks for it, and its
// confidence.

#pragma once

#include <pcl/segmentation/shape_labeling.h>

#include <array>
#include <cstdint>
#include <vector>

namespace pcl::detail {

/** \brief What labels are made of. */
struct LabelInput {
  const ShapeField& field;
  unsigned threads = 0;
  std::uint32_t planar_label = 0; ///< of the class "planar", 0 without one
};

/** \brief Numbers that speak for a label, the larger the more.
 *
 * Of a surface: logarithm of its posterior over the next best; distance to the nearest
 * edge point; how evenly the neighbors lie around the point; how well normals that turn
 * evenly explain those around (logarithm); 1 if it is planar, the commonest. Of an
 * edge: places around, near and wider, that votes for a crease agree on (logarithms);
 * how much the normals turn (logarithm); how far the neighbors' mean is off the point;
 * and 0. See doc/labels.md. */
using LabelFeatures = std::array<float, 5>;

/** \brief The likeliest label of each point, and what speaks for it. */
struct LabelEvidence {
  std::vector<std::uint32_t> labels; ///< 0 unknown; edges after the other classes
  std::vector<LabelFeatures> features;
};

PCL_SHAPE_EXPORTS LabelEvidence labelEvidence(const LabelInput& input);

/** \brief The likeliest labels with their confidence; those with less than `confidence`
 * are void. */
PointLabels labelPoints(const LabelInput& input, double confidence);

} // namespace pcl::detail
