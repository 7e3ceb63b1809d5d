// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// The best one-to-one matching of two sets.

#pragma once

#include <cstddef>
#include <optional>
#include <vector>

namespace pcl::app {

/** \brief For each row its column in the matching with the largest sum of gains, each
 * column at most once (Kuhn, "The Hungarian method for the assignment problem", 1955).
 * With fewer columns than rows, some rows have none.
 * \param[in] gains rows of equal length, at least 0 */
std::vector<std::optional<std::size_t>>
bestAssignment(const std::vector<std::vector<double>>& gains);

} // namespace pcl::app
