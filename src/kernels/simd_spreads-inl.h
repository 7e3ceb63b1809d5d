/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * Point Cloud Library (PCL) - www.pointclouds.org
 * Copyright (c) 2026, pcl_shape contributors
 *
 * All rights reserved
 */

#if defined(PCL_SHAPE_SIMD_SPREADS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef PCL_SHAPE_SIMD_SPREADS_INL_H_
#undef PCL_SHAPE_SIMD_SPREADS_INL_H_
#else
#define PCL_SHAPE_SIMD_SPREADS_INL_H_
#endif

#include "simd_inad_candidates-inl.h"

HWY_BEFORE_NAMESPACE();
namespace pcl::kernels::HWY_NAMESPACE {

/** \brief Finds out which queries have neighbors that spread over a surface: one that
 * makes, with another (the anchor), a parallelogram larger than those on a line can
 * make. geometry_check.h: two offsets within 1e-3 r of one line span less than 2.1e-3
 * r^2. Lanes are queries.
 */
class SpreadFinder {
public:
  SpreadFinder(const SweepBlock& block, std::size_t first)
  {
    const Floats d;
    x_ = hn::LoadU(d, block.qx + first);
    y_ = hn::LoadU(d, block.qy + first);
    z_ = hn::LoadU(d, block.qz + first);
    // Of k nearest, the furthest may be left out: enough others are looked at.
    r2_ = hn::LoadU(d, block.r2 + first);
    const auto reach2 = hn::Max(r2_, hn::LoadU(d, block.tie_d2 + first));
    // What is too small for all digits of a float is left to others.
    least_cross2_ = hn::Max(hn::Mul(hn::Set(d, 4.5e-6f), hn::Mul(reach2, reach2)),
                            hn::Set(d, std::numeric_limits<float>::min()));
    furthest_ = anchor_x_ = anchor_y_ = anchor_z_ = hn::Zero(d);
    spreads_ = hn::Zero(d);
    is_query_ = hn::FirstN(d, block.size - first);
  }

  /** \brief Compares a point with the anchor. The furthest neighbor so far becomes it.
   */
  HWY_INLINE void
  look(float x, float y, float z)
  {
    const Floats d;
    const auto dx = hn::Sub(hn::Set(d, x), x_);
    const auto dy = hn::Sub(hn::Set(d, y), y_);
    const auto dz = hn::Sub(hn::Set(d, z), z_);
    const auto d2 = squaredLength(dx, dy, dz);
    const auto is_neighbor = hn::Lt(d2, r2_);
    const auto cross2 =
        roughSquaredLength(hn::MulSub(anchor_y_, dz, hn::Mul(anchor_z_, dy)),
                           hn::MulSub(anchor_z_, dx, hn::Mul(anchor_x_, dz)),
                           hn::MulSub(anchor_x_, dy, hn::Mul(anchor_y_, dx)));
    const auto spreads = hn::And(is_neighbor, hn::Gt(cross2, least_cross2_));
    spreads_ = hn::IfThenElse(spreads, hn::Set(d, 1.0f), spreads_);
    const auto further = hn::And(is_neighbor, hn::Gt(d2, furthest_));
    furthest_ = hn::IfThenElse(further, d2, furthest_);
    anchor_x_ = hn::IfThenElse(further, dx, anchor_x_);
    anchor_y_ = hn::IfThenElse(further, dy, anchor_y_);
    anchor_z_ = hn::IfThenElse(further, dz, anchor_z_);
  }

  /** \brief Whether the neighbors of all queries spread over a surface, so far. */
  HWY_INLINE bool
  hasAll() const
  {
    const Floats d;
    return hn::AllFalse(d, hn::And(is_query_, hn::Eq(spreads_, hn::Zero(d))));
  }

  HWY_INLINE void
  store(std::size_t first, bool* spreads) const
  {
    HWY_ALIGN float found[lanes];
    hn::Store(spreads_, Floats(), found);
    for (std::size_t lane = 0; lane < lanes; ++lane) {
      spreads[first + lane] = spreads[first + lane] || found[lane] != 0.0f;
    }
  }

private:
  hn::VFromD<Floats> x_, y_, z_, r2_, least_cross2_;
  hn::VFromD<Floats> furthest_, anchor_x_, anchor_y_, anchor_z_, spreads_;
  MaskOf<Floats> is_query_;
};

/** \brief Whether the queries do, which are surface points: mostly, a few of them tell.
 */
HWY_INLINE void
findSpreadsAmongQueries(const SweepBlock& block, bool* spreads)
{
  constexpr std::size_t step = 5;
  for (std::size_t first = 0; first < block.size; first += lanes) {
    SpreadFinder finder(block, first);
    for (std::size_t begin = 0; begin < step && !finder.hasAll(); ++begin) {
      for (std::size_t j = begin; j < block.size; j += step) {
        finder.look(block.qx[j], block.qy[j], block.qz[j]);
      }
    }
    finder.store(first, spreads);
  }
}

/** \brief Whether every `step`-th candidate does, those left aside that surely are
 * neighbors. */
HWY_INLINE void
findSpreads(const SweepBlock& block,
            const INADSlots& slots,
            std::size_t step,
            bool* spreads)
{
  const float* x = slots.arrays[INADSlots::x];
  const float* y = slots.arrays[INADSlots::y];
  const float* z = slots.arrays[INADSlots::z];
  for (std::size_t first = 0; first < block.size; first += lanes) {
    SpreadFinder finder(block, first);
    for (std::size_t c = 0; c < slots.size; c += step) {
      finder.look(x[c], y[c], z[c]);
    }
    finder.store(first, spreads);
  }
}

} // namespace pcl::kernels::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
