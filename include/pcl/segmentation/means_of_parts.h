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
#include <pcl/pcl_shape_exports.h>

#include <cstdint>
#include <string>
#include <vector>

namespace pcl {

/** \brief The voxel means that stand for the places of a part of a cloud, see
 * ShapeFieldEstimation::setResolution(). \ingroup segmentation */
struct MeansOfPart {
  std::vector<float> means; ///< three coordinates each
  std::vector<bool> is_own; ///< of the part: each mean of the cloud is of one part
};

/** \param[in] places no two of them equal; of the voxels of the part's own places they
 * must be all \param[in] is_own which places are the part's own
 * \param[in] resolution size of a voxel, meters */
PCL_SHAPE_EXPORTS MeansOfPart meansOfPart(const XYZView& places,
                                          const std::vector<bool>& is_own,
                                          double resolution);

/** \brief For each point the mean that it has the values of, or -1. \param[in] points
 * of a part \param[in] means of the cloud, those near the points \param[in] spacings
 * the local spacing of each mean \param[in] resolution size of a voxel, meters
 * \param[in] threads 0 for all cores */
PCL_SHAPE_EXPORTS std::vector<std::int32_t> nearestMeans(const XYZView& points,
                                                         const XYZView& means,
                                                         std::vector<float> spacings,
                                                         double resolution,
                                                         unsigned threads);

/** \brief How far a point's mean may be, meters. \param[in] distance the
 * CloudNumbers::distance of the means \param[in] resolution size of a voxel, meters */
PCL_SHAPE_EXPORTS double reachOfMeans(double distance, double resolution);

/** \brief The resolution that the default method goes on to where neighbors share noise
 * beyond what radii can grow for, meters; 0 where they do not, where there are too few
 * places for a coarser one, or where they fill a volume.
 * \param[in] numbers of the places: points, or means at a resolution
 * \param[in] places how many finite ones there are
 * \param[in] resolution that the places are means at, 0 for points */
PCL_SHAPE_EXPORTS double
coarserResolution(const CloudNumbers& numbers, std::uint64_t places, double resolution);

/** \brief What is wrong with a resolution; empty if nothing is. \param[in] resolution
 * size of a voxel, meters \param[in] corners the two of the box that holds the cloud,
 * three coordinates each */
PCL_SHAPE_EXPORTS std::string problemOfResolution(double resolution,
                                                  const std::vector<float>& corners);

} // namespace pcl
