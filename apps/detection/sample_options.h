// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Which points of a sample count for which class.

#pragma once

#include "cli/arguments.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace pcl::app {

/** \brief Which points of a sample are counted, and how its class is called. */
struct SampleOptions {
  std::string name = "plane";
  std::string field; ///< empty: all points
  std::uint32_t value = 0;
  std::optional<double> prior; ///< else that of -prior, or of the model
};

/** \brief One for each class: that of -name and -value, or those of -classes.
 * \throws UsageError for a name that could not be part of a field's name, for one of
 * -field and -value without the other, or for -classes that are not
 * NAME=VALUE[:PRIOR],... */
std::vector<SampleOptions> sampleOptions(const Arguments& arguments);

} // namespace pcl::app
