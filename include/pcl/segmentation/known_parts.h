/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * Point Cloud Library (PCL) - www.pointclouds.org
 * Copyright (c) 2026, pcl_shape contributors
 *
 * All rights reserved
 */

#pragma once

#include <pcl/features/cloud_numbers.h>
#include <pcl/features/xyz_view.h>
#include <pcl/memory.h>
#include <pcl/pcl_shape_exports.h>
#include <pcl/segmentation/shape_field.h>

#include <cstdint>
#include <vector>

namespace pcl {

/** \brief A part of a cloud whose neighbors were found before, such as a tile with what
 * is around it. \ingroup segmentation */
struct KnownPart {
  XYZView places;                ///< finite, no two equal; that is not checked
  std::vector<bool> is_measured; ///< one for each place; the others are around them
  /** \brief Of each place to its 12th neighbor in the cloud; infinite if it is beyond
   * CloudReach::spacing, see PartOfCloud::measureDistances(). */
  std::vector<float> distances;
};

/** \brief What PartOfCloud::measureNoise() measures, in a fraction of its time.
 * \param[in] part not changed \param[in] numbers with distance and spacing
 * \param[in] places how many finite ones the cloud has
 * \param[in] threads 0 for all cores
 * \throws std::invalid_argument if there is not one value for each place */
PCL_SHAPE_EXPORTS NoiseMeasures measureNoise(const KnownPart& part,
                                             const CloudNumbers& numbers,
                                             std::uint64_t places,
                                             unsigned threads);

/** \brief What ShapeFieldEstimation with setCloudNumbers() and setEdgesOnly() computes:
 * distances are not measured again, nor is it asked whether points are equal.
 * \param[in] part all places are computed, whether they are measured or not
 * \param[in] cloud what the places are of: kept by the field
 * \param[in] numbers of the whole cloud \param[in] threads 0 for all cores
 * \throws std::invalid_argument if there is not one value for each place */
PCL_SHAPE_EXPORTS ShapeField edgesOf(const KnownPart& part,
                                     const shared_ptr<const void>& cloud,
                                     const CloudNumbers& numbers,
                                     unsigned threads);

} // namespace pcl
