/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * Point Cloud Library (PCL) - www.pointclouds.org
 * Copyright (c) 2026, pcl_shape contributors
 *
 * All rights reserved
 */

#pragma once

#include <pcl/pcl_shape_exports.h>

#include <atomic>
#include <exception>

namespace pcl {

/** \brief Leaves a computation that was canceled: see CancellationScope.
 * \ingroup features */
class PCL_SHAPE_EXPORTS Canceled : public std::exception {
public:
  /** \brief What happened, in words. */
  const char* what() const noexcept override;
};

/** \brief While it lives, another thread can end what this thread computes: whatever of
 * this library runs in this thread throws Canceled soon after the flag was set.
 *
 * The flag is looked at between the parts of loops over points, so that it costs no
 * time; the shorter steps between these loops run to their end. The objects that were
 * computing can be used again, their outputs have no meaning. Scopes may be nested: the
 * inner one counts.
 * \ingroup features */
class PCL_SHAPE_EXPORTS CancellationScope {
public:
  /** \param[in] is_canceled not copied; any thread may set it */
  explicit CancellationScope(const std::atomic<bool>& is_canceled);

  ~CancellationScope();

  CancellationScope(const CancellationScope&) = delete;
  CancellationScope& operator=(const CancellationScope&) = delete;

private:
  const std::atomic<bool>* before_;
};

namespace kernels {

/** \brief The flag of this thread's scope, null outside of one. */
PCL_SHAPE_EXPORTS const std::atomic<bool>* cancellationFlag();

} // namespace kernels
} // namespace pcl
