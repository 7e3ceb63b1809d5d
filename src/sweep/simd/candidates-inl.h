// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// The surface points that may be neighbors of a block's queries.

#if defined(PCL_SHAPE_SWEEP_CANDIDATES_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef PCL_SHAPE_SWEEP_CANDIDATES_INL_H_
#undef PCL_SHAPE_SWEEP_CANDIDATES_INL_H_
#else
#define PCL_SHAPE_SWEEP_CANDIDATES_INL_H_
#endif

#include "sweep/simd/common-inl.h"

HWY_BEFORE_NAMESPACE();
namespace pcl::kernels::HWY_NAMESPACE {

/** \brief How far points, and boxes of clusters, are from a box. */
class BoxDistances {
public:
  HWY_INLINE explicit BoxDistances(const Box& box)
  : min_{hn::Set(Floats(), box.x_min),
         hn::Set(Floats(), box.y_min),
         hn::Set(Floats(), box.z_min)}
  , max_{hn::Set(Floats(), box.x_max),
         hn::Set(Floats(), box.y_max),
         hn::Set(Floats(), box.z_max)}
  {}

  /** \brief By how much intervals are outside the box along an axis, 0 if they overlap
   * it. */
  template <class V>
  HWY_INLINE V
  outside(std::size_t axis, V low, V high) const
  {
    return hn::Max(hn::Max(hn::Sub(min_[axis], high), hn::Sub(low, max_[axis])),
                   hn::Zero(Floats()));
  }

  /** \brief Squared distances of points from the box. */
  template <class V>
  HWY_INLINE V
  squared(V x, V y, V z) const
  {
    return roughSquaredLength(outside(0, x, x), outside(1, y, y), outside(2, z, z));
  }

  /** \brief Squared distances of points from the furthest point of the box. */
  template <class V>
  HWY_INLINE V
  squaredToFurthest(V x, V y, V z) const
  {
    const auto along = [&](std::size_t axis, V v) {
      return hn::Min(hn::Sub(min_[axis], v), hn::Sub(v, max_[axis]));
    };
    return roughSquaredLength(along(0, x), along(1, y), along(2, z));
  }

private:
  hn::VFromD<Floats> min_[3], max_[3];
};

/** \brief Which lanes hold points of a cluster of `size`, from its `first` on. */
HWY_INLINE MaskOf<Floats>
pointsOfCluster(std::uint32_t size, std::size_t first)
{
  return hn::FirstN(Floats(), size > first ? size - first : 0);
}

/** Clusters are looked at in portions of this many, so that buffers stay small however
 * many points there are. */
constexpr std::size_t max_clusters = 256;

/** \brief The clusters near a block: by boxes, not by points. */
struct NearClusters {
  float reach2 = 0.0f;      ///< squared distance that no neighbor is beyond
  float sure_reach2 = 0.0f; ///< points nearer than this to all queries are neighbors
  bool has_ties = false;
  std::size_t size = 0;
  const std::uint32_t* clusters = nullptr;
  const std::uint32_t* run_ends = nullptr; ///< how many are in the runs up to each

