// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// PURPOSE

#if defined(PCL_SHAPE_SWEEP_CANDIDATES_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef PCL_SHAPE_SWEEP_CANDIDATES_INL_H_
#undef PCL_SHAPE_SWEEP_CANDIDATES_INL_H_
#else
#define PCL_SHAPE_SWEEP_CANDIDATES_INL_H_
#endif

#include "sweep/simd/common-inl.h"

HWY_BEFORE_NAMESPACE();
namespace pcl::kernels::HWY_NAMESPACE {

/** \brief How far points are from a box. */
class BoxDistances {
public:
  /** \brief Squared distances to the nearest and to the furthest point of the box. */
  struct Squares {
    hn::VFromD<Floats> least2, most2;
  };

  HWY_INLINE explicit BoxDistances(const Box& box)
  : x_min_(hn::Set(Floats(), box.x_min))
  , x_max_(hn::Set(Floats(), box.x_max))
  , y_min_(hn::Set(Floats(), box.y_min))
  , y_max_(hn::Set(Floats(), box.y_max))
  , z_min_(hn::Set(Floats(), box.z_min))
  , z_max_(hn::Set(Floats(), box.z_max))
  {}

  HWY_INLINE Squares
  of(hn::VFromD<Floats> x, hn::VFromD<Floats> y, hn::VFromD<Floats> z) const
  {
    const Floats d;
    const auto outside = [&](auto low, auto high) {
      return hn::Max(hn::Max(low, high), hn::Zero(d));
    };
    const auto x_low = hn::Sub(x_min_, x), x_high = hn::Sub(x, x_max_);
    const auto y_low = hn::Sub(y_min_, y), y_high = hn::Sub(y, y_max_);
    const auto z_low = hn::Sub(z_min_, z), z_high = hn::Sub(z, z_max_);
    return {roughSquaredLength(
                outside(x_low, x_high), outside(y_low, y_high), outside(z_low, z_high)),
            roughSquaredLength(hn::Min(x_low, x_high),
                               hn::Min(y_low, y_high),
                               hn::Min(z_low, z_high))};
  }

private:
  hn::VFromD<Floats> x_min_, x_max_, y_min_, y_max_, z_min_, z_max_;
};

/** \brief How far the boxes of clusters are from a box. */
class BoxToBoxes {
public:
  /** \param[in] sides least x, y, z, most x, y, z of the clusters */
  HWY_INLINE
  BoxToBoxes(const Box& box, const float* const* sides)
  : least_{hn::Set(Floats(), box.x_min),
           hn::Set(Floats(), box.y_min),
           hn::Set(Floats(), box.z_min)}
  , most_{hn::Set(Floats(), box.x_max),
          hn::Set(Floats(), box.y_max),
          hn::Set(Floats(), box.z_max)}
  {
    std::copy_n(sides, std::size(sides_), sides_);
  }

  /** \brief Of a vector of clusters from this one on. */
  HWY_INLINE hn::VFromD<Floats>
  squaredDistances(std::uint32_t first) const
  {
    const Floats d;
    const auto apart = [&](std::size_t axis) {
      const auto low = hn::LoadU(d, sides_[axis] + first);
      const auto high = hn::LoadU(d, sides_[axis + 3] + first);
      return hn::Max(hn::Max(hn::Sub(least_[axis], high), hn::Sub(low, most_[axis])),
                     hn::Zero(d));
    };
    return roughSquaredLength(apart(0), apart(1), apart(2));
  }

private:
  hn::VFromD<Floats> least_[3], most_[3];
  const float* sides_[6];
};

/** \brief Which lanes hold points of a cluster of `size`, from its `first` on. */
HWY_INLINE MaskOf<Floats>
pointsOfCluster(std::uint32_t size, std::size_t first)
{
  return hn::FirstN(Floats(), size > first ? size - first : 0);
}

/** Clusters are looked at in portions of this many, so that buffers stay small however
 * many points there are. */
constexpr std::size_t most_clusters = 256;

/** \brief The clusters near a block: by boxes, not by points. */
class NearClusters {
public:
  explicit NearClusters(const SweepBlock& block) : block_(block)
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
    has_ties_ = tie >= 0.0f;
    // A box may be nearer than its points, never further, but for rounding.
    reach2_ = std::max(hn::GetLane(hn::MaxOfLanes(d, largest)), tie) * (1.0f + 1e-5f) +
              std::numeric_limits<float>::min();
    sure_reach2_ = hn::GetLane(hn::MinOfLanes(d, smallest)) * (1.0f - 1e-5f) -
                   std::numeric_limits<float>::min();
    list();
  }

