// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// PURPOSE

#include "sweep/index/clusters.h"

#include "common/parallel.h"
#include "sweep/index/row_index.h"

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
      if (!(x[most - 1] - x[first] > far))
        last = most;
      while (last < most && !(x[last] - x[last - 1] > far))
        ++last;
      first = last;
    }
  }
  index.rows.back().first_cluster = static_cast<std::uint32_t>(begin.size());
  begin.push_back(static_cast<std::uint32_t>(index.size()));
}

/** \brief The least and the most of at most block_size values, behind which as many may
 * be read. */
void
setRange(const float* values, std::uint32_t count, float& least, float& most)
{
  // Without branches, and with numbers as wide as floats: compilers make vectors of it.
  constexpr std::uint32_t size = block_size;
  float low[size], high[size];
  const float first = values[0];
  for (std::uint32_t i = 0; i < size; ++i) {
    const float value = values[i];
    low[i] = high[i] = i < count ? value : first;
  }
  for (std::uint32_t half = size / 2; half > 0; half /= 2) {
    for (std::uint32_t i = 0; i < half; ++i) {
      low[i] = std::min(low[i], low[i + half]);
      high[i] = std::max(high[i], high[i + half]);
    }
  }
  least = low[0];
  most = high[0];
}

} // namespace

void
makeClusters(RowIndex& index, unsigned threads)
{
  splitRows(index);
  Clusters& clusters = index.clusters;
  for (auto& side : clusters.box)
    side.resize(clusters.size() + block_size, std::numeric_limits<float>::quiet_NaN());
  parallelForRanges(clusters.size(), threads, [&](std::size_t first, std::size_t last) {
    for (std::size_t c = first; c < last; ++c) {
      const std::uint32_t begin = clusters.begin[c], end = clusters.begin[c + 1];
      const std::uint32_t count = end - begin;
      clusters.box[0][c] = index.x[begin];
      clusters.box[3][c] = index.x[end - 1];
      setRange(index.y.data() + begin, count, clusters.box[1][c], clusters.box[4][c]);
      setRange(index.z.data() + begin, count, clusters.box[2][c], clusters.box[5][c]);
    }
  });
}

} // namespace pcl::kernels
