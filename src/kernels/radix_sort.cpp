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

namespace pcl::kernels {
namespace {

/** A histogram of digits of this many bits fits in the first-level cache. */
constexpr int most_digit_bits = 13;
using Histogram = std::vector<std::uint32_t>;

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
  Pass(const KeyedIndices& from, int shift, int digit_bits, unsigned threads)
  : from_(from)
  , shift_(shift)
  , digits_(std::size_t{1} << digit_bits)
  , threads_(threads)
  , parts_(partsFor(from.keys.size(), threads))
  , histograms_(parts_)
  {
    parallelFor(parts_, threads, [this](std::size_t part) {
      Histogram& histogram = histograms_[part];
      histogram.assign(digits_, 0);
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
    return (key >> shift_) & (digits_ - 1);
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
    for (std::size_t digit = 0; digit < digits_; ++digit) {
      for (Histogram& histogram : histograms_) {
        const std::uint32_t count = histogram[digit];
        histogram[digit] = position;
        position += count;
      }
    }
  }

  const KeyedIndices& from_;
  int shift_;
  std::size_t digits_;
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
  const int passes = (bits + most_digit_bits - 1) / most_digit_bits;
  const int digit_bits = passes > 0 ? (bits + passes - 1) / passes : 0;
  for (int shift = 0; shift < bits; shift += digit_bits) {
    Pass pass(entries, shift, digit_bits, threads);
    if (!pass.isConstant()) {
      pass.scatter(other);
      std::swap(entries, other);
    }
  }
}

} // namespace pcl::kernels
