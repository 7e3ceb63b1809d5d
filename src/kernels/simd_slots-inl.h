/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * Point Cloud Library (PCL) - www.pointclouds.org
 * Copyright (c) 2026, pcl_shape contributors
 *
 * All rights reserved
 */

#if defined(PCL_SHAPE_SIMD_SLOTS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef PCL_SHAPE_SIMD_SLOTS_INL_H_
#undef PCL_SHAPE_SIMD_SLOTS_INL_H_
#else
#define PCL_SHAPE_SIMD_SLOTS_INL_H_
#endif

#include "simd_common-inl.h"

HWY_BEFORE_NAMESPACE();
namespace pcl::kernels::HWY_NAMESPACE {

/** \brief Arrays of block_size values at the front of every slot; a kernel's own
 * follow.
 */
enum SlotArray : std::size_t { slot_x, slot_y, slot_z, slot_order, slot_common };

/** \brief A slot of a kernel with some arrays of its own. Candidates are known by their
 * offset from the first slot. */
template <std::size_t own_arrays>
constexpr std::size_t slot_stride = (slot_common + own_arrays) * block_size;

/** \brief The clusters near a block: by boxes, not by points. */
class NearClusters {
public:
  explicit NearClusters(const SweepBlock& block) : block_(block)
  {
    float largest = 0.0f;
    float smallest = std::numeric_limits<float>::max();
    for (std::size_t i = 0; i < block.size; ++i) {
      largest = std::max({largest, block.r2[i], block.tie_d2[i]});
      smallest = std::min(smallest, block.r2[i]);
      has_ties_ = has_ties_ || block.tie_d2[i] >= 0.0f;
    }
    // A box may be nearer than its points, never further, but for rounding.
    reach2_ = largest * (1.0f + 1e-5f) + std::numeric_limits<float>::min();
    sure_reach2_ = smallest * (1.0f - 1e-5f);
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

private:
  void
  list()
  {
    std::size_t most = 0;
    for (std::size_t r = 0; r < block_.run_count; ++r) {
      most += block_.runs[r].end - block_.runs[r].begin;
    }
    std::uint32_t* near = simdScratch().near.atLeast(most + lanes);
    const Words w;
    const Floats d;
    for (std::size_t r = 0; r < block_.run_count; ++r) {
      const ClusterRun run = block_.runs[r];
      for (std::uint32_t c = run.begin; c < run.end; c += lanes) {
        auto mask = isNear(c);
        mask = hn::And(mask, hn::FirstN(d, run.end - c));
        size_ += packStore(w, hn::Iota(w, c), hn::RebindMask(w, mask), near + size_);
      }
    }
  }

  HWY_INLINE hn::MFromD<Floats>
  isNear(std::uint32_t c) const
  {
    const Floats d;
    const auto apart = [&](std::size_t axis, float least, float most) {
      const auto low = hn::LoadU(d, block_.cluster_box[axis] + c);
      const auto high = hn::LoadU(d, block_.cluster_box[axis + 3] + c);
      return hn::Max(
          hn::Max(hn::Sub(hn::Set(d, least), high), hn::Sub(low, hn::Set(d, most))),
          hn::Zero(d));
    };
    const Box& box = block_.box;
    const auto d2 = squaredLength(apart(0, box.x_min, box.x_max),
                                  apart(1, box.y_min, box.y_max),
                                  apart(2, box.z_min, box.z_max));
    return hn::Lt(d2, hn::Set(d, reach2_));
  }

  const SweepBlock& block_;
  float reach2_ = 0.0f, sure_reach2_ = 0.0f;
  bool has_ties_ = false;
  std::size_t size_ = 0;
};

/** \brief A vector of points. */
struct Points {
  hn::VFromD<Floats> x, y, z;
};

/** \brief Which lanes hold points of a cluster of `size`, from its `first` on. */
HWY_INLINE hn::MFromD<Floats>
pointsOfCluster(std::uint32_t size, std::size_t first)
{
  return hn::FirstN(Floats(), size > first ? size - first : 0);
}

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

/** \brief Lists points that may be a neighbor of a query of the block, and apart those
 * that surely are one of all queries. */
class CandidateLister {
public:
  CandidateLister(const NearClusters& near,
                  const Box& box,
                  std::size_t clusters,
                  bool with_sure)
  {
    const Floats d;
    const std::size_t most = clusters * block_size + lanes;
    some_ = simdScratch().offsets.atLeast(2 * most);
    sure_ = some_ + most;
    reach2_ = hn::Set(d, near.reach2());
    sure_reach2_ = hn::Set(d, near.sureReach2());
    x_min_ = hn::Set(d, box.x_min), x_max_ = hn::Set(d, box.x_max);
    y_min_ = hn::Set(d, box.y_min), y_max_ = hn::Set(d, box.y_max);
    z_min_ = hn::Set(d, box.z_min), z_max_ = hn::Set(d, box.z_max);
    // Nothing is nearer to all corners than half the diagonal.
    const float dx = box.x_max - box.x_min, dy = box.y_max - box.y_min,
                dz = box.z_max - box.z_min;
    with_sure_ = with_sure && 0.5f * (dx * dx + dy * dy + dz * dz) < near.sureReach2();
  }

