/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * Point Cloud Library (PCL) - www.pointclouds.org
 * Copyright (c) 2026, pcl_shape contributors
 *
 * All rights reserved
 */

#include "radix_sort.h"

#include "parallel.h"

#include <algorithm>
#include <array>

namespace pcl {
namespace kernels {
namespace {

constexpr int digit_bits = 11;
constexpr std::size_t digits = std::size_t{1} << digit_bits;
using Histogram = std::array<std::uint32_t, digits>;

/** \brief How many parts entries are split into: few, so that counting digits stays
 * cheap. */
std::size_t
partsFor(std::size_t entries, unsigned threads)
{
  constexpr std::size_t least_a_part = 16384;
  return std::clamp<std::size_t>(entries / least_a_part, 1, threadCount(threads));
}

class Pass {
public:
  Pass(const KeyedIndices& from, int shift, unsigned threads)
  : from_(from)
  , shift_(shift)
  , threads_(threads)
  , parts_(partsFor(from.keys.size(), threads))
  , histograms_(parts_)
  {
    parallelFor(parts_, threads, [this](std::size_t part) {
      Histogram& histogram = histograms_[part];
      histogram.fill(0);
      for (std::size_t i = begin(part); i < begin(part + 1); ++i) {
        ++histogram[digitOf(from_.keys[i])];
      }
    });
  }

  /** \brief Whether all keys have the same digit: there is nothing to sort. */
  bool
  isConstant() const
  {
    const std::size_t digit = digitOf(from_.keys.front());
    std::size_t count = 0;
    for (const Histogram& histogram : histograms_) {
      count += histogram[digit];
    }
    return count == from_.keys.size();
  }

  void
  scatter(KeyedIndices& to)
  {
    turnIntoPositions();
    parallelFor(parts_, threads_, [&](std::size_t part) {
      Histogram& position = histograms_[part];
      for (std::size_t i = begin(part); i < begin(part + 1); ++i) {
        const std::uint32_t at = position[digitOf(from_.keys[i])]++;
        to.keys[at] = from_.keys[i];
        to.indices[at] = from_.indices[i];
      }
    });
  }

private:
  std::size_t
  digitOf(std::uint64_t key) const
  {
    return (key >> shift_) & (digits - 1);
  }

  std::size_t
  begin(std::size_t part) const
  {
    return from_.keys.size() * part / parts_;
  }

  void
  turnIntoPositions()
  {
    std::uint32_t position = 0;
    for (std::size_t digit = 0; digit < digits; ++digit) {
      for (Histogram& histogram : histograms_) {
        const std::uint32_t count = histogram[digit];
        histogram[digit] = position;
        position += count;
      }
    }
  }

  const KeyedIndices& from_;
  int shift_;
  unsigned threads_;
  std::size_t parts_;
  std::vector<Histogram> histograms_;
};

} // namespace

void
radixSort(KeyedIndices& entries, int bits, unsigned threads)
{
  if (entries.keys.size() < 2) {
    return;
  }
  KeyedIndices other;
  other.keys.resize(entries.keys.size());
  other.indices.resize(entries.indices.size());
  for (int shift = 0; shift < bits; shift += digit_bits) {
    Pass pass(entries, shift, threads);
    if (!pass.isConstant()) {
      pass.scatter(other);
      std::swap(entries, other);
    }
  }
}

} // namespace kernels
} // namespace pcl
