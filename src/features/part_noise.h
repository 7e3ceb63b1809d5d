// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// The noise of a part of a cloud, however its spacings are found.

#pragma once

#include "common/gathered.h"

#include <pcl/features/cloud_numbers.h>
#include <pcl/features/xyz_view.h>
#include <pcl/types.h>
#include <pcl/features/impl/neighborhoods.hpp>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace pcl::detail {

/** \throws std::invalid_argument unless there is one for each place
 * \param[in] what there is, e.g. "distances" */
void requireOneEach(std::size_t places, std::size_t count, const std::string& what);

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

/** \brief How local spacings are found. */
struct SpacingsOfPart {
  double reach = 0.0; ///< how far that looks, meters
  std::function<std::vector<float>(const PointsNear&, const Neighborhoods&)> of;
};

/** \brief See PartOfCloud::measureNoise(). */
NoiseMeasures noiseOfPart(const XYZView& places,
                          const std::vector<bool>& is_measured,
                          const SpacingsOfPart& spacings,
                          const CloudNumbers& numbers,
                          std::uint64_t places_of_cloud,
                          unsigned threads);

} // namespace pcl::detail