  explicit NearClusters(const SweepBlock& block)
  {
    const Floats d;
    auto largest = hn::Zero(d), largest_tie = hn::Set(d, -1.0f);
    auto smallest = hn::Set(d, std::numeric_limits<float>::max());
    for (std::size_t i = 0; i < block.size; i += lanes) {
      const auto is_query = hn::FirstN(d, block.size - i);
      const auto r2 = hn::LoadU(d, block.r2 + i);
      const auto tie =
          hn::IfThenElse(is_query, hn::LoadU(d, block.tie_d2 + i), hn::Set(d, -1.0f));
      largest = hn::Max(largest, hn::IfThenElseZero(is_query, r2));
      smallest = hn::Min(smallest, hn::IfThenElse(is_query, r2, smallest));
      largest_tie = hn::Max(largest_tie, tie);
    }
    const float tie = hn::GetLane(hn::MaxOfLanes(d, largest_tie));
    has_ties = tie >= 0.0f;
    // A box may be nearer than its points, never further, but for rounding.
    reach2 = std::max(hn::GetLane(hn::MaxOfLanes(d, largest)), tie) * (1.0f + 1e-5f) +
             std::numeric_limits<float>::min();
    sure_reach2 = hn::GetLane(hn::MinOfLanes(d, smallest)) * (1.0f - 1e-5f) -
                  std::numeric_limits<float>::min();
    list(block);
  }

private:
  void
  list(const SweepBlock& block)
  {
    std::size_t max_size = lanes;
    for (std::size_t r = 0; r < block.run_count; ++r)
      max_size += block.runs[r].end - block.runs[r].begin;
    std::uint32_t* near = simdScratch().near.atLeast(max_size + block.run_count);
    std::uint32_t* ends = near + max_size;
    const Words w;
    const Floats d;
    const BoxDistances distances(block.box);
    const float* sides[6];
    std::copy_n(block.cluster_box, std::size(sides), sides);
    const auto reach = hn::Set(d, reach2);
    std::size_t count = 0;
    for (std::size_t r = 0; r < block.run_count; ++r) {
      const ClusterRun run = block.runs[r];
      for (std::uint32_t c = run.begin; c < run.end; c += lanes) {
        const auto outside = [&](std::size_t axis) {
          return distances.outside(
              axis, hn::LoadU(d, sides[axis] + c), hn::LoadU(d, sides[axis + 3] + c));
        };
        const auto mask = hn::And(
            hn::Lt(roughSquaredLength(outside(0), outside(1), outside(2)), reach),
            hn::FirstN(d, run.end - c));
        count += packStore(w, numbersFrom(c), hn::RebindMask(w, mask), near + count);
      }
      ends[r] = static_cast<std::uint32_t>(count);
    }
    size = count;
    clusters = near;
    run_ends = ends;
  }
};

/** \brief Points one after the other; x is padded with NaN to a whole vector. */
struct PackedPoints {
  const float *x, *y, *z;
  const std::uint32_t* order; ///< if asked for
  std::size_t size;
};

/** \brief The points near enough to the queries' box, of the near clusters [begin,
 * end). */
template <bool with_order>
HWY_NOINLINE PackedPoints
packPoints(const SweepBlock& block,
           const NearClusters& near,
           std::size_t begin,
           std::size_t end)
{
  const Floats d;
  const Words w;
  // Local: what is written might be one of these.
  const float *x = block.x, *y = block.y, *z = block.z;
  const std::uint32_t *cluster_begin = block.cluster_begin, *order = block.order;
  const std::uint32_t* clusters = near.clusters;
  const std::size_t max_size = (end - begin) * block_size + lanes;
  float* out = simdScratch().slots.atLeast(3 * max_size);
  std::uint32_t* out_order =
      with_order ? simdScratch().angles.atLeast(max_size) : nullptr;
  const BoxDistances distances(block.box);
  const auto reach2 = hn::Set(d, near.reach2);
  std::size_t size = 0;
  for (std::size_t c = begin; c < end; ++c) {
    const std::uint32_t first = cluster_begin[clusters[c]];
    const std::uint32_t points = cluster_begin[clusters[c] + 1] - first;
    for (std::uint32_t i = 0; i < points; i += lanes) {
      const std::uint32_t j = first + i;
      const auto px = hn::LoadU(d, x + j), py = hn::LoadU(d, y + j),
                 pz = hn::LoadU(d, z + j);
      const auto mask = hn::And(pointsOfCluster(points, i),
                                hn::Lt(distances.squared(px, py, pz), reach2));
      if constexpr (with_order)
        packStore(
            w, hn::LoadU(w, order + j), hn::RebindMask(w, mask), out_order + size);
      packStore(d, px, mask, out + size);
      packStore(d, py, mask, out + max_size + size);
      size += packStore(d, pz, mask, out + 2 * max_size + size);
    }
  }
  hn::StoreU(hn::Set(d, nan), d, out + size);
  return {out, out + max_size, out + 2 * max_size, out_order, size};
}

/** \brief As many queries as there are lanes, and which candidates are their neighbors.
 */
template <bool with_ties>
class QueryLanes {
public:
  HWY_INLINE
  QueryLanes(const SweepBlock& block, std::size_t first)
  : x_(hn::LoadU(Floats(), block.qx + first))
  , y_(hn::LoadU(Floats(), block.qy + first))
  , z_(hn::LoadU(Floats(), block.qz + first))
  , r2_(hn::LoadU(Floats(), block.r2 + first))
  , tie_d2_(hn::LoadU(Floats(), block.tie_d2 + first))
  , tie_index_(hn::BitCast(Ints(), hn::LoadU(Words(), block.tie_index + first)))
  {}

  HWY_INLINE hn::VFromD<Floats>
  squaredDistances(float x, float y, float z) const
  {
    const Floats d;
    return squaredLength(hn::Sub(hn::Set(d, x), x_),
                         hn::Sub(hn::Set(d, y), y_),
                         hn::Sub(hn::Set(d, z), z_));
  }

  /** \brief Whether a point is a neighbor; `order` counts with ties only. */
  HWY_INLINE MaskOf<Floats>
  neighborMask(float x, float y, float z, std::uint32_t order) const
  {
    const Floats d;
    const auto d2 = squaredDistances(x, y, z);
    const auto near = hn::Lt(d2, r2_);
    if constexpr (with_ties) {
      const auto index = hn::Set(Ints(), static_cast<std::int32_t>(order));
      const auto first = hn::RebindMask(d, hn::Not(hn::Gt(index, tie_index_)));
      return hn::Or(near, hn::And(hn::Eq(d2, tie_d2_), first));
    }
    else {
      return near;
    }
  }

private:
  hn::VFromD<Floats> x_, y_, z_, r2_, tie_d2_;
  hn::VFromD<Ints> tie_index_;
};

/** \brief Whether one of a query's neighbors is its own point. */
inline bool
hasOwnPoint(const SweepBlock& block, std::size_t i, bool has_neighbors)
{
  return has_neighbors && (block.queries_on_surface || isAtSurfacePoint(block, i));
}

} // namespace pcl::kernels::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
