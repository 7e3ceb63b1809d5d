/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * Point Cloud Library (PCL) - www.pointclouds.org
 * Copyright (c) 2026, pcl_shape contributors
 *
 * All rights reserved
 */

#pragma once

#include <pcl/console/print.h>

namespace pcl::detail {

/** \brief PCL reports samples that it rejects as errors; they are none. The level is
 * the whole process's: make one around parallel calls, not in them. */
class Quiet {
public:
  Quiet() : level_(pcl::console::getVerbosityLevel())
  {
    pcl::console::setVerbosityLevel(pcl::console::L_ALWAYS);
  }

  ~Quiet() { pcl::console::setVerbosityLevel(level_); }

  Quiet(const Quiet&) = delete;
  Quiet& operator=(const Quiet&) = delete;

private:
  pcl::console::VERBOSITY_LEVEL level_;
};

} // namespace pcl::detail
