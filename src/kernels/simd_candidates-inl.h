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

#include "simd_common-inl.h"

HWY_BEFORE_NAMESPACE();
namespace pcl {
namespace kernels {
namespace HWY_NAMESPACE {

/** \brief Packs the surface points that are near a block's box, portion by portion. */
class CandidatePacker {
public:
  CandidatePacker(const SweepBlock& block, Candidates& candidates)
  : block_(block)
  , candidates_(candidates)
  {
    const auto range = [&](const float* v, float& least, float& most) {
      least = *std::min_element(v, v + block.size);
      most = *std::max_element(v, v + block.size);
    };
    range(block.qx, x_min_, x_max_);
    range(block.qy, y_min_, y_max_);
    range(block.qz, z_min_, z_max_);
    float largest = 0.0f;
    for (std::size_t i = 0; i < block.size; ++i) {
      largest = std::max({largest, block.r2[i], block.tie_d2[i]});
      has_ties_ = has_ties_ || block.tie_d2[i] >= 0.0f;
    }
    // The box may be nearer than a query, never further, but for rounding.
    reach2_ = largest * (1.0f + 1e-5f) + std::numeric_limits<float>::min();
    position_ = block.run_count > 0 ? block.runs[0].begin : 0;
  }

  bool
  hasTies() const
  {
    return has_ties_;
  }

  /** \brief Whether next() has been through all runs. */
  bool
  isDone() const
  {
    return run_ == block_.run_count;
  }

  /** \brief Pack the next candidates.
   * \tparam with_normals their normals as well; points without one are left out */
  template <bool with_normals>
  void
  next()
  {
    candidates_.allocate();
    std::size_t size = 0;
    while (!isDone() && size + lanes <= portion_size) {
      const std::uint32_t end = block_.runs[run_].end;
      for (; position_ < end && size + lanes <= portion_size; position_ += lanes) {
        size += pack<with_normals>(position_, end, size);
      }
      if (position_ >= end && ++run_ < block_.run_count) {
        position_ = block_.runs[run_].begin;
      }
    }
    candidates_.size = size;
    const Floats d;
    // Points at NaN fill the last vector: they are nobody's neighbor.
    const auto nan = hn::Set(d, std::numeric_limits<float>::quiet_NaN());
    hn::StoreU(nan, d, candidates_.x() + size);
    hn::StoreU(nan, d, candidates_.y() + size);
    hn::StoreU(nan, d, candidates_.z() + size);
  }

private:
  template <bool with_normals>
  HWY_INLINE std::size_t
  pack(std::uint32_t j, std::uint32_t end, std::size_t size)
  {
    const Floats d;
    const auto x = hn::LoadU(d, block_.x + j);
    const auto y = hn::LoadU(d, block_.y + j);
    const auto z = hn::LoadU(d, block_.z + j);
    const auto outside = [&](auto v, float least, float most) {
      return hn::Max(
          hn::Max(hn::Sub(hn::Set(d, least), v), hn::Sub(v, hn::Set(d, most))),
          hn::Zero(d));
    };
    const auto d2 = squaredLength(outside(x, x_min_, x_max_),
                                  outside(y, y_min_, y_max_),
                                  outside(z, z_min_, z_max_));
    auto mask = hn::Lt(d2, hn::Set(d, reach2_));
    if (end - j < lanes) {
      mask = hn::And(mask, hn::FirstN(d, end - j));
    }
    Candidates& c = candidates_;
    if (with_normals) {
      const auto nx = hn::LoadU(d, block_.nx + j);
      mask = hn::And(mask, hn::Eq(nx, nx));
      packStore(d, nx, mask, c.nx() + size);
      packStore(d, hn::LoadU(d, block_.ny + j), mask, c.ny() + size);
      packStore(d, hn::LoadU(d, block_.nz + j), mask, c.nz() + size);
    }
    if (has_ties_) {
      const Words w;
      packStore(
          w, hn::LoadU(w, block_.order + j), hn::RebindMask(w, mask), c.order() + size);
    }
    packStore(d, x, mask, c.x() + size);
    packStore(d, y, mask, c.y() + size);
    return packStore(d, z, mask, c.z() + size);
  }

  const SweepBlock& block_;
  Candidates& candidates_;
  float x_min_, x_max_, y_min_, y_max_, z_min_, z_max_;
  float reach2_ = 0.0f;
  bool has_ties_ = false;
  std::size_t run_ = 0;
  std::uint32_t position_ = 0;
};

/** \brief Which of the candidates from c on are neighbors of a query. */
template <bool with_ties, class V>
HWY_INLINE auto
neighborMask(const SweepBlock& block,
             std::size_t query,
             const Candidates& candidates,
             std::size_t c,
             V d2)
{
  const Floats d;
  const auto near = hn::Lt(d2, hn::Set(d, block.r2[query]));
  if constexpr (with_ties) {
    const Words w;
    const auto order = hn::LoadU(w, candidates.order() + c);
    const auto most =
        hn::Set(Ints(), static_cast<std::int32_t>(block.tie_index[query]));
    const auto first = hn::Not(hn::Gt(hn::BitCast(Ints(), order), most));
    const auto equal = hn::Eq(d2, hn::Set(d, block.tie_d2[query]));
    return hn::Or(near, hn::And(equal, hn::RebindMask(d, first)));
  }
  else {
    return near;
  }
}

} // namespace HWY_NAMESPACE
} // namespace kernels
} // namespace pcl
HWY_AFTER_NAMESPACE();

#endif
