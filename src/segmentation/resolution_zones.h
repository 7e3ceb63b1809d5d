// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Divides a cloud whose noise grows with the spacing into zones with resolutions of
// their own.

#pragma once

#include <pcl/features/cloud_numbers.h>
#include <pcl/features/xyz_view.h>
#include <pcl/segmentation/impl/shape_field_estimation.hpp>

#include <vector>

namespace pcl::detail {

/** \brief A part of a cloud that has one resolution. */
struct ResolutionZone {
  double resolution = 0.0;   ///< meters, 0 for points
  CloudNumbers numbers;      ///< of its own points or means
  std::vector<float> points; ///< its own and those around them, three coordinates each
  std::vector<bool> is_own;  ///< of each of them
};

/** \brief Whether a cloud seems to have no noise at all where it is sparse, but has
 * some where it is dense: steps are wider there than neighborhoods. \param[in] spacings
 * one for each point, meters */
bool mayHaveZones(const XYZView& points,
                  const std::vector<float>& spacings,
                  unsigned threads);

/** \brief The zones of the request's surface, denser ones first; none if all of it has
 * the same noise, if it does not grow with the spacing, or if one resolution shows
 * nearly as much. \param[in] distances of the points to their 12th neighbors; none if
 * they are not known \param[in] coarse the resolution
 * that was chosen for all of it, meters; 0 for none */
std::vector<ResolutionZone> resolutionZones(const FieldRequest& request,
                                            const std::vector<float>& distances,
                                            double coarse);

} // namespace pcl::detail
