// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// The truth about a point of a machined part.

#pragma once

#include "scene/creases.h"
#include "scene/part_samples.h"

namespace pcl::scene {

/** \brief Says what PartSamples says of points of a part. */
class PartTruth {
public:
  explicit PartTruth(const Part& part);

  /** \brief Add all but the coordinates of a point.
   * \param[in] spacing of the points around it */
  void add(const SurfacePoint& at, double spacing, PartSamples& samples) const;

private:
  bool isNearTightCurve(const Vec3& p, double spacing) const;
  Surface surfaceOf(const SurfacePoint& at,
                    const Vec3& normal,
                    double radius_s,
                    double spacing) const;

  const Part& part_;
  World world_;
  Creases creases_;
  ThinPlaces seams_;
};

} // namespace pcl::scene
