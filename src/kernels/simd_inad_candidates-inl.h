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

#include "simd_candidates-inl.h"

#include <cmath>

HWY_BEFORE_NAMESPACE();
namespace pcl::kernels::HWY_NAMESPACE {

/** \brief Finds candidates with a normal, and whether all normals are on one side. */
class INADCandidates {
public:
  INADCandidates(const SweepBlock& block, const OwnPoints& own) : block_(block)
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
  CandidatePositions
  list(const NearClusters& near, std::size_t begin, std::size_t count)
  {
    const Floats d;
    auto least = hn::Set(d, 1.0f);
    const auto accept = [&](const Points& points,
                            auto is_point,
                            std::uint32_t position,
                            CandidateLister& lister) {
      const auto nx = hn::LoadU(d, block_.nx + position);
      const auto is_candidate =
          lister.add(points, hn::And(is_point, hn::Eq(nx, nx)), position);
      least = hn::Min(
          least,
          hn::IfThenElse(is_candidate, cosinesAt(nx, position), hn::Set(d, 1.0f)));
    };
    const CandidatePositions positions =
        listPositions(block_, near, begin, count, !near.hasTies(), accept);
    least_cosine_ = hn::GetLane(hn::MinOfLanes(d, least));
    return positions;
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
  HWY_INLINE hn::VFromD<Floats>
  cosinesAt(hn::VFromD<Floats> nx, std::size_t position) const
  {
    const Floats d;
    const auto ny = hn::LoadU(d, block_.ny + position);
    const auto nz = hn::LoadU(d, block_.nz + position);
    return hn::MulAdd(nx,
                      hn::Set(d, x_),
                      hn::MulAdd(ny, hn::Set(d, y_), hn::Mul(nz, hn::Set(d, z_))));
  }

  const SweepBlock& block_;
  float x_, y_, z_; ///< a query's normal
  float own_cosine_ = 1.0f;
  float least_cosine_ = 1.0f;
};

} // namespace pcl::kernels::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
