/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * Point Cloud Library (PCL) - www.pointclouds.org
 * Copyright (c) 2026, pcl_shape contributors
 *
 * All rights reserved
 */

#include "clusters.h"

#include "parallel.h"
#include "row_index.h"

#include <algorithm>
#include <limits>

namespace pcl::kernels {
namespace {

void
splitRows(RowIndex& index)
{
  std::vector<std::uint32_t>& begin = index.clusters.begin;
  begin.reserve(index.size() / (block_size / 2) + index.rowCount() + 1);
  const float* x = index.x.data();
  const auto far = static_cast<float>(index.edge);
  for (std::size_t row = 0; row < index.rowCount(); ++row) {
    index.rows[row].first_cluster = static_cast<std::uint32_t>(begin.size());
    const std::uint32_t end = index.rows[row + 1].begin;
    for (std::uint32_t first = index.rows[row].begin; first < end;) {
      begin.push_back(first);
      const std::uint32_t most =
          std::min(end, first + static_cast<std::uint32_t>(block_size));
      std::uint32_t last = first + 1;
      // Points far apart would share too large a box.
      while (last < most && !(x[last] - x[last - 1] > far)) {
        ++last;
      }
      first = last;
    }
  }
  index.rows.back().first_cluster = static_cast<std::uint32_t>(begin.size());
  begin.push_back(static_cast<std::uint32_t>(index.size()));
}

void
setRange(const std::vector<float>& values,
         std::uint32_t begin,
         std::uint32_t end,
         float& least,
         float& most)
{
  float low = values[begin], high = values[begin];
  for (std::uint32_t i = begin + 1; i < end; ++i) {
    low = std::min(low, values[i]);
    high = std::max(high, values[i]);
  }
  least = low;
  most = high;
}

} // namespace

void
makeClusters(RowIndex& index, unsigned threads)
{
  splitRows(index);
  Clusters& clusters = index.clusters;
  for (auto& side : clusters.box) {
    side.resize(clusters.size() + block_size, std::numeric_limits<float>::quiet_NaN());
  }
  parallelForRanges(clusters.size(), threads, [&](std::size_t first, std::size_t last) {
    for (std::size_t c = first; c < last; ++c) {
      const std::uint32_t begin = clusters.begin[c], end = clusters.begin[c + 1];
      setRange(index.x, begin, end, clusters.box[0][c], clusters.box[3][c]);
      setRange(index.y, begin, end, clusters.box[1][c], clusters.box[4][c]);
      setRange(index.z, begin, end, clusters.box[2][c], clusters.box[5][c]);
    }
  });
}

} // namespace pcl::kernels
