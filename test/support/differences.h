// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Statistics of the differences between two lists of results.

#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace pcl {
namespace test {

/** \brief Absolute differences of many results; NaN equals NaN, and is infinitely far
 * from a number. */
class Differences {
public:
  void
  add(double a, double b)
  {
    const bool both = std::isnan(a) && std::isnan(b);
    const double difference = both ? 0 : std::abs(a - b);
    values_.push_back(std::isnan(difference) ? std::numeric_limits<double>::infinity()
                                             : difference);
    known_ += !std::isnan(a) && !std::isnan(b);
  }

  void
  add(const std::vector<float>& a, const std::vector<float>& b)
  {
    for (std::size_t i = 0; i < std::max(a.size(), b.size()); ++i)
      add(i < a.size() ? a[i] : unequal, i < b.size() ? b[i] : 0);
  }

  void
  add(const Differences& other)
  {
    values_.insert(values_.end(), other.values_.begin(), other.values_.end());
    known_ += other.known_;
  }

  /** \brief The share, in [0, 1], of differences of at most this much. */
  double
  within(double tolerance) const
  {
    const auto count = std::count_if(values_.begin(), values_.end(), [=](double value) {
      return value <= tolerance;
    });
    return static_cast<double>(count) / static_cast<double>(values_.size());
  }

  /** \brief Pairs of two numbers: that something was compared at all. */
  std::size_t
  known() const
  {
    return known_;
  }

private:
  static constexpr double unequal = std::numeric_limits<double>::infinity();

  std::vector<double> values_;
  std::size_t known_ = 0;
};

inline double
median(std::vector<float> values)
{
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

} // namespace test
} // namespace pcl
