// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// PURPOSE

#pragma once

#include <chrono>
#include <cstdint>
#include <string>
#include <vector>

namespace pcl::app {

/** \brief Says on standard error which of many files is being processed, and how long
 * the others will take, as far as time goes with bytes. */
class Progress {
public:
  Progress(std::string app, const std::vector<std::string>& files);

  void begin(const std::string& file);

  /** \param[in] is_processed false for a file that there was nothing to do for */
  void end(const std::string& file, bool is_processed);

private:
  using Clock = std::chrono::steady_clock;

  std::string app_;
  std::size_t files_, begun_ = 0;
  std::uint64_t bytes_left_ = 0;
  double bytes_processed_ = 0.0, seconds_ = 0.0;
  Clock::time_point start_;
};

} // namespace pcl::app
