// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Medians and other quantiles of floats, and of Student's distribution.

#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace pcl::segmentation {

/** \brief The value that a share (0 to less than 1) of some values is below; there must
 * be at least one value. */
inline float
quantile(std::vector<float> values, double share)
{
  const auto at = values.begin() + static_cast<std::ptrdiff_t>(
                                       share * static_cast<double>(values.size()));
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

/** \brief The middle one of some values, at least one; the upper one of two. */
inline float
median(std::vector<float> values)
{
  return quantile(std::move(values), 0.5);
}

inline std::vector<float>
finiteOf(std::vector<float> values)
{
  const auto is_unknown = [](float value) { return !std::isfinite(value); };
  values.erase(std::remove_if(values.begin(), values.end(), is_unknown), values.end());
  return values;
}

/** \brief What Student's t exceeds as rarely as a normal variable exceeds so many
 * deviations. Inverts the approximation of Peizer and Pratt (1968), A normal
 * approximation for binomial, F, beta, and other common, related tail probabilities,
 * within 8 % for four deviations and 4 degrees of freedom or more, 3 % from 6.
 * \param[in] freedom degrees of freedom, 4 or more */
inline double
studentDeviations(double deviations, double freedom)
{
  const double scale = freedom - 2.0 / 3.0 + 0.1 / freedom;
  const double squared =
      deviations * deviations * (freedom - 5.0 / 6.0) / (scale * scale);
  return std::sqrt(freedom * std::expm1(squared));
}

/** \brief The median of the spacings that are known, 1 if none is. */
inline float
medianSpacing(std::vector<float> spacings)
{
  spacings = finiteOf(std::move(spacings));
  return spacings.empty() ? 1.0f : median(std::move(spacings));
}

} // namespace pcl::segmentation
