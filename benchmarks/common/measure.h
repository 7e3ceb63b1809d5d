// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Times of calls, and statistics of them.

#pragma once

#include <chrono>
#include <ctime>
#include <vector>

/** \brief How long a call takes, by the clock on the wall. */
template <typename Run>
double
millisecondsOf(const Run& run)
{
  const auto start = std::chrono::steady_clock::now();
  run();
  const std::chrono::duration<double, std::milli> elapsed =
      std::chrono::steady_clock::now() - start;
  return elapsed.count();
}

/** \brief How long the processor works for a call, in this thread only. */
template <typename Run>
double
processorMillisecondsOf(const Run& run)
{
  const auto now = [] {
    std::timespec time{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
    return 1e3 * static_cast<double>(time.tv_sec) +
           1e-6 * static_cast<double>(time.tv_nsec);
  };
  const double start = now();
  run();
  return now() - start;
}

/** \brief The value that this share of the values does not exceed; 0 of none. */
double quantile(std::vector<double> values, double share);

inline double
median(const std::vector<double>& values)
{
  return quantile(values, 0.5);
}

/** \brief Absolute differences where both are numbers. */
std::vector<double> differences(const std::vector<float>& a,
                                const std::vector<float>& b);
