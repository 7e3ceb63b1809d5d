// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// How far the pieces of faces are whose evidence a point takes.

#pragma once

#include <pcl/features/cloud_numbers.h>

namespace pcl {

/** \brief Along each axis, from a point to the means of the pieces, meters. */
double evidenceReach(const CloudNumbers& numbers);

} // namespace pcl