  bool
  hasTies() const
  {
    return has_ties_;
  }

  /** \brief Points nearer than this (squared) to a query are its neighbors. */
  float
  sureReach2() const
  {
    return sure_reach2_;
  }

  /** \brief Squared distance that no neighbor is beyond. */
  float
  reach2() const
  {
    return reach2_;
  }

  std::size_t
  size() const
  {
    return size_;
  }

  const std::uint32_t*
  begin() const
  {
    return simdScratch().near.data();
  }

  /** \brief How many of them are in the runs up to this one. */
  std::size_t
  endOfRun(std::size_t run) const
  {
    return simdScratch().near.data()[run_ends_ + run];
  }

private:
  void
  list()
  {
    std::size_t most = 0;
    for (std::size_t r = 0; r < block_.run_count; ++r)
      most += block_.runs[r].end - block_.runs[r].begin;
    run_ends_ = most + lanes;
    std::uint32_t* near = simdScratch().near.atLeast(run_ends_ + block_.run_count);
    const Words w;
    const Floats d;
    const BoxToBoxes boxes(block_.box, block_.cluster_box);
    const auto reach2 = hn::Set(d, reach2_);
    std::size_t size = 0;
    for (std::size_t r = 0; r < block_.run_count; ++r) {
      const ClusterRun run = block_.runs[r];
      for (std::uint32_t c = run.begin; c < run.end; c += lanes) {
        const auto mask = hn::And(hn::Lt(boxes.squaredDistances(c), reach2),
                                  hn::FirstN(d, run.end - c));
        size += packStore(w, numbersFrom(c), hn::RebindMask(w, mask), near + size);
      }
      near[run_ends_ + r] = static_cast<std::uint32_t>(size);
    }
    size_ = size;
  }

  const SweepBlock& block_;
  float reach2_ = 0.0f, sure_reach2_ = 0.0f;
  bool has_ties_ = false;
  std::size_t size_ = 0;
  std::size_t run_ends_ = 0; ///< where they are in the buffer
};

/** \brief A vector of points. */
struct Points {
  hn::VFromD<Floats> x, y, z;
};

/** \brief Lists points that may be a neighbor of a query of the block. */
class CandidateLister {
public:
  CandidateLister(const NearClusters& near, const Box& box, std::size_t clusters)
  : distances_(box)
  , reach2_(hn::Set(Floats(), near.reach2()))
  {
    numbers_ = simdScratch().offsets.atLeast(clusters * block_size + lanes);
  }

  /** \brief Those near enough to the queries' box, among lanes that count; the first
   * one is known by this number. */
  HWY_INLINE void
  add(const Points& points, MaskOf<Floats> counts, std::size_t number)
  {
    const Words w;
    const auto squares = distances_.of(points.x, points.y, points.z);
    const auto mask = hn::And(hn::Lt(squares.least2, reach2_), counts);
    size_ += packStore(w,
                       numbersFrom(static_cast<std::uint32_t>(number)),
                       hn::RebindMask(w, mask),
                       numbers_ + size_);
  }

  const std::uint32_t*
  numbers() const
  {
    return numbers_;
  }

  std::size_t
  size() const
  {
    return size_;
  }

private:
  BoxDistances distances_;
  hn::VFromD<Floats> reach2_;
  std::uint32_t* numbers_;
  std::size_t size_ = 0;
};

/** \brief Points one after the other; x is padded with NaN to a whole vector. */
struct PackedPoints {
  const float *x, *y, *z;
  const std::uint32_t* order; ///< if asked for
  std::size_t size;
};

/** \brief The points near enough to the queries' box, of some of the near clusters. */
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
  const std::uint32_t* clusters = near.begin();
  const std::size_t most = (end - begin) * block_size + lanes;
  float* out = simdScratch().slots.atLeast(3 * most);
  std::uint32_t* out_order = with_order ? simdScratch().angles.atLeast(most) : nullptr;
  const BoxDistances distances(block.box);
  const auto reach2 = hn::Set(d, near.reach2());
  std::size_t size = 0;
  for (std::size_t c = begin; c < end; ++c) {
    const std::uint32_t first = cluster_begin[clusters[c]];
    const std::uint32_t points = cluster_begin[clusters[c] + 1] - first;
    for (std::uint32_t i = 0; i < points; i += lanes) {
      const std::uint32_t j = first + i;
      const auto px = hn::LoadU(d, x + j), py = hn::LoadU(d, y + j),
                 pz = hn::LoadU(d, z + j);
      const auto mask = hn::And(pointsOfCluster(points, i),
                                hn::Lt(distances.of(px, py, pz).least2, reach2));
      if constexpr (with_order) {
        packStore(
            w, hn::LoadU(w, order + j), hn::RebindMask(w, mask), out_order + size);
      }
      packStore(d, px, mask, out + size);
      packStore(d, py, mask, out + most + size);
      size += packStore(d, pz, mask, out + 2 * most + size);
    }
  }
  hn::StoreU(hn::Set(d, std::numeric_limits<float>::quiet_NaN()), d, out + size);
  return {out, out + most, out + 2 * most, out_order, size};
}

