/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * Point Cloud Library (PCL) - www.pointclouds.org
 * Copyright (c) 2026, pcl_shape contributors
 *
 * All rights reserved
 */

#if defined(PCL_SHAPE_SIMD_NEAR_CLUSTERS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef PCL_SHAPE_SIMD_NEAR_CLUSTERS_INL_H_
#undef PCL_SHAPE_SIMD_NEAR_CLUSTERS_INL_H_
#else
#define PCL_SHAPE_SIMD_NEAR_CLUSTERS_INL_H_
#endif

#include "simd_box_distances-inl.h"

HWY_BEFORE_NAMESPACE();
namespace pcl::kernels::HWY_NAMESPACE {

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
    for (std::size_t r = 0; r < block_.run_count; ++r) {
      most += block_.runs[r].end - block_.runs[r].begin;
    }
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

} // namespace pcl::kernels::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
