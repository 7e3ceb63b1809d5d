/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * Point Cloud Library (PCL) - www.pointclouds.org
 * Copyright (c) 2026, pcl_shape contributors
 *
 * All rights reserved
 */

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

std::atomic<std::size_t> in_use{0};
std::atomic<std::size_t> peak{0};

void*
counted(void* p)
{
  if (p) {
    const std::size_t now = in_use += malloc_usable_size(p);
    std::size_t before = peak;
    while (before < now && !peak.compare_exchange_weak(before, now)) {
    }
  }
  return p;
}

void
uncount(void* p)
{
  in_use -= p ? malloc_usable_size(p) : 0;
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

std::size_t
heapInUse()
{
  return in_use;
}

std::size_t
heapPeak()
{
  return peak;
}

void
resetHeapPeak()
{
  peak = in_use.load();
}
