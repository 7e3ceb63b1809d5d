/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * Point Cloud Library (PCL) - www.pointclouds.org
 * Copyright (c) 2026, pcl_shape contributors
 *
 * All rights reserved
 */

#pragma once

#include <pcl/segmentation/shape_back_projection.h>

#include <array>
#include <cstdint>
#include <vector>

namespace pcl {

/** \brief A label for each point. \ingroup segmentation */
struct PointLabels {
  std::vector<std::uint32_t> labels; ///< 0 void, else the class, from 1 on
  std::vector<float> confidence;     ///< of the likeliest label, 0 to 1; 0 unknown
};

namespace detail {

/** \brief The confidence from which labels are kept: see doc/labels.md. */
constexpr double usual_confidence = 0.9;

constexpr const char* edge_class = "edge";
constexpr const char* planar_class = "planar";

/** \brief What labels are made of. */
struct LabelInput {
  XYZView points;
  const Surfaces& surfaces; ///< of all the points
  unsigned threads = 0;
  std::uint32_t planar_label = 0; ///< of the class "planar", 0 without one
};

/** \brief Numbers that speak for a label, the larger the more.
 *
 * Of a surface: logarithm of its posterior over the next best; distance to the nearest
 * edge point; how little there is of an edge around; how evenly the neighbors lie
 * around the point; the share of them with the same label. Of an edge: places around,
 * near and wider, that votes for a crease agree on (logarithms); how much the normals
 * turn (logarithm); how far the neighbors' mean is off the point; the radius that
 * normals are averaged over (logarithm). See doc/labels.md. */
using LabelFeatures = std::array<float, 5>;

/** \brief The likeliest label of each point, and what speaks for it. */
struct LabelEvidence {
  std::vector<std::uint32_t> labels; ///< 0 unknown; edges after the other classes
  std::vector<LabelFeatures> features;
};

PCL_SHAPE_EXPORTS LabelEvidence labelEvidence(const LabelInput& input);

/** \brief The likeliest labels with their confidence; those with less than `confidence`
 * are void. */
PCL_SHAPE_EXPORTS PointLabels labelPoints(const LabelInput& input, double confidence);

} // namespace detail
} // namespace pcl
