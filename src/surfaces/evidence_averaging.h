// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Averages of evidence over a surface that do not cross its edges.

#pragma once

#include "features/adaptive_inad.h"

#include <pcl/segmentation/shape_field.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace pcl::segmentation {

/** \brief How far averageEvidence() looks from a point to those that stand for others.
 * \param[in] spacing median of the cloud */
double averagingReach(double spacing, double max_spacing);

/** \brief How far the point is, at most, that stands for one. */
double evidencePointReach(double spacing);

/** \brief The points with a place and a direction. */
std::vector<std::uint32_t> knownPoints(const detail::FieldInput& input,
                                       const ShapeField& edges);

/** \brief The points that stand for all: of the known ones in each cell of space the
 * one nearest to its middle; and those whose neighborhood was too small for the normals
 * of edges: they speak for themselves. Ascending. */
pcl::Indices evidencePoints(const detail::FieldInput& input,
                            const ShapeField& edges,
                            const std::vector<std::uint32_t>& known);

/** \brief Of some points those that averages depend on. */
struct NeededPoints {
  std::vector<std::uint32_t> points; ///< which of them; INAD needs their normals
  pcl::Indices evidence; ///< which of these have evidence that is averaged; ascending
};

/** \param[in] points those of evidencePoints() \param[in] wanted the points to average
 * at \param[in] inad_radius spacings */
NeededPoints neededPoints(const detail::FieldInput& input,
                          const ShapeField& edges,
                          const pcl::Indices& points,
                          const std::vector<std::uint32_t>& wanted,
                          double inad_radius);

/** \brief Average the evidence of each class over neighborhoods, without crossing
 * edges.
 *
 * The averages of averages at the points that stand for all reach further than one
 * neighborhood would: around corners of the surface, but not across its edges.
 * \param[in] points those of evidencePoints()
 * \param[in] evidence logarithms of densities, class by class for each of these points;
 * NaN unknown, and where neededPoints() has none \param[in] wanted the points to
 * average at
 * \return the same for all points; NaN where it was not wanted */
std::vector<float> averageEvidence(const detail::FieldInput& input,
                                   const ShapeField& edges,
                                   const pcl::Indices& points,
                                   const std::vector<float>& evidence,
                                   std::size_t classes,
                                   const std::vector<std::uint32_t>& wanted);

} // namespace pcl::segmentation
