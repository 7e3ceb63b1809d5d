// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// PURPOSE

#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace pcl::segmentation {

/** \brief The middle one of some values, at least one; the upper one of two. */
inline float
median(std::vector<float> values)
{
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

/** \brief The median of the spacings that are known, 1 if none is. */
inline float
medianSpacing(std::vector<float> spacings)
{
  const auto is_unknown = [](float spacing) { return !std::isfinite(spacing); };
  spacings.erase(std::remove_if(spacings.begin(), spacings.end(), is_unknown),
                 spacings.end());
  return spacings.empty() ? 1.0f : median(std::move(spacings));
}

} // namespace pcl::segmentation
