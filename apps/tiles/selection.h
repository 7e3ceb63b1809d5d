// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// One of the sorted values of more numbers than fit into memory.

#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <functional>
#include <stdexcept>
#include <type_traits>
#include <utility>
#include <vector>

namespace pcl::app {

/** \brief Finds one of the sorted values of floats or doubles in passes over all of
 * them: each counts those that begin with the bits found so far by the next 16 bits. */
template <typename T>
class Selection {
public:
  static constexpr int bits = 16, passes = 8 * sizeof(T) / bits;

  /** \brief How many of so many values are below the one that is to be found. */
  using Rank = std::function<std::uint64_t(std::uint64_t count)>;

  explicit Selection(Rank rank) : rank_of_(std::move(rank)) {}

  void
  add(T value, std::uint64_t times = 1)
  {
    const Key key = keyOf(value);
    if (pass_ == 0)
      count_ += times;
    else if (key >> bitsLeft() != found_)
      return;
    counts_[key >> (bitsLeft() - bits) & digit_mask] += times;
  }

  /** \brief How many values a pass has. */
  std::uint64_t
  count() const
  {
    return count_;
  }

  void
  endPass()
  {
    if (pass_ == 0 && count_ > 0)
      rank_ = rank_of_(count_);
    Key digit = 0;
    while (count_ > 0 && rank_ >= counts_[digit])
      rank_ -= counts_[digit++];
    found_ = static_cast<Key>(pass_ == 0 ? digit : found_ << bits | digit);
    ++pass_;
    counts_.assign(counts_.size(), 0);
  }

  /** \brief The value, after all passes; after fewer, but at least one, the least value
   * with the bits found so far. */
  T
  value() const
  {
    if (pass_ == 0 || count_ == 0)
      throw std::logic_error(
          "a value is asked for before a pass with values has ended");
    const Key key = pass_ == passes ? found_ : found_ << bitsLeft();
    const Key value_bits = key & sign ? key ^ sign : ~key;
    T value{};
    std::memcpy(&value, &value_bits, sizeof value);
    return value;
  }

private:
  using Key = std::conditional_t<sizeof(T) == 4, std::uint32_t, std::uint64_t>;
  static constexpr Key sign = Key{1} << (8 * sizeof(T) - 1);
  static constexpr Key digit_mask = (Key{1} << bits) - 1;

  /** Whole numbers in the same order. */
  static Key
  keyOf(T value)
  {
    Key key = 0;
    std::memcpy(&key, &value, sizeof key);
    return key & sign ? ~key : key | sign;
  }

  /** How many bits of a key are not found yet. */
  int
  bitsLeft() const
  {
    return bits * (passes - pass_);
  }

  Rank rank_of_;
  std::vector<std::uint64_t> counts_ =
      std::vector<std::uint64_t>(std::size_t{1} << bits);
  std::uint64_t count_ = 0, rank_ = 0;
  Key found_ = 0;
  int pass_ = 0;
};

} // namespace pcl::app
