// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// One of the sorted values of more floats than fit into memory.

#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <vector>

namespace pcl::app {

/** \brief Floats of 0 and more are in the order of their bits. */
inline std::uint32_t
keyOfFloat(float value)
{
  std::uint32_t key = 0;
  std::memcpy(&key, &value, sizeof key);
  return key;
}

/** \brief Finds one of the sorted values of floats that are not negative, in two passes
 * over them: first all are counted by the upper half of their bits, then those whose
 * upper half is that of the value, by the lower half. */
class FloatSelection {
public:
  void
  add(float value, std::uint64_t times)
  {
    const std::uint32_t key = keyOfFloat(value);
    if (!is_high_known_) {
      counts_[key >> bits] += times;
      count_ += times;
    }
    else if (key >> bits == high_)
      counts_[key & digit_mask] += times;
  }

  /** \brief How many values the first pass had. */
  std::uint64_t
  count() const
  {
    return count_;
  }

  /** \brief Ends the first pass; all values are to be added once more. \param[in] rank
   * how many values are below the one that is to be found, fewer than count() */
  void
  chooseHigh(std::uint64_t rank)
  {
    rank_ = rank;
    high_ = takeDigit();
    is_high_known_ = true;
    counts_.assign(counts_.size(), 0);
  }

  /** \brief The least value whose upper half is that of the value that is to be found;
   * after chooseHigh(). */
  float
  high() const
  {
    return valueOf(high_ << bits);
  }

  /** \brief The value, after the second pass; called once. */
  float
  value()
  {
    return valueOf(high_ << bits | takeDigit());
  }

private:
  static float
  valueOf(std::uint32_t key)
  {
    float value = 0.0f;
    std::memcpy(&value, &key, sizeof value);
    return value;
  }

  static constexpr int bits = 16;
  static constexpr std::uint32_t digit_mask = (1U << bits) - 1;

  std::uint32_t
  takeDigit()
  {
    std::uint32_t digit = 0;
    while (rank_ >= counts_[digit])
      rank_ -= counts_[digit++];
    return digit;
  }

  std::vector<std::uint64_t> counts_ =
      std::vector<std::uint64_t>(std::size_t{1} << bits);
  std::uint64_t count_ = 0, rank_ = 0;
  std::uint32_t high_ = 0;
  bool is_high_known_ = false;
};

} // namespace pcl::app
