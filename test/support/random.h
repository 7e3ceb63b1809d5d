// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Random numbers that are the same with every standard library.

#pragma once

#include <cmath>
#include <cstdint>
#include <random>

namespace pcl {
namespace test {

/** \brief Random numbers that are the same with every standard library. */
class Random {
public:
  explicit Random(std::uint64_t seed) : engine_(seed) {}

  /** \brief In [0, 1). */
  double
  uniform()
  {
    return std::ldexp(static_cast<double>(engine_() >> 11), -53);
  }

  double
  uniform(double low, double high)
  {
    return low + (high - low) * uniform();
  }

  /** \brief In [0, count). */
  std::size_t
  index(std::size_t count)
  {
    return static_cast<std::size_t>(engine_() % count);
  }

  /** \brief Of mean 0 and standard deviation 1 (Box and Muller). */
  double
  normal()
  {
    constexpr double turn = 6.283185307179586;
    const double length = std::sqrt(-2.0 * std::log(1.0 - uniform()));
    return length * std::cos(turn * uniform());
  }

private:
  std::mt19937_64 engine_;
};

} // namespace test
} // namespace pcl