  /** \brief Those near enough to the queries' box, among lanes that count; the first
   * one is known by this number. */
  HWY_INLINE hn::MFromD<Floats>
  add(const Points& points, hn::MFromD<Floats> counts, std::size_t number)
  {
    const Floats d;
    const Words w;
    const auto numbers = hn::Iota(w, static_cast<std::uint32_t>(number));
    const auto x_low = hn::Sub(x_min_, points.x), x_high = hn::Sub(points.x, x_max_);
    const auto y_low = hn::Sub(y_min_, points.y), y_high = hn::Sub(points.y, y_max_);
    const auto z_low = hn::Sub(z_min_, points.z), z_high = hn::Sub(points.z, z_max_);
    const auto outside = [&](auto low, auto high) {
      return hn::Max(hn::Max(low, high), hn::Zero(d));
    };
    const auto least2 = squaredLength(
        outside(x_low, x_high), outside(y_low, y_high), outside(z_low, z_high));
    const auto mask = hn::And(hn::Lt(least2, reach2_), counts);
    auto rest = mask;
    if (with_sure_) {
      const auto most2 = squaredLength(
          hn::Min(x_low, x_high), hn::Min(y_low, y_high), hn::Min(z_low, z_high));
      const auto sure = hn::And(hn::Lt(most2, sure_reach2_), mask);
      sure_size_ += packStore(w, numbers, hn::RebindMask(w, sure), sure_ + sure_size_);
      rest = hn::AndNot(sure, mask);
    }
    some_size_ += packStore(w, numbers, hn::RebindMask(w, rest), some_ + some_size_);
    return mask;
  }

  const std::uint32_t*
  some() const
  {
    return some_;
  }

  std::size_t
  someSize() const
  {
    return some_size_;
  }

  const std::uint32_t*
  sure() const
  {
    return sure_;
  }

  std::size_t
  sureSize() const
  {
    return sure_size_;
  }

private:
  hn::VFromD<Floats> reach2_, sure_reach2_;
  hn::VFromD<Floats> x_min_, x_max_, y_min_, y_max_, z_min_, z_max_;
  bool with_sure_;
  std::uint32_t *some_, *sure_;
  std::size_t some_size_ = 0, sure_size_ = 0;
};

/** \brief Candidates, as positions of the surface. */
struct CandidatePositions {
  const std::uint32_t* begin; ///< of those that may be neighbors
  std::size_t size;
  const std::uint32_t* sure; ///< of those that are neighbors of all queries
  std::size_t sure_size;

  std::size_t
  total() const
  {
    return size + sure_size;
  }
};

/** \brief Lists candidates among some of the near clusters, without copying them:
 * accept() adds those of a vector of points that count to the lister. */
template <typename Accept>
HWY_INLINE CandidatePositions
listPositions(const SweepBlock& block,
              const NearClusters& near,
              std::size_t begin,
              std::size_t count,
              bool with_sure,
              const Accept& accept)
{
  const Floats d;
  CandidateLister lister(near, block.box, count, with_sure);
  for (std::size_t s = begin; s < begin + count; ++s) {
    const std::uint32_t cluster = near.begin()[s];
    const std::uint32_t first = block.cluster_begin[cluster];
    const std::uint32_t size = block.cluster_begin[cluster + 1] - first;
    for (std::uint32_t i = 0; i < size; i += lanes) {
      const std::uint32_t position = first + i;
      const Points points{hn::LoadU(d, block.x + position),
                          hn::LoadU(d, block.y + position),
                          hn::LoadU(d, block.z + position)};
      accept(points, pointsOfCluster(size, i), position, lister);
    }
  }
  return {lister.some(), lister.someSize(), lister.sure(), lister.sureSize()};
}

/** \brief Candidates, as offsets of lanes of slots. */
struct CandidateList {
  const float* slots;
  const std::uint32_t* offsets;
  std::size_t size;
};

/** \brief Fills slots of this stride with some of the near clusters: fill(position,
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
  CandidateLister lister(near, block.box, count, false);
  for (std::size_t s = 0; s < count; ++s) {
    const std::uint32_t cluster = near.begin()[begin + s];
    const std::uint32_t first = block.cluster_begin[cluster];
    const std::uint32_t size = block.cluster_begin[cluster + 1] - first;
    for (std::size_t i = 0; i < size; i += lanes) {
      const std::size_t offset = s * stride + i;
      const Points points = stagePoints<with_order>(block, first + i, slots + offset);
      fill(points, first + i, slots + offset, pointsOfCluster(size, i), offset, lister);
    }
  }
  return {slots, lister.some(), lister.someSize()};
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

  /** \brief Whether the point at this position of the surface is a neighbor. */
  HWY_INLINE hn::MFromD<Floats>
  neighborMask(const SweepBlock& block, std::size_t position) const
  {
    const std::uint32_t order = with_ties ? block.order[position] : 0;
    return neighborMask(block.x[position], block.y[position], block.z[position], order);
  }

  /** \brief The same of a point in a slot. */
  HWY_INLINE hn::MFromD<Floats>
  neighborMask(const float* candidate) const
  {
    std::uint32_t order = 0;
    if constexpr (with_ties) {
      std::memcpy(&order, candidate + slot_order * block_size, sizeof(order));
    }
    return neighborMask(candidate[slot_x * block_size],
                        candidate[slot_y * block_size],
                        candidate[slot_z * block_size],
                        order);
  }

private:
  HWY_INLINE hn::MFromD<Floats>
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

  hn::VFromD<Floats> x_, y_, z_, r2_, tie_d2_;
  hn::VFromD<Ints> tie_index_;
};

} // namespace pcl::kernels::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
