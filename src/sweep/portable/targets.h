// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// The instruction sets that kernels are compiled for, and the one in use.

#pragma once

#include "sweep/sweep_block.h"

#include <pcl/pcl_shape_exports.h>

#include <string>
#include <vector>

namespace pcl::kernels {

/** \brief Instruction sets that this build has kernels for and this processor can run,
 * the fastest first: of "avx3" (AVX-512), "avx2", "sse4", "neon", "portable". */
PCL_SHAPE_EXPORTS std::vector<std::string> availableTargets();

/** \brief Use one of availableTargets() from now on, for tests and benchmarks; the
 * fastest for an empty name. Not while something is being computed.
 * \throws std::invalid_argument if the target is not available */
PCL_SHAPE_EXPORTS void chooseTarget(const std::string& name);

/** \brief The kernels of the target in use. */
const KernelTable& chosenKernels();

/** \brief An instruction set and its kernels. */
struct Target {
  const char* name;
  const KernelTable* kernels;
};

/** \brief The SIMD targets of this build that this processor has, the fastest first. */
std::vector<Target> simdTargets();

} // namespace pcl::kernels
