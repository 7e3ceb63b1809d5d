// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Silence on PCL's console while models are fitted.

#pragma once

#include <pcl/console/print.h>

#include <mutex>

namespace pcl::detail {

/** \brief Silences PCL's console for its lifetime: RANSAC logs rejected samples as
 * errors. The level belongs to the whole process: the first Quiet saves it and the last
 * one restores it, under a lock that PCL does not take when it reads the level. Make
 * one around parallel calls, not in them. */
class Quiet {
public:
  Quiet()
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (count_++ == 0) {
      level_ = pcl::console::getVerbosityLevel();
      pcl::console::setVerbosityLevel(pcl::console::L_ALWAYS);
    }
  }

  ~Quiet()
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (--count_ == 0)
      pcl::console::setVerbosityLevel(level_);
  }

  Quiet(const Quiet&) = delete;
  Quiet& operator=(const Quiet&) = delete;

private:
  static inline std::mutex mutex_;
  static inline int count_ = 0;
  static inline pcl::console::VERBOSITY_LEVEL level_{};
};

} // namespace pcl::detail
