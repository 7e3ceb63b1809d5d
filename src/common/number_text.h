// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// A number as text for messages.

#pragma once

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

} // namespace pcl::detail
