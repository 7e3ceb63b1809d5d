// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Quantiles and differences of lists of numbers.

#include "measure.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

double
quantile(std::vector<double> values, double share)
{
  if (values.empty())
    return 0.0;
  const auto at =
      static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), values.begin() + at, values.end());
  return values[static_cast<std::size_t>(at)];
}

std::vector<double>
differences(const std::vector<float>& a, const std::vector<float>& b)
{
  std::vector<double> result;
  for (std::size_t i = 0; i < a.size(); ++i)
    if (!std::isnan(a[i]) && !std::isnan(b[i]))
      result.push_back(std::abs(double{a[i]} - b[i]));
  return result;
}
