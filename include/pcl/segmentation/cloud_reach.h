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
#include <pcl/features/shape_model.h>
#include <pcl/pcl_shape_exports.h>

namespace pcl {

/** \brief How far, in meters, the default method looks from a point: what is farther
 * makes no difference to its values. \ingroup segmentation */
struct CloudReach {
  double spacing = 0.0; ///< for its local spacing
  double noise = 0.0;   ///< for what PartOfCloud::measureNoise() measures there
  double normals = 0.0; ///< for the normals of PartOfCloud::normals()
  double edges = 0.0;   ///< for its edge likelihood
  double types = 0.0;   ///< for the kind of its edge
  double faces = 0.0;   ///< for its piece of a face, see facesOfPart()
  /** \brief To the first points of the pieces that its surface is decided by, along
   * each axis, see FacesAround. */
  double surfaces = 0.0;
};

/** \brief The sums of doc/tiles.md. For noise, any noise is taken as possible. */
PCL_SHAPE_EXPORTS CloudReach reachOf(const CloudNumbers& numbers,
                                     const ShapeModel& edge_model);

} // namespace pcl
