// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// PURPOSE

#include "heap_counter.h"

#include <atomic>
#include <cerrno>
#include <cstdlib>
#include <malloc.h>

// Functions of the C library that do the work behind the ones replaced below.
extern "C" {
void* __libc_malloc(std::size_t);
void* __libc_calloc(std::size_t, std::size_t);
void* __libc_realloc(void*, std::size_t);
void* __libc_memalign(std::size_t, std::size_t);
void __libc_free(void*);
}

namespace {

std::atomic<bool> is_counting{false};
std::atomic<std::ptrdiff_t> in_use{0}; // what is freed may be older than the count
std::atomic<std::ptrdiff_t> peak{0};

std::ptrdiff_t
usableSize(void* p)
{
  return static_cast<std::ptrdiff_t>(malloc_usable_size(p));
}

void*
counted(void* p)
{
  if (p && is_counting.load(std::memory_order_relaxed)) {
    const std::ptrdiff_t now = in_use += usableSize(p);
    std::ptrdiff_t before = peak;
    while (before < now && !peak.compare_exchange_weak(before, now)) {
    }
  }
  return p;
}

void
uncount(void* p)
{
  if (p && is_counting.load(std::memory_order_relaxed))
    in_use -= usableSize(p);
}

} // namespace

extern "C" {

void*
malloc(std::size_t size)
{
  return counted(__libc_malloc(size));
}

void*
calloc(std::size_t count, std::size_t size)
{
  return counted(__libc_calloc(count, size));
}

void*
realloc(void* p, std::size_t size)
{
  uncount(p);
  return counted(__libc_realloc(p, size));
}

void*
memalign(std::size_t alignment, std::size_t size)
{
  return counted(__libc_memalign(alignment, size));
}

void*
aligned_alloc(std::size_t alignment, std::size_t size)
{
  return memalign(alignment, size);
}

int
posix_memalign(void** p, std::size_t alignment, std::size_t size)
{
  *p = memalign(alignment, size);
  return *p ? 0 : ENOMEM;
}

void
free(void* p)
{
  uncount(p);
  __libc_free(p);
}
}

void
startCountingHeap()
{
  in_use = 0;
  peak = 0;
  is_counting = true;
}

void
stopCountingHeap()
{
  is_counting = false;
}

std::ptrdiff_t
takeHeapPeak()
{
  return peak.exchange(in_use);
}
