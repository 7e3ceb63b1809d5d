/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * Point Cloud Library (PCL) - www.pointclouds.org
 * Copyright (c) 2026, pcl_shape contributors
 *
 * All rights reserved
 */

#if defined(PCL_SHAPE_SIMD_INAD_CANDIDATES_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef PCL_SHAPE_SIMD_INAD_CANDIDATES_INL_H_
#undef PCL_SHAPE_SIMD_INAD_CANDIDATES_INL_H_
#else
#define PCL_SHAPE_SIMD_INAD_CANDIDATES_INL_H_
#endif

#include "simd_near_clusters-inl.h"

#include <cmath>

HWY_BEFORE_NAMESPACE();
namespace pcl::kernels::HWY_NAMESPACE {

/** \brief Points with a normal that may be neighbors of a block's queries, packed, and
 * apart those that surely are of all. */
struct INADSlots {
  enum Array { x, y, z, nx, ny, nz, order, array_count };

  const float* arrays[array_count]; ///< of those that may be; the last vector has NaN
  std::size_t size;
  const std::uint32_t* sure; ///< where in the surface vectors of those that are begin
  std::size_t sure_size;     ///< how many vectors

  std::size_t
  total() const
  {
    return size + sure_size * lanes;
  }
};

/** \brief Finds candidates with a normal, and whether all normals are on one side. */
class INADCandidates {
public:
  INADCandidates(const SweepBlock& block,
                 const OwnPoints& own,
                 const NearClusters& near)
  : block_(block)
  , near_(near)
  {
    std::size_t first = 0;
    while (first + 1 < block.size && std::isnan(own.nx[first])) {
      ++first;
    }
    x_ = own.nx[first];
    y_ = own.ny[first];
    z_ = own.nz[first];
    for (std::size_t i = 0; i < block.size; ++i) {
      const float cosine = own.nx[i] * x_ + own.ny[i] * y_ + own.nz[i] * z_;
      // Not for NaN.
      own_cosine_ = cosine < own_cosine_ ? cosine : own_cosine_;
    }
  }

  /** \brief Those among some of the near clusters. */
  INADSlots
  list(std::size_t begin, std::size_t count)
  {
    return near_.hasTies() ? list<true>(begin, count) : list<false>(begin, count);
  }

  /** \brief Whether all normals make at most a right angle with all queries': theirs
   * and the queries' angles to one of these are together less. */
  bool
  isSmooth() const
  {
    constexpr float margin = 1e-4f;
    return own_cosine_ > 0.0f && least_cosine_ > 0.0f &&
           own_cosine_ * own_cosine_ + least_cosine_ * least_cosine_ > 1.0f + margin;
  }

private:
  /** \brief Slots for that many points, and where to write them. */
  INADSlots
  emptySlots(std::size_t most, float** arrays) const
  {
    INADSlots slots{};
    float* floats = simdScratch().slots.atLeast(INADSlots::array_count * most);
    for (std::size_t array = 0; array < INADSlots::array_count; ++array) {
      slots.arrays[array] = arrays[array] = floats + array * most;
    }
    return slots;
  }

  /** What the loop works with is local: what it writes might be a member. */
  template <bool with_ties>
  HWY_NOINLINE INADSlots
  list(std::size_t begin, std::size_t count)
  {
    const Floats d;
    const SweepBlock block = block_;
    const std::size_t most = count * block_size + lanes;
    float* out[INADSlots::array_count];
    INADSlots slots = emptySlots(most, out);
    std::uint32_t* sure_vectors = simdScratch().offsets.atLeast(most);
    const std::uint32_t* near = near_.begin() + begin;
    const BoxDistances distances(block.box);
    const auto reach2 = hn::Set(d, near_.reach2());
    const auto sure_reach2 = hn::Set(d, with_ties ? -1.0f : near_.sureReach2());
    const auto x = hn::Set(d, x_), y = hn::Set(d, y_), z = hn::Set(d, z_);
    auto least_cosine = hn::Set(d, 1.0f);
    std::size_t size = 0, sure_size = 0;
    for (std::size_t s = 0; s < count; ++s) {
      const std::uint32_t first = block.cluster_begin[near[s]];
      const std::uint32_t points = block.cluster_begin[near[s] + 1] - first;
      for (std::uint32_t i = 0; i < points; i += lanes) {
        const std::uint32_t j = first + i;
        const auto px = hn::LoadU(d, block.x + j), py = hn::LoadU(d, block.y + j),
                   pz = hn::LoadU(d, block.z + j);
        const auto nx = hn::LoadU(d, block.nx + j), ny = hn::LoadU(d, block.ny + j),
                   nz = hn::LoadU(d, block.nz + j);
        const auto squares = distances.of(px, py, pz);
        const auto mask = hn::And(hn::And(pointsOfCluster(points, i), hn::Eq(nx, nx)),
                                  hn::Lt(squares.least2, reach2));
        const auto cosine = hn::MulAdd(nx, x, hn::MulAdd(ny, y, hn::Mul(nz, z)));
        least_cosine =
            hn::Min(least_cosine, hn::IfThenElse(mask, cosine, hn::Set(d, 1.0f)));
        if (hn::AllTrue(d, hn::And(hn::Lt(squares.most2, sure_reach2), mask))) {
          sure_vectors[sure_size++] = j;
          continue;
        }
        packStore(d, px, mask, out[INADSlots::x] + size);
        packStore(d, py, mask, out[INADSlots::y] + size);
        packStore(d, pz, mask, out[INADSlots::z] + size);
        packStore(d, nx, mask, out[INADSlots::nx] + size);
        packStore(d, ny, mask, out[INADSlots::ny] + size);
        if constexpr (with_ties) {
          const auto order = hn::BitCast(d, hn::LoadU(Words(), block.order + j));
          packStore(d, order, mask, out[INADSlots::order] + size);
        }
        size += packStore(d, nz, mask, out[INADSlots::nz] + size);
      }
    }
    for (const auto array : {INADSlots::x, INADSlots::y, INADSlots::z}) {
      hn::StoreU(hn::NaN(d), d, out[array] + size);
    }
    least_cosine_ = hn::GetLane(hn::MinOfLanes(d, least_cosine));
    slots.size = size;
    slots.sure = sure_vectors;
    slots.sure_size = sure_size;
    return slots;
  }

  const SweepBlock& block_;
  const NearClusters& near_;
  float x_, y_, z_; ///< a query's normal
  float own_cosine_ = 1.0f;
  float least_cosine_ = 1.0f;
};

} // namespace pcl::kernels::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
