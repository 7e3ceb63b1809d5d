// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// What the sorted index is made with: radix sort, cells, rows.

#include "common/radix_sort.h"
#include "support/kernel_targets.h"
#include "support/random.h"
#include "sweep/index/row_index.h"
#include "sweep/portable/targets.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>
#include <vector>

namespace {

using namespace pcl::kernels;
using namespace pcl::test;

template <typename Key>
RawVector<Keyed<Key>>
randomEntries(std::size_t count, int bits, Random& random)
{
  RawVector<Keyed<Key>> entries(count);
  for (std::size_t i = 0; i < count; ++i) {
    const double share = random.uniform() * random.uniform();
    entries[i].key = static_cast<Key>(std::ldexp(share, bits));
    entries[i].index = static_cast<std::uint32_t>(i);
  }
  return entries;
}

template <typename Key>
void
expectSortedAsByStableSort(std::size_t count, int bits, unsigned threads)
{
  SCOPED_TRACE(testing::Message() << count << " keys of " << bits << " bits");
  Random random(count + static_cast<std::size_t>(bits));
  auto entries = randomEntries<Key>(count, bits, random);
  auto expected = entries;
  std::stable_sort(expected.begin(), expected.end(), [](const auto& a, const auto& b) {
    return a.key < b.key;
  });
  radixSort(entries, bits, threads);
  ASSERT_EQ(expected.size(), entries.size());
  for (std::size_t i = 0; i < count; ++i) {
    ASSERT_EQ(expected[i].key, entries[i].key) << i;
    ASSERT_EQ(expected[i].index, entries[i].index) << i;
  }
}

TEST(RadixSort, IsAsStableSort)
{
  for (const std::size_t count : {0U, 1U, 2U, 3U, 100U, 70000U}) {
    for (const unsigned threads : {1U, 3U}) {
      for (const int bits : {0, 1, 7, 8, 9, 17, 18, 19, 28, 31, 32})
        expectSortedAsByStableSort<std::uint32_t>(count, bits, threads);
      for (const int bits : {33, 48, 52, 63, 64})
        expectSortedAsByStableSort<std::uint64_t>(count, bits, threads);
    }
  }
}

/** \brief As of a cloud with a far outlier: the highest bits are the same of all but
 * one.
 */
TEST(RadixSort, OfKeysThatShareTheHighestBits)
{
  constexpr int bits = 44, low_bits = 30;
  constexpr std::size_t count = 200000;
  Random random(7);
  auto entries = randomEntries<std::uint64_t>(count, low_bits, random);
  entries[count / 3].key = (std::uint64_t{1} << bits) - 1;
  auto expected = entries;
  std::stable_sort(expected.begin(), expected.end(), [](const auto& a, const auto& b) {
    return a.key < b.key;
  });
  for (const unsigned threads : {1U, 3U}) {
    auto sorted = entries;
    radixSort(sorted, bits, threads);
    ASSERT_EQ(count, sorted.size());
    for (std::size_t i = 0; i < count; ++i) {
      ASSERT_EQ(expected[i].key, sorted[i].key) << i;
      ASSERT_EQ(expected[i].index, sorted[i].index) << i;
    }
  }
}

class IndexKernels : public testing::TestWithParam<std::string> {
protected:
  ForcedTarget target_{GetParam()};
};

TEST_P(IndexKernels, CellsAreThoseOfEachCoordinate)
{
  constexpr float most = std::numeric_limits<float>::max();
  std::vector<float> coordinates{0.0f, -0.0f, 1.0f, -1.0f, 0.25f, -0.25f, 1e-30f};
  coordinates.insert(coordinates.end(),
                     {-1e-30f, 1e9f, -1e9f, 3e9f, -3e9f, most, -most});
  Random random(1);
  while (coordinates.size() % block_size != 0 || coordinates.size() < 1000) {
    const double power = random.uniform(-9, 9);
    coordinates.push_back(
        static_cast<float>(random.uniform(-1, 1) * std::pow(10.0, power)));
  }
  for (const double cells_per_meter : {1.0, 4.0, 117.6470588, 1e-6, 1e12}) {
    std::vector<std::int32_t> cells(coordinates.size());
    chosenKernels().cells(
        coordinates.data(), coordinates.size(), cells_per_meter, cells.data());
    for (std::size_t i = 0; i < coordinates.size(); ++i) {
      const double cell = std::floor(coordinates[i] * cells_per_meter);
      EXPECT_EQ(std::clamp<double>(cell, -max_cell, max_cell), cells[i])
          << coordinates[i] << " with " << cells_per_meter;
    }
  }
}

TEST_P(IndexKernels, CountsTheSmallerOnes)
{
  constexpr float nan = std::numeric_limits<float>::quiet_NaN();
  constexpr float infinity = std::numeric_limits<float>::infinity();
  std::vector<float> values(2 * block_size, nan);
  for (std::size_t i = 0; i < block_size; ++i)
    values[i] = static_cast<float>(i) / 2.0f;
  for (std::size_t first = 0; first <= block_size; ++first) {
    const std::size_t left = block_size - first;
    for (std::size_t count = 0; count <= left; ++count) {
      for (const float bound : {-infinity, -1.0f, 0.0f, 2.9f, 3.0f, 7.0f, infinity}) {
        const auto begin = values.begin() + static_cast<std::ptrdiff_t>(first);
        const auto less = std::count_if(begin,
                                        begin + static_cast<std::ptrdiff_t>(count),
                                        [=](float v) { return v < bound; });
        EXPECT_EQ(less, chosenKernels().countLess(values.data() + first, count, bound))
            << count << " from " << first << " below " << bound;
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Targets,
                         IndexKernels,
                         testing::ValuesIn(kernelTargets()),
                         TargetName());

/** \brief Rows and the points in them are in order, each point in its own row. */
void
expectInOrder(const RowIndex& index)
{
  for (std::size_t r = 0; r < index.rowCount(); ++r) {
    const Row &row = index.rows[r], &next = index.rows[r + 1];
    ASSERT_LT(row.begin, next.begin);
    if (r + 1 < index.rowCount()) {
      ASSERT_TRUE(row.iz < next.iz || (row.iz == next.iz && row.iy < next.iy));
    }
    for (std::uint32_t i = row.begin; i < next.begin; ++i) {
      ASSERT_EQ(cellOf(index.y[i], index.cellsPerMeter()), row.iy);
      ASSERT_EQ(cellOf(index.z[i], index.cellsPerMeter()), row.iz);
      ASSERT_TRUE(i == row.begin ||
                  std::tie(index.x[i - 1], index.y[i - 1], index.z[i - 1]) <=
                      std::tie(index.x[i], index.y[i], index.z[i]));
    }
  }
}

TEST(RowIndex, HasEachFinitePointOnceInOrder)
{
  constexpr float nan = std::numeric_limits<float>::quiet_NaN();
  constexpr std::size_t count = 20000;
  Random random(2);
  for (const double extent : {1.0, 1e4, 1e9}) {
    std::vector<float> xyz;
    std::size_t finite = 0;
    for (std::size_t i = 0; i < count; ++i) {
      const bool is_missing = random.index(5) == 0;
      finite += is_missing ? 0 : 1;
      // Many share an x.
      xyz.push_back(
          static_cast<float>(extent * 1e-3 * std::floor(random.uniform(0, 999))));
      xyz.push_back(static_cast<float>(random.uniform(-0.5, 0.5) * extent));
      xyz.push_back(
          is_missing ? nan : static_cast<float>(random.uniform(-0.1, 0.1) * extent));
    }
    const pcl::XYZView points{xyz.data(), 3, count};
    for (const unsigned threads : {1U, 3U}) {
      const RowIndex index = buildRowIndex(points, nullptr, count, 0.02, threads);
      ASSERT_EQ(finite, index.size());
      expectInOrder(index);
      std::vector<bool> seen(count, false);
      for (std::size_t i = 0; i < finite; ++i) {
        const float* p = points[index.order[i]];
        ASSERT_FALSE(seen[index.order[i]]);
        seen[index.order[i]] = true;
        ASSERT_TRUE(p[0] == index.x[i] && p[1] == index.y[i] && p[2] == index.z[i]);
      }
    }
  }
}

} // namespace
