// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Checks the arguments of an INAD computation.

#pragma once

#include "common/number_text.h"

#include <cmath>
#include <stdexcept>
#include <string>

namespace pcl {

/** \throws std::invalid_argument unless there is a normal for each surface point and
 * the rate is 0 or positive and finite */
inline void
checkINADInput(std::size_t surface, std::size_t normals, double outlier_rate)
{
  if (normals != surface) {
    throw std::invalid_argument(std::to_string(normals) + " normals for " +
                                std::to_string(surface) + " surface points");
  }
  if (!(outlier_rate >= 0.0) || !std::isfinite(outlier_rate)) {
    throw std::invalid_argument("outlier rate " + detail::numberText(outlier_rate) +
                                ": it must be 0 (no rejection) or positive");
  }
}

} // namespace pcl
