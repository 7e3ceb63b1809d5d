// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Whether a launcher of MPI has started this process.

#pragma once

#include <algorithm>
#include <array>
#include <cstdlib>

namespace pcl::app {

/** \brief By the environment that Open MPI, MPICH and Slurm's PMI give to the processes
 * they start. */
inline bool
isStartedByMpi()
{
  constexpr std::array<const char*, 3> names{
      "OMPI_COMM_WORLD_RANK", "PMI_RANK", "PMIX_RANK"};
  return std::any_of(
      names.begin(), names.end(), [](const char* name) { return std::getenv(name); });
}

} // namespace pcl::app
