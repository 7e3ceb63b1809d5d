// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// xoshiro256**, normal deviates, and series for sine, cosine and logarithm.

#include "scene/random.h"

#include <cmath>

namespace pcl::scene {
namespace {

std::uint64_t
splitMix64(std::uint64_t& state)
{
  std::uint64_t z = (state += 0x9e3779b97f4a7c15ULL);
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ULL;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebULL;
  return z ^ (z >> 31);
}

std::uint64_t
rotateLeft(std::uint64_t x, int bits)
{
  return (x << bits) | (x >> (64 - bits));
}

} // namespace

Random::Random(std::uint64_t seed, std::uint64_t stream)
{
  std::uint64_t mixed = stream;
  mixed = seed ^ splitMix64(mixed);
  for (auto& word : state_)
    word = splitMix64(mixed);
}

std::uint64_t
Random::next()
{
  const std::uint64_t result = rotateLeft(state_[1] * 5, 7) * 9;
  const std::uint64_t shifted = state_[1] << 17;
  state_[2] ^= state_[0];
  state_[3] ^= state_[1];
  state_[1] ^= state_[2];
  state_[0] ^= state_[3];
  state_[2] ^= shifted;
  state_[3] = rotateLeft(state_[3], 45);
  return result;
}

double
Random::uniform()
{
  constexpr double two_to_minus_53 = 1.0 / 9007199254740992.0;
  return static_cast<double>(next() >> 11) * two_to_minus_53;
}

double
Random::normal()
{
  if (has_spare_) {
    has_spare_ = false;
    return spare_;
  }
  double a = 0.0, b = 0.0, s = 0.0;
  do {
    a = uniform(-1.0, 1.0);
    b = uniform(-1.0, 1.0);
    s = a * a + b * b;
  }
  while (s >= 1.0 || s == 0.0);
  const double scale = std::sqrt(-2.0 * portableLog(s) / s);
  spare_ = b * scale;
  has_spare_ = true;
  return a * scale;
}

Vec3
Random::direction()
{
  const double z = uniform(-1.0, 1.0), level = std::sqrt(1.0 - z * z);
  const UnitVector heading = fromTurns(uniform());
  return {level * heading.cosine, level * heading.sine, z};
}

double
portableLog(double x)
{
  // x = m 2^e with m in [1/2, 1); ln m = 2 atanh((m - 1) / (m + 1))
  int exponent = 0;
  const double mantissa = std::frexp(x, &exponent);
  const double q = (mantissa - 1.0) / (mantissa + 1.0);
  double series = 0.0;
  for (int power = 35; power >= 1; power -= 2)
    series = series * q * q + 1.0 / power;
  constexpr double ln2 = 0.69314718055994530942;
  return 2.0 * q * series + exponent * ln2;
}

UnitVector
fromTurns(double turns)
{
  // The nearest quarter turn exactly, the remaining angle (at most pi/4) by Taylor
  // series
  const double quarters = std::floor(4.0 * turns + 0.5);
  constexpr double half_pi = 1.57079632679489661923;
  const double angle = (4.0 * turns - quarters) * half_pi;
  double cosine = 1.0, sine = 1.0;
  for (int n = 18; n >= 2; n -= 2) {
    cosine = 1.0 - angle * angle / (n * (n - 1)) * cosine;
    sine = 1.0 - angle * angle / (n * (n + 1)) * sine;
  }
  sine *= angle;
  UnitVector result{cosine, sine};
  for (double rest = quarters - 4.0 * std::floor(quarters / 4.0); rest > 0.0; --rest)
    result = {-result.sine, result.cosine};
  return result;
}

} // namespace pcl::scene
