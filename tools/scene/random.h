// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Random numbers, sines and logarithms that are the same on every machine.

#pragma once

#include "scene/vec.h"

#include <array>
#include <cstdint>

namespace pcl::scene {

/** \brief Random numbers that are the same on every machine: xoshiro256** (Blackman and
 * Vigna, 2018), seeded by splitmix64. The standard library's distributions differ
 * between implementations. */
class Random {
public:
  /** \param[in] stream separates the random numbers of different tasks */
  Random(std::uint64_t seed, std::uint64_t stream);

  /** \brief Uniform in [0, 1). */
  double uniform();

  /** \brief Uniform in [low, high). */
  double
  uniform(double low, double high)
  {
    return low + (high - low) * uniform();
  }

  /** \brief Uniform in 0 ... count - 1. */
  unsigned
  below(unsigned count)
  {
    return static_cast<unsigned>(uniform() * count);
  }

  bool
  chance(double probability)
  {
    return uniform() < probability;
  }

  /** \brief A unit vector of any direction. */
  Vec3 direction();

  /** \brief Standard normal deviate, by Marsaglia's polar method. */
  double normal();

private:
  std::uint64_t next();

  std::array<std::uint64_t, 4> state_;
  double spare_ = 0.0;
  bool has_spare_ = false;
};

/** \brief Cosine and sine. */
struct UnitVector {
  double cosine = 1.0, sine = 0.0;
};

/** \brief Cosine and sine of a number of full turns, the same on every machine. */
UnitVector fromTurns(double turns);

/** \brief Natural logarithm of a positive number, the same on every machine. */
double portableLog(double x);

} // namespace pcl::scene
