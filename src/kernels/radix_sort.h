/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * Point Cloud Library (PCL) - www.pointclouds.org
 * Copyright (c) 2026, pcl_shape contributors
 *
 * All rights reserved
 */

#pragma once

#include "parallel.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace pcl::kernels {

/** \brief A key and what it belongs to. */
template <typename Key>
struct Keyed {
  Key key;
  std::uint32_t index;
};

/** \brief One pass of a radix sort: by one digit, in parts that threads take. */
template <typename Key>
class RadixPass {
public:
  RadixPass(const std::vector<Keyed<Key>>& from,
            int shift,
            int digit_bits,
            unsigned threads)
  : from_(from)
  , shift_(shift)
  , digits_(std::size_t{1} << digit_bits)
  , threads_(threads)
  , parts_(partsFor(from.size(), threads))
  , histograms_(parts_)
  {
    parallelFor(parts_, threads, [this](std::size_t part) {
      auto& histogram = histograms_[part];
      histogram.assign(digits_, 0);
      for (std::size_t i = begin(part); i < begin(part + 1); ++i) {
        ++histogram[digitOf(from_[i])];
      }
    });
  }

  /** \brief Whether all keys have the same digit: there is nothing to sort. */
  bool
  isConstant() const
  {
    const std::size_t digit = digitOf(from_.front());
    std::size_t count = 0;
    for (const auto& histogram : histograms_) {
      count += histogram[digit];
    }
    return count == from_.size();
  }

  void
  scatter(std::vector<Keyed<Key>>& to)
  {
    turnIntoPositions();
    parallelFor(parts_, threads_, [&](std::size_t part) {
      auto& position = histograms_[part];
      for (std::size_t i = begin(part); i < begin(part + 1); ++i) {
        to[position[digitOf(from_[i])]++] = from_[i];
      }
    });
  }

private:
  /** \brief How many parts entries are split into: few, so that counting digits stays
   * cheap. */
  static std::size_t
  partsFor(std::size_t entries, unsigned threads)
  {
    constexpr std::size_t least_a_part = 16384;
    return std::clamp<std::size_t>(entries / least_a_part, 1, threadCount(threads));
  }

  std::size_t
  digitOf(const Keyed<Key>& entry) const
  {
    return static_cast<std::size_t>(entry.key >> shift_) & (digits_ - 1);
  }

  std::size_t
  begin(std::size_t part) const
  {
    return from_.size() * part / parts_;
  }

  void
  turnIntoPositions()
  {
    std::uint32_t position = 0;
    for (std::size_t digit = 0; digit < digits_; ++digit) {
      for (auto& histogram : histograms_) {
        const std::uint32_t count = histogram[digit];
        histogram[digit] = position;
        position += count;
      }
    }
  }

  const std::vector<Keyed<Key>>& from_;
  int shift_;
  std::size_t digits_;
  unsigned threads_;
  std::size_t parts_;
  std::vector<std::vector<std::uint32_t>> histograms_;
};

/** \brief Stable sort by the lowest `bits` bits of the keys. The result does not depend
 * on the number of threads. */
template <typename Key>
void
radixSort(std::vector<Keyed<Key>>& entries, int bits, unsigned threads)
{
  // A histogram of digits of this many bits fits in the first-level cache.
  constexpr int most_digit_bits = 11;
  if (entries.size() < 2) {
    return;
  }
  std::vector<Keyed<Key>> other(entries.size());
  const int passes = (bits + most_digit_bits - 1) / most_digit_bits;
  const int digit_bits = passes > 0 ? (bits + passes - 1) / passes : 0;
  for (int shift = 0; shift < bits; shift += digit_bits) {
    RadixPass<Key> pass(entries, shift, digit_bits, threads);
    if (!pass.isConstant()) {
      pass.scatter(other);
      std::swap(entries, other);
    }
  }
}

} // namespace pcl::kernels
