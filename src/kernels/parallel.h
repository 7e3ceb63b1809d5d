/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * Point Cloud Library (PCL) - www.pointclouds.org
 * Copyright (c) 2026, pcl_shape contributors
 *
 * All rights reserved
 */

#pragma once

#include <cstddef>
#include <exception>
#include <omp.h>

namespace pcl {
namespace kernels {

/** \brief body(i) for i in [0, count) on `threads` threads (0: all cores). The first
 * exception is thrown again after the loop: none may leave a parallel region. */
template <typename Body>
void
parallelFor(std::size_t count, unsigned threads, const Body& body)
{
  std::exception_ptr error;
  const int team = threads == 0 ? omp_get_num_procs() : static_cast<int>(threads);
#pragma omp parallel for schedule(dynamic) num_threads(team)
  for (std::ptrdiff_t i = 0; i < static_cast<std::ptrdiff_t>(count); ++i) {
    try {
      body(static_cast<std::size_t>(i));
    }
    catch (...) {
#pragma omp critical(pcl_shape_parallel_error)
      if (!error) {
        error = std::current_exception();
      }
    }
  }
  if (error) {
    std::rethrow_exception(error);
  }
}

} // namespace kernels
} // namespace pcl
