// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// PURPOSE

#pragma once

#include <cstddef>
#include <thread>

namespace pcl {
namespace test {

/** \brief Bytes that operator new has given and operator delete has not taken back, in
 * the whole program. */
std::ptrdiff_t heapInUse();

/** \brief The most bytes in use since the last call of resetHeapPeak(). */
std::ptrdiff_t heapPeak();

void resetHeapPeak();

/** \brief The most bytes that run() has in use at a time. It runs on a thread of its
 * own, so that buffers that threads keep are counted, too, whatever ran before. */
template <typename Run>
std::ptrdiff_t
peakBytesOf(const Run& run)
{
  const std::ptrdiff_t before = heapInUse();
  resetHeapPeak();
  std::thread(run).join();
  return heapPeak() - before;
}

} // namespace test
} // namespace pcl
