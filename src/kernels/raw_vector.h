/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * Point Cloud Library (PCL) - www.pointclouds.org
 * Copyright (c) 2026, pcl_shape contributors
 *
 * All rights reserved
 */

#pragma once

#include <memory>
#include <new>
#include <utility>
#include <vector>

namespace pcl::kernels {

/** \brief Leaves new values as they are in memory, where others would set them to 0. */
template <typename T>
struct RawAllocator : std::allocator<T> {
  template <typename U>
  struct rebind {
    using other = RawAllocator<U>;
  };

  RawAllocator() = default;

  template <typename U>
  RawAllocator(const RawAllocator<U>&) noexcept
  {}

  template <typename U>
  void
  construct(U* p) noexcept
  {
    ::new (static_cast<void*>(p)) U;
  }

  template <typename U, typename... Args>
  void
  construct(U* p, Args&&... args)
  {
    ::new (static_cast<void*>(p)) U{std::forward<Args>(args)...};
  }
};

/** \brief A vector whose values are unknown until they are set: for those that threads
 * set all of, each the pages that it is the first to touch. */
template <typename T>
using RawVector = std::vector<T, RawAllocator<T>>;

} // namespace pcl::kernels
