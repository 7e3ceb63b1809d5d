// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Counts the memory that a part of a test or benchmark allocates.

#pragma once

#include <cstddef>
#include <thread>

namespace pcl {
namespace test {

/** \brief While it lives, counts the bytes that operator new gives and operator delete
 * takes back, in the whole program. Only one at a time. */
class HeapCount {
public:
  HeapCount();

  HeapCount(const HeapCount&) = delete;
  HeapCount& operator=(const HeapCount&) = delete;

  ~HeapCount();

  /** \brief Bytes given less bytes taken back since it began: may be negative. */
  std::ptrdiff_t inUse() const;

  /** \brief The most bytes in use since it began. */
  std::ptrdiff_t peak() const;
};

/** \brief The most bytes that run() has in use at a time. It runs on a thread of its
 * own, so that buffers that threads keep are counted, too, whatever ran before. */
template <typename Run>
std::ptrdiff_t
peakBytesOf(const Run& run)
{
  const HeapCount count;
  std::thread(run).join();
  return count.peak();
}

} // namespace test
} // namespace pcl
