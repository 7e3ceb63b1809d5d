// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// The noise of a part of a cloud, however its spacings are found.

#pragma once

#include "features/spacing/points_near.h"

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