/** \brief Arrays of block_size values at the front of every slot; a kernel's own
 * follow.
 */
enum SlotArray : std::size_t { slot_x, slot_y, slot_z, slot_order, slot_common };

/** \brief A slot of a kernel with some arrays of its own. Candidates are known by their
 * offset from the first slot. */
template <std::size_t own_arrays>
constexpr std::size_t slot_stride = (slot_common + own_arrays) * block_size;

/** \brief Copies points into a slot. */
template <bool with_order>
HWY_INLINE Points
stagePoints(const SweepBlock& block, std::size_t position, float* slot)
{
  const Floats d;
  const Words w;
  const Points points{hn::LoadU(d, block.x + position),
                      hn::LoadU(d, block.y + position),
                      hn::LoadU(d, block.z + position)};
  hn::Store(points.x, d, slot + slot_x * block_size);
  hn::Store(points.y, d, slot + slot_y * block_size);
  hn::Store(points.z, d, slot + slot_z * block_size);
  if constexpr (with_order) {
    hn::Store(hn::LoadU(w, block.order + position),
              w,
              reinterpret_cast<std::uint32_t*>(slot + slot_order * block_size));
  }
  return points;
}

/** \brief Candidates, as offsets of lanes of slots. */
struct CandidateList {
  const float* slots;
  const std::uint32_t* offsets;
  std::size_t size;
};

/** \brief Fills slots of this stride with some of the near clusters: fill(points,
 * slot lanes) copies a kernel's own arrays. */
template <std::size_t stride, bool with_order, typename Fill>
HWY_INLINE CandidateList
stageClusters(const SweepBlock& block,
              const NearClusters& near,
              std::size_t begin,
              std::size_t count,
              const Fill& fill)
{
  float* slots = simdScratch().slots.atLeast(count * stride);
  CandidateLister lister(near, block.box, count);
  for (std::size_t s = 0; s < count; ++s) {
    const std::uint32_t cluster = near.begin()[begin + s];
    const std::uint32_t first = block.cluster_begin[cluster];
    const std::uint32_t size = block.cluster_begin[cluster + 1] - first;
    for (std::size_t i = 0; i < size; i += lanes) {
      const std::size_t offset = s * stride + i;
      const Points points = stagePoints<with_order>(block, first + i, slots + offset);
      fill(points, slots + offset, pointsOfCluster(size, i), offset, lister);
    }
  }
  return {slots, lister.numbers(), lister.size()};
}

/** \brief As many queries as there are lanes, and which candidates are their neighbors.
 */
template <bool with_ties>
class QueryLanes {
public:
  HWY_INLINE
  QueryLanes(const SweepBlock& block,
             const float* r2,
             const float* tie_d2,
             std::size_t first)
  : x_(hn::LoadU(Floats(), block.qx + first))
  , y_(hn::LoadU(Floats(), block.qy + first))
  , z_(hn::LoadU(Floats(), block.qz + first))
  , r2_(hn::LoadU(Floats(), r2 + first))
  , tie_d2_(hn::LoadU(Floats(), tie_d2 + first))
  , tie_index_(hn::BitCast(Ints(), hn::LoadU(Words(), block.tie_index + first)))
  {}

  /** \brief Whether the point in a slot is a neighbor. */
  HWY_INLINE MaskOf<Floats>
  neighborMask(const float* candidate) const
  {
    std::uint32_t order = 0;
    if constexpr (with_ties)
      std::memcpy(&order, candidate + slot_order * block_size, sizeof(order));
    return neighborMask(candidate[slot_x * block_size],
                        candidate[slot_y * block_size],
                        candidate[slot_z * block_size],
                        order);
  }

  /** \brief Whether a point is; `order` counts with ties only. */
  HWY_INLINE MaskOf<Floats>
  neighborMask(float x, float y, float z, std::uint32_t order) const
  {
    const Floats d;
    const auto d2 = squaredLength(hn::Sub(hn::Set(d, x), x_),
                                  hn::Sub(hn::Set(d, y), y_),
                                  hn::Sub(hn::Set(d, z), z_));
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

} // namespace pcl::kernels::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
