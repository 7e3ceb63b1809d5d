// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Knows for each thread the flag that cancels what it computes.

#include <pcl/features/cancellation.h>

namespace pcl {
namespace {

thread_local const std::atomic<bool>* flag_of_thread = nullptr;

} // namespace

const char*
Canceled::what() const noexcept
{
  return "the computation was canceled";
}

CancellationScope::CancellationScope(const std::atomic<bool>& is_canceled)
: before_(flag_of_thread)
{
  flag_of_thread = &is_canceled;
}

CancellationScope::~CancellationScope() { flag_of_thread = before_; }

const std::atomic<bool>*
kernels::cancellationFlag()
{
  return flag_of_thread;
}

} // namespace pcl
