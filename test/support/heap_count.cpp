// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Counts the bytes that the test program, and the library in it, allocate.

#include "support/heap_count.h"

#include <atomic>
#include <cstdlib>
#include <malloc.h>
#include <new>

namespace {

std::atomic<bool> is_counting{false};
std::atomic<std::ptrdiff_t> in_use{0}; // what is freed may be older than the count
std::atomic<std::ptrdiff_t> max_in_use{0};

std::ptrdiff_t
sizeOf(void* p)
{
  return static_cast<std::ptrdiff_t>(malloc_usable_size(p));
}

void*
counted(void* p)
{
  if (!p)
    throw std::bad_alloc();
  if (is_counting.load(std::memory_order_relaxed)) {
    const std::ptrdiff_t now = in_use += sizeOf(p);
    std::ptrdiff_t before = max_in_use;
    while (before < now && !max_in_use.compare_exchange_weak(before, now)) {
    }
  }
  return p;
}

void
release(void* p)
{
  if (p && is_counting.load(std::memory_order_relaxed))
    in_use -= sizeOf(p);
  std::free(p);
}

} // namespace

void*
operator new(std::size_t size)
{
  return counted(std::malloc(size > 0 ? size : 1));
}

// What std::stable_sort asks for.
void*
operator new(std::size_t size, const std::nothrow_t&) noexcept
{
  void* p = std::malloc(size > 0 ? size : 1);
  return p ? counted(p) : nullptr;
}

void*
operator new(std::size_t size, std::align_val_t alignment)
{
  const auto align = static_cast<std::size_t>(alignment);
  return counted(std::aligned_alloc(align, (size / align + 1) * align));
}

void
operator delete(void* p) noexcept
{
  release(p);
}

void
operator delete(void* p, std::size_t) noexcept
{
  release(p);
}

void
operator delete(void* p, std::align_val_t) noexcept
{
  release(p);
}

void
operator delete(void* p, std::size_t, std::align_val_t) noexcept
{
  release(p);
}

namespace pcl {
namespace test {

HeapCount::HeapCount()
{
  in_use = 0;
  max_in_use = 0;
  is_counting = true;
}

HeapCount::~HeapCount() { is_counting = false; }

std::ptrdiff_t
HeapCount::inUse() const
{
  return in_use;
}

std::ptrdiff_t
HeapCount::peak() const
{
  return max_in_use;
}

} // namespace test
} // namespace pcl
