// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// A stable radix sort of keys with indices, by threads, and vectors for its arrays.

#pragma once

#include "common/parallel.h"

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <new>
#include <utility>
#include <vector>

namespace pcl::kernels {

/** \brief Leaves new values as they are in memory, where others would set them to 0. */
template <typename T>
struct RawAllocator : std::allocator<T> {
  template <typename U>
  struct rebind {
    using other = RawAllocator<U>;
  };

  RawAllocator() = default;

  template <typename U>
  RawAllocator(const RawAllocator<U>&) noexcept
  {}

  template <typename U>
  void
  construct(U* p) noexcept
  {
    ::new (static_cast<void*>(p)) U;
  }
};

/** \brief A vector whose values are unknown until they are set: for those that threads
 * set all of, each the pages that it is the first to touch. */
template <typename T>
using RawVector = std::vector<T, RawAllocator<T>>;

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
  RadixPass(const RawVector<Keyed<Key>>& from,
            int shift,
            int digit_bits,
            unsigned threads)
  : from_(from)
  , digit_{shift, (std::size_t{1} << digit_bits) - 1}
  , digits_(std::size_t{1} << digit_bits)
  , threads_(threads)
  , parts_(partsFor(from.size(), threads))
  , histograms_(parts_)
  {
    parallelFor(parts_, threads, [this](std::size_t part) {
      histograms_[part].assign(digits_, 0);
      std::uint32_t* const histogram = histograms_[part].data();
      // Local: what is written might be a member.
      const Digit digit = digit_;
      const Keyed<Key>* const end = from_.data() + begin(part + 1);
      for (const Keyed<Key>* entry = from_.data() + begin(part); entry < end; ++entry)
        ++histogram[digit.of(*entry)];
    });
  }

  /** \brief How many entries share the most frequent digit. */
  std::size_t
  largestBucket() const
  {
    std::size_t largest = 0;
    for (std::size_t digit = 0; digit < digits_; ++digit) {
      std::size_t count = 0;
      for (const auto& histogram : histograms_)
        count += histogram[digit];
      largest = std::max(largest, count);
    }
    return largest;
  }

  /** \return where each digit's entries end */
  std::vector<std::uint32_t>
  scatter(RawVector<Keyed<Key>>& to)
  {
    turnIntoPositions();
    parallelFor(parts_, threads_, [&](std::size_t part) {
      std::uint32_t* const position = histograms_[part].data();
      Keyed<Key>* const out = to.data();
      const Digit digit = digit_;
      const Keyed<Key>* const end = from_.data() + begin(part + 1);
      for (const Keyed<Key>* entry = from_.data() + begin(part); entry < end; ++entry)
        out[position[digit.of(*entry)]++] = *entry;
    });
    return histograms_.back();
  }

private:
  struct Digit {
    int shift;
    std::size_t mask;

    std::size_t
    of(const Keyed<Key>& entry) const
    {
      return static_cast<std::size_t>(entry.key >> shift) & mask;
    }
  };

  /** \brief How many parts entries are split into: few, so that counting digits stays
   * cheap. */
  static std::size_t
  partsFor(std::size_t entries, unsigned threads)
  {
    constexpr std::size_t min_part = 16384;
    return std::clamp<std::size_t>(entries / min_part, 1, threadCount(threads));
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

  const RawVector<Keyed<Key>>& from_;
  Digit digit_;
  std::size_t digits_;
  unsigned threads_;
  std::size_t parts_;
  std::vector<std::vector<std::uint32_t>> histograms_;
};

/** \brief How wide the digits of keys are that are split into as few as may be. */
inline int
digitBits(int bits, int max_digit_bits)
{
  const int digits = (bits + max_digit_bits - 1) / max_digit_bits;
  return digits > 0 ? (bits + digits - 1) / digits : 0;
}

/** Counts of digits of these widths stay in the first and in the second cache. */
constexpr int max_bucket_digit_bits = 10, max_pass_digit_bits = 11;

/** \brief Stable sort of few entries by their lowest bits, to and fro between two
 * arrays. \return whether they end in the other one */
template <typename Key>
bool
sortBucket(Keyed<Key>* entries, Keyed<Key>* other, std::size_t count, int bits)
{
  const int digit_bits = digitBits(bits, max_bucket_digit_bits);
  const Key mask = static_cast<Key>((Key{1} << digit_bits) - 1);
  bool is_in_other = false;
  for (int shift = 0; shift < bits; shift += digit_bits) {
    std::uint32_t position[std::size_t{1} << max_bucket_digit_bits] = {};
    for (std::size_t i = 0; i < count; ++i)
      ++position[(entries[i].key >> shift) & mask];
    std::uint32_t sum = 0;
    for (std::size_t digit = 0; digit <= mask; ++digit)
      sum += std::exchange(position[digit], sum);
    for (std::size_t i = 0; i < count; ++i)
      other[position[(entries[i].key >> shift) & mask]++] = entries[i];
    std::swap(entries, other);
    is_in_other = !is_in_other;
  }
  return is_in_other;
}

/** \brief Stable sort by one digit after the other, all entries in each pass. */
template <typename Key>
void
sortByPasses(RawVector<Keyed<Key>>& entries,
             RawVector<Keyed<Key>>& other,
             int bits,
             unsigned threads)
{
  const int digit_bits = digitBits(bits, max_pass_digit_bits);
  for (int shift = 0; shift < bits; shift += digit_bits) {
    RadixPass<Key> pass(entries, shift, digit_bits, threads);
    if (pass.largestBucket() < entries.size()) {
      pass.scatter(other);
      std::swap(entries, other);
    }
  }
}

/** \brief Stable sort by the lowest `bits` bits of the keys: by the highest ones first,
 * which neighbors often share, then bucket by bucket, which mostly are small enough for
 * the cache. If one holds too many, threads would wait for it: then pass by pass. The
 * result does not depend on the number of threads. */
template <typename Key>
void
radixSort(RawVector<Keyed<Key>>& entries, int bits, unsigned threads)
{
  constexpr int max_top_bits = 8;
  constexpr std::size_t large = std::size_t{1} << 16; // what a cache of 1 MB holds
  if (entries.size() < 2)
    return;
  const int top_bits = std::min(bits, max_top_bits);
  RawVector<Keyed<Key>> other(entries.size());
  RadixPass<Key> pass(entries, bits - top_bits, top_bits, threads);
  if (pass.largestBucket() > std::max(large, entries.size() / 4)) {
    sortByPasses(entries, other, bits, threads);
    return;
  }
  const std::vector<std::uint32_t> ends = pass.scatter(other);
  std::atomic<bool> is_in_other{false}; // the same for all buckets
  parallelFor(ends.size(), threads, [&](std::size_t i) {
    const std::size_t begin = i > 0 ? ends[i - 1] : 0;
    is_in_other = !sortBucket(
        other.data() + begin, entries.data() + begin, ends[i] - begin, bits - top_bits);
  });
  if (is_in_other)
    std::swap(entries, other);
}

} // namespace pcl::kernels
