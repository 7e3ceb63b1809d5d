// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Loops over indices, or parts of a range, on several threads.

#pragma once

#include <pcl/features/cancellation.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <omp.h>
#include <vector>

namespace pcl::kernels {

/** \brief 0 stands for all cores. */
inline unsigned
threadCount(unsigned threads)
{
  return threads == 0 ? static_cast<unsigned>(omp_get_num_procs()) : threads;
}

/** \brief body(i) for i in [0, count) on `threads` threads (0: all cores). The first
 * exception is thrown again after the loop: none may leave a parallel region. If the
 * scope of the calling thread is canceled, the rest is left out, and Canceled thrown.
 */
template <typename Body>
void
parallelFor(std::size_t count, unsigned threads, const Body& body)
{
  std::exception_ptr error;
  const std::atomic<bool>* const flag = cancellationFlag();
  const auto isCanceled = [flag] {
    return flag && flag->load(std::memory_order_relaxed);
  };
  // A team for a few tasks would cost more than they do.
  const std::size_t team = std::clamp<std::size_t>(count, 1, threadCount(threads));
#pragma omp parallel for schedule(dynamic) num_threads(static_cast <int>(team))
  for (std::ptrdiff_t i = 0; i < static_cast<std::ptrdiff_t>(count); ++i) {
    if (isCanceled())
      continue;
    try {
      body(static_cast<std::size_t>(i));
    }
    catch (...) {
#pragma omp critical(pcl_shape_parallel_error)
      if (!error)
        error = std::current_exception();
    }
  }
  if (error)
    std::rethrow_exception(error);
  if (isCanceled())
    throw Canceled();
}

/** \brief body(begin, end) for consecutive parts of [0, count). */
template <typename Body>
void
parallelForRanges(std::size_t count, unsigned threads, const Body& body)
{
  constexpr std::size_t part = 8192; // little for a thread, much for its start
  parallelFor((count + part - 1) / part, threads, [&](std::size_t i) {
    body(i * part, std::min(count, (i + 1) * part));
  });
}

/** \brief body(i) for i in [0, count), many at a time: for short bodies. */
template <typename Body>
void
parallelForEach(std::size_t count, unsigned threads, const Body& body)
{
  parallelForRanges(count, threads, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
      body(i);
  });
}

/** \brief What add(i, items) adds for i in [0, count), in this order. */
template <typename Item, typename Add>
std::vector<Item>
collectForEach(std::uint32_t count, unsigned threads, const Add& add)
{
  constexpr std::size_t part = 8192;
  std::vector<std::vector<Item>> of_parts((count + part - 1) / part);
  parallelFor(of_parts.size(), threads, [&](std::size_t p) {
    const auto end =
        static_cast<std::uint32_t>(std::min<std::size_t>(count, (p + 1) * part));
    for (auto i = static_cast<std::uint32_t>(p * part); i < end; ++i)
      add(i, of_parts[p]);
  });
  std::size_t size = 0;
  for (const std::vector<Item>& of_part : of_parts)
    size += of_part.size();
  std::vector<Item> items;
  items.reserve(size);
  for (std::vector<Item>& of_part : of_parts) {
    items.insert(items.end(), of_part.begin(), of_part.end());
    of_part = {};
  }
  return items;
}

} // namespace pcl::kernels
