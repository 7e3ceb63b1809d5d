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
namespace pcl::kernels::HWY_NAMESPACE {

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

  /** \brief Turn normals to the side of this one, for isSmoothAround(). */
  void
  setReference(float x, float y, float z)
  {
    reference_[0] = x;
    reference_[1] = y;
    reference_[2] = z;
  }

  /** \brief Whether a normal at this cosine (absolute) from the reference makes an
   * angle of at most a right one with all candidates' normals: theirs and its own to
   * the reference are together less. */
  bool
  isSmoothAround(float cosine) const
  {
    constexpr float margin = 1e-4f;
    return cosine * cosine + least_cosine_ * least_cosine_ > 1.0f + margin;
  }

  /** \brief Pack the next candidates.
   * \tparam with_normals their normals as well; points without one are left out */
  template <bool with_normals>
  void
  next()
  {
    candidates_.allocate();
    least_cosine_ = 1.0f;
    std::size_t size = 0;
    while (!isDone() && size + lanes <= portion_size) {
      size = has_ties_ ? packRun<with_normals, true>(size)
                       : packRun<with_normals, false>(size);
      if (position_ >= block_.runs[run_].end && ++run_ < block_.run_count) {
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
  /** \brief By how much coordinates are outside of an interval. */
  template <class V>
  static HWY_INLINE V
  outside(V v, V least, V most)
  {
    return hn::Max(hn::Max(hn::Sub(least, v), hn::Sub(v, most)), hn::Zero(Floats()));
  }

  /** \brief Pack what is left of a run, as far as there is room. Returns the new size.
   */
  template <bool with_normals, bool with_ties>
  HWY_INLINE std::size_t
  packRun(std::size_t size)
  {
    const Floats d;
    const auto x_min = hn::Set(d, x_min_), x_max = hn::Set(d, x_max_);
    const auto y_min = hn::Set(d, y_min_), y_max = hn::Set(d, y_max_);
    const auto z_min = hn::Set(d, z_min_), z_max = hn::Set(d, z_max_);
    const auto reach2 = hn::Set(d, reach2_);
    const float* HWY_RESTRICT from_x = block_.x;
    const float* HWY_RESTRICT from_y = block_.y;
    const float* HWY_RESTRICT from_z = block_.z;
    float* HWY_RESTRICT to = candidates_.x();
    constexpr std::size_t stride = Candidates::stride;
    const std::uint32_t end = block_.runs[run_].end;
    auto least_cosine = hn::Set(d, least_cosine_);
    std::uint32_t j = position_;
    for (; j < end && size + lanes <= portion_size; j += lanes) {
      const auto x = hn::LoadU(d, from_x + j);
      const auto y = hn::LoadU(d, from_y + j);
      const auto z = hn::LoadU(d, from_z + j);
      const auto d2 = squaredLength(
          outside(x, x_min, x_max), outside(y, y_min, y_max), outside(z, z_min, z_max));
      auto mask = hn::Lt(d2, reach2);
      if (HWY_UNLIKELY(end - j < lanes)) {
        mask = hn::And(mask, hn::FirstN(d, end - j));
      }
      if constexpr (with_normals) {
        const auto nx = hn::LoadU(d, block_.nx + j);
        const auto ny = hn::LoadU(d, block_.ny + j);
        const auto nz = hn::LoadU(d, block_.nz + j);
        mask = hn::And(mask, hn::Eq(nx, nx));
        const auto cosine = hn::MulAdd(
            nx,
            hn::Set(d, reference_[0]),
            hn::MulAdd(
                ny, hn::Set(d, reference_[1]), hn::Mul(nz, hn::Set(d, reference_[2]))));
        const auto sign = hn::And(cosine, hn::Set(d, -0.0f));
        least_cosine = hn::Min(least_cosine,
                               hn::IfThenElse(mask, hn::Abs(cosine), hn::Set(d, 1.0f)));
        packStore(d, hn::Xor(nx, sign), mask, to + 3 * stride + size);
        packStore(d, hn::Xor(ny, sign), mask, to + 4 * stride + size);
        packStore(d, hn::Xor(nz, sign), mask, to + 5 * stride + size);
      }
      if constexpr (with_ties) {
        const Words w;
        packStore(w,
                  hn::LoadU(w, block_.order + j),
                  hn::RebindMask(w, mask),
                  candidates_.order() + size);
      }
      packStore(d, x, mask, to + size);
      packStore(d, y, mask, to + stride + size);
      size += packStore(d, z, mask, to + 2 * stride + size);
    }
    position_ = j;
    least_cosine_ = hn::GetLane(hn::MinOfLanes(d, least_cosine));
    return size;
  }

  const SweepBlock& block_;
  Candidates& candidates_;
  float x_min_, x_max_, y_min_, y_max_, z_min_, z_max_;
  float reach2_ = 0.0f;
  float reference_[3] = {0.0f, 0.0f, 1.0f};
  float least_cosine_ = 1.0f;
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

} // namespace pcl::kernels::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
