/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * Point Cloud Library (PCL) - www.pointclouds.org
 * Copyright (c) 2026, pcl_shape contributors
 *
 * All rights reserved
 */

#if defined(PCL_SHAPE_SIMD_CANDIDATES_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef PCL_SHAPE_SIMD_CANDIDATES_INL_H_
#undef PCL_SHAPE_SIMD_CANDIDATES_INL_H_
#else
#define PCL_SHAPE_SIMD_CANDIDATES_INL_H_
#endif

#include "simd_near_clusters-inl.h"

HWY_BEFORE_NAMESPACE();
namespace pcl::kernels::HWY_NAMESPACE {

/** \brief A vector of points. */
struct Points {
  hn::VFromD<Floats> x, y, z;
};

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

} // namespace pcl::kernels::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
