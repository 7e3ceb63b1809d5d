/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * Point Cloud Library (PCL) - www.pointclouds.org
 * Copyright (c) 2026, pcl_shape contributors
 *
 * All rights reserved
 */

#include "row_order.h"

#include "parallel.h"

#include <algorithm>
#include <vector>

namespace pcl::kernels {
namespace {

struct Coordinates {
  float x, y, z;

  bool
  operator<(const Coordinates& b) const
  {
    return x != b.x ? x < b.x : y != b.y ? y < b.y : z < b.z;
  }
};

/** \brief Sort a row anew. */
void
sortRow(RowIndex& index, std::uint32_t begin, std::uint32_t end)
{
  struct Point {
    Coordinates at;
    std::uint32_t order;
  };
  std::vector<Point> row;
  row.reserve(end - begin);
  for (std::uint32_t i = begin; i < end; ++i) {
    row.push_back({{index.x[i], index.y[i], index.z[i]}, index.order[i]});
  }
  std::stable_sort(row.begin(), row.end(), [](const Point& a, const Point& b) {
    return a.at < b.at;
  });
  for (std::uint32_t i = begin; i < end; ++i) {
    const Point& p = row[i - begin];
    index.x[i] = p.at.x;
    index.y[i] = p.at.y;
    index.z[i] = p.at.z;
    index.order[i] = p.order;
  }
}

template <typename T>
void
rotateRight(T* first, T* last)
{
  const T moved = *last;
  std::copy_backward(first, last, last + 1);
  *first = moved;
}

/** \brief Sort a row by x; points of equal x by y, then by z: where they are among
 * those given does not matter. They are in order but within a cell: they move a few
 * places. Rows that take more than that (coordinates beyond the cells' range) are
 * sorted anew. */
void
finishRow(RowIndex& index, std::uint32_t begin, std::uint32_t end)
{
  const auto at = [&](std::uint32_t i) {
    return Coordinates{index.x[i], index.y[i], index.z[i]};
  };
  const float* x = index.x.data();
  std::ptrdiff_t moves_left = 16 * std::ptrdiff_t{end - begin} + 64;
  for (std::uint32_t i = begin + 1; i < end; ++i) {
    if (x[i] > x[i - 1] || !(at(i) < at(i - 1))) {
      continue;
    }
    std::uint32_t place = i;
    while (place > begin && at(i) < at(place - 1) && moves_left >= 0) {
      --place, --moves_left;
    }
    if (moves_left < 0) {
      sortRow(index, begin, end);
      return;
    }
    for (auto* array : {&index.x, &index.y, &index.z}) {
      rotateRight(array->data() + place, array->data() + i);
    }
    rotateRight(index.order.data() + place, index.order.data() + i);
  }
}

} // namespace

void
finishRows(RowIndex& index, unsigned threads)
{
  constexpr std::size_t rows_a_task = 32;
  const std::size_t tasks = (index.rowCount() + rows_a_task - 1) / rows_a_task;
  parallelFor(tasks, threads, [&](std::size_t task) {
    const std::size_t end = std::min(index.rowCount(), (task + 1) * rows_a_task);
    for (std::size_t row = task * rows_a_task; row < end; ++row) {
      finishRow(index, index.rows[row].begin, index.rows[row + 1].begin);
    }
  });
}

} // namespace pcl::kernels
