// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// What stands for the ranks of MPI in a build without it.

#include "io/errors.h"
#include "tiles/mpi_team.h"

namespace pcl::app {

std::unique_ptr<pcl::tiling::Team>
mpiTeam()
{
  throw InputError("was built without MPI, but is started by its launcher; expected "
                   "-processes N instead, or a build with MPI");
}

void
endMpi(int)
{}

} // namespace pcl::app
