// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Counts neighbors; cells of coordinates and bounds in sorted values for the index.

// No include guard: simd_kernels.cpp includes it once for each target.

#include "sweep/index/row_index.h"
#include "sweep/simd/candidates-inl.h"

HWY_BEFORE_NAMESPACE();
namespace pcl::kernels::HWY_NAMESPACE {

template <bool with_ties>
HWY_INLINE void
addCounts(const SweepBlock& block,
          const NearClusters& near,
          std::size_t begin,
          std::size_t end,
          std::uint32_t* counts)
{
  const Words w;
  const auto one = hn::Set(w, 1);
  const PackedPoints points = packPoints<with_ties>(block, near, begin, end);
  for (std::size_t first = 0; first < block_size; first += lanes) {
    const QueryLanes<with_ties> queries(block, first);
    auto count = hn::LoadU(w, counts + first);
    for (std::size_t c = 0; c < points.size; ++c) {
      const std::uint32_t order = with_ties ? points.order[c] : 0;
      const auto mask = hn::RebindMask(
          w, queries.neighborMask(points.x[c], points.y[c], points.z[c], order));
      count = hn::IfThenElse(mask, hn::Add(count, one), count);
    }
    hn::StoreU(count, w, counts + first);
  }
}

inline void
count(const SweepBlock& block, std::uint32_t* results)
{
  const NearClusters near(block);
  std::uint32_t counts[block_size] = {};
  for (std::size_t begin = 0; begin < near.size; begin += max_clusters) {
    const std::size_t end = std::min(near.size, begin + max_clusters);
    near.has_ties ? addCounts<true>(block, near, begin, end, counts)
                  : addCounts<false>(block, near, begin, end, counts);
  }
  for (std::size_t i = 0; i < block.size; ++i)
    results[i] = counts[i] - (hasOwnPoint(block, i, counts[i] > 0) ? 1 : 0);
}

/** \brief As cellOf(), of whole vectors. */
inline void
cells(const float* coordinates,
      std::size_t count,
      double cells_per_meter,
      std::int32_t* out)
{
  const Doubles d;
  const hn::Rebind<float, Doubles> floats;
  const hn::Rebind<std::int32_t, Doubles> ints;
  const auto scale = hn::Set(d, cells_per_meter);
  const auto max = hn::Set(d, max_cell), min = hn::Set(d, -max_cell);
  for (std::size_t i = 0; i < count; i += double_lanes) {
    const auto at = hn::PromoteTo(d, hn::LoadU(floats, coordinates + i));
    const auto cell = hn::Min(max, hn::Max(min, hn::Mul(at, scale)));
    hn::StoreU(hn::DemoteTo(ints, hn::Floor(cell)), ints, out + i);
  }
}

inline std::uint32_t
countLess(const float* values, std::size_t count, float bound)
{
  const Floats d;
  std::size_t less = 0;
  for (std::size_t i = 0; i < block_size; i += lanes) {
    const auto is_less = hn::Lt(hn::LoadU(d, values + i), hn::Set(d, bound));
    const auto counts = hn::FirstN(d, count > i ? count - i : 0);
    less += hn::CountTrue(d, hn::And(is_less, counts));
  }
  return static_cast<std::uint32_t>(less);
}

} // namespace pcl::kernels::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
