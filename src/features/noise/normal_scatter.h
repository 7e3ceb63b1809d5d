// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// How far normals differ around some points of a cloud.

#pragma once

#include "features/spacing/points_near.h"
#include "geometry/point_grid.h"

#include <pcl/types.h>
#include <pcl/features/impl/neighborhoods.hpp>

#include <optional>
#include <vector>

namespace pcl::detail {

/** \brief Measures how far normals differ around some points of a cloud. */
class NormalScatter {
public:
  /** \param[in] neighborhoods of all points of the cloud among themselves
   * \param[in] spacings one for each point
   * \param[in] chosen the points, in ascending order
   * \param[in] most_radius the largest within which normals are compared, spacings */
  NormalScatter(const Neighborhoods& neighborhoods,
                const std::vector<float>& spacings,
                pcl::Indices chosen,
                double most_radius,
                unsigned threads);

  /** \brief The mean angle between a point's normal and those within a radius, radians;
   * NaN where no neighbor has a normal. \param[in] normal_radius of the normals,
   * spacings \param[in] radius within which they are compared, spacings */
  std::vector<float> operator()(double normal_radius, double radius) const;

private:
  struct Needed {
    pcl::Indices points;
    pcl::Indices chosen; ///< where the chosen ones are among them
  };

  Needed neededFor(const std::vector<float>& radii) const;
  std::vector<float> radiiOf(const pcl::Indices& points, double count) const;

  const Neighborhoods& neighborhoods_;
  const std::vector<float>& spacings_;
  pcl::Indices chosen_;
  std::optional<PointsNear> near_; ///< whose normals may be needed, and others
  std::optional<segmentation::PointGrid> grid_; ///< of these, if any
};

} // namespace pcl::detail
