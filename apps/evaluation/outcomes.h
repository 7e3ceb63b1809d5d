// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// PURPOSE

#pragma once

#include "evaluation/evaluation_tasks.h"

#include <cstdint>
#include <vector>

namespace pcl::app {

/** \brief What became of a point, for the first class of a task. */
enum class Outcome : std::uint32_t {
  left_out = 0,
  rightly_not = 1,
  hit = 2,
  miss = 3,
  false_alarm = 4
};

/** \brief The field "outcome" of all points of the cloud, as numbers.
 * \param[in] selected with a class \param[in] points of the cloud */
std::vector<std::uint32_t> outcomesOf(const TaskPoints& selected, std::size_t points);

} // namespace pcl::app
