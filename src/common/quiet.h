// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// PURPOSE

#pragma once

#include <pcl/console/print.h>

#include <mutex>

namespace pcl::detail {

/** \brief While there is one, PCL is silent: it reports samples that it rejects as
 * errors, and they are none. The level is the whole process's: the first one keeps it,
 * the last one sets it again, under a lock, which PCL does not take to read it. Make
 * one around parallel calls, not in them. */
class Quiet {
public:
  Quiet()
  {
    const std::lock_guard<std::mutex> lock(mutex());
    if (count()++ == 0) {
      level() = pcl::console::getVerbosityLevel();
      pcl::console::setVerbosityLevel(pcl::console::L_ALWAYS);
    }
  }

  ~Quiet()
  {
    const std::lock_guard<std::mutex> lock(mutex());
    if (--count() == 0)
      pcl::console::setVerbosityLevel(level());
  }

  Quiet(const Quiet&) = delete;
  Quiet& operator=(const Quiet&) = delete;

private:
  static std::mutex&
  mutex()
  {
    static std::mutex instance;
    return instance;
  }

  static int&
  count()
  {
    static int instance = 0;
    return instance;
  }

  static pcl::console::VERBOSITY_LEVEL&
  level()
  {
    static pcl::console::VERBOSITY_LEVEL instance{};
    return instance;
  }
};

} // namespace pcl::detail
