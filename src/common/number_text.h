// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// A number as text for messages.

#pragma once

#include <cmath>
#include <sstream>
#include <string>

namespace pcl::detail {

/** \brief As people write it: 1e-09 is not 0.000000. */
inline std::string
numberText(double value)
{
  std::ostringstream text;
  text << value;
  return text.str();
}

/** \brief A positive number in two digits, so that people can give it again. */
inline double
twoDigits(double value)
{
  const double scale = std::pow(10.0, 1.0 - std::floor(std::log10(value)));
  return std::round(value * scale) / scale;
}

} // namespace pcl::detail
