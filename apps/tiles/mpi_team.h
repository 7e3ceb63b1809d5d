// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// The ranks of MPI as a team.

#pragma once

#include <pcl/tiling/team.h>

#include <memory>

namespace pcl::app {

/** \brief The ranks. Call it only if a launcher of MPI has started this process.
 * \throws InputError if this program was built without MPI */
std::unique_ptr<pcl::tiling::Team> mpiTeam();

/** \brief End all ranks with a nonzero status, because one of them cannot go on. Does
 * nothing without MPI. */
void endMpi(int status);

} // namespace pcl::app
