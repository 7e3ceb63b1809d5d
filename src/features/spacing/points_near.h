// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// The points of a cloud that are near some of them.

#pragma once

#include "common/gathered.h"

#include <pcl/features/xyz_view.h>
#include <pcl/types.h>

#include <vector>

namespace pcl::detail {

/** \brief The points within a distance of some of them, and others. */
class PointsNear {
public:
  /** \param[in] some ascending, finite
   * \param[in] cells in the distance: the more, the fewer others */
  PointsNear(const XYZView& points,
             const pcl::Indices& some,
             double reach,
             int cells,
             unsigned threads);

  XYZView
  view() const
  {
    return viewOfPositions(positions_);
  }

  /** \brief Which ones they are. */
  const pcl::Indices&
  indices() const
  {
    return indices_;
  }

  /** \brief Where those that were given are in view(). */
  const pcl::Indices&
  some() const
  {
    return some_;
  }

private:
  pcl::Indices indices_, some_;
  std::vector<float> positions_;
};

} // namespace pcl::detail
