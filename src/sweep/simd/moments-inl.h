// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// PURPOSE

#if defined(PCL_SHAPE_SWEEP_MOMENTS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef PCL_SHAPE_SWEEP_MOMENTS_INL_H_
#undef PCL_SHAPE_SWEEP_MOMENTS_INL_H_
#else
#define PCL_SHAPE_SWEEP_MOMENTS_INL_H_
#endif

#include "sweep/portable/moments.h"
#include "sweep/portable/neighborhood.h"
#include "sweep/simd/candidates-inl.h"
#include "sweep/simd/common-inl.h"

#include <cmath>

HWY_BEFORE_NAMESPACE();
namespace pcl::kernels::HWY_NAMESPACE {

/** \brief Offsets are counted in 2^(level - 20): the radius is below 2^level. */
inline int
levelOf(float r2)
{
  int exponent = 0;
  std::frexp(r2, &exponent);
  if (std::isinf(r2))
    return 64;
  return exponent > 0 ? (exponent + 1) / 2 : exponent / 2;
}

/** \brief Candidates' coordinates in units from an origin, as 32-bit words. Those
 * that are no neighbor of anybody may have no meaning.
 *
 * Units are a power of two, so that scaling is exact and rounding does not depend on
 * the origin.
 */
class Quantizer {
public:
  /** \param[in] largest the largest coordinate of a neighbor, absolute, in units */
  Quantizer(int level, const double* origin, double largest)
  : scale_(std::ldexp(1.0, offset_bits - level))
  , fits_(largest < (1 << 30) && std::abs(level) < 100)
  , origin_(origin)
  {}

  HWY_INLINE hn::VFromD<Words>
  operator()(hn::VFromD<Floats> v, std::size_t axis) const
  {
    const Floats d;
    if (HWY_LIKELY(fits_)) {
      const auto origin = hn::Set(Ints(), static_cast<std::int32_t>(origin_[axis]));
      const auto units = nearestInt(hn::Mul(v, hn::Set(d, static_cast<float>(scale_))));
      return hn::BitCast(Words(), hn::Sub(units, origin));
    }
    const hn::Half<Floats> h;
    const auto low = quantize(hn::LowerHalf(h, v), axis);
    const auto high = quantize(hn::UpperHalf(h, v), axis);
    return hn::BitCast(Words(), hn::Combine(Ints(), high, low));
  }

private:
  template <class V>
  HWY_INLINE hn::VFromD<hn::Half<Ints>>
  quantize(V v, std::size_t axis) const
  {
    const hn::Rebind<double, hn::Half<Floats>> d;
    const auto units = hn::Round(hn::Mul(hn::PromoteTo(d, v), hn::Set(d, scale_)));
    return hn::DemoteTo(hn::Half<Ints>(), hn::Sub(units, hn::Set(d, origin_[axis])));
  }

  double scale_;
  bool fits_;
  const double* origin_;
};

/** \brief Writes both halves of the 64-bit products of two vectors of words. */
HWY_INLINE void
storeProduct(hn::VFromD<Words> a,
             hn::VFromD<Words> b,
             std::uint32_t* low,
             std::uint32_t* high)
{
  const Words w;
  const Longs l;
  const auto odd = [&](auto v) {
    return hn::BitCast(w, hn::ShiftRight<32>(hn::BitCast(l, v)));
  };
  const auto even_product = hn::MulEven(a, b);
  const auto odd_product = hn::MulEven(odd(a), odd(b));
  const auto mask = hn::Set(l, (std::uint64_t{1} << half_bits) - 1);
  const auto interleave = [&](auto even, auto odd_lanes) {
    return hn::BitCast(w, hn::Or(even, hn::ShiftLeft<32>(odd_lanes)));
  };
  hn::Store(
      interleave(hn::And(even_product, mask), hn::And(odd_product, mask)), w, low);
  hn::Store(interleave(hn::And(hn::ShiftRight<half_bits>(even_product),
                               hn::Set(l, 0xffffffffu)),
                       hn::ShiftRight<half_bits>(odd_product)),
            w,
            high);
}

constexpr std::size_t moments_stride = slot_stride<moment_count>;

/** \brief Where a candidate's moment is, from where its x is. */
constexpr std::size_t
momentAt(std::size_t moment)
{
  return (slot_common + moment) * block_size;
}

/** \brief Writes the moments of a vector of points into their slot. */
HWY_INLINE void
stageMoments(const Quantizer& quantizer, const Points& points, float* slot)
{
  const Words w;
  const auto x = quantizer(points.x, 0);
  const auto y = quantizer(points.y, 1);
  const auto z = quantizer(points.z, 2);
  auto* words = reinterpret_cast<std::uint32_t*>(slot);
  const auto at = [&](std::size_t moment) { return words + momentAt(moment); };
  hn::Store(x, w, at(sum_x));
  hn::Store(y, w, at(sum_y));
  hn::Store(z, w, at(sum_z));
  storeProduct(x, x, at(low_xx), at(high_xx));
  storeProduct(x, y, at(low_xy), at(high_xy));
  storeProduct(x, z, at(low_xz), at(high_xz));
  storeProduct(y, y, at(low_yy), at(high_yy));
  storeProduct(y, z, at(low_yz), at(high_yz));
  storeProduct(z, z, at(low_zz), at(high_zz));
}

/** 512 halves of products fit in 32 bits. */
constexpr std::size_t candidates_between_widening = 512;

#if HWY_TARGET <= HWY_AVX3

/** \brief sum += value where the mask is set: one instruction, which GCC 12 does not
 * find. */
HWY_INLINE void
addWhere(__mmask16 mask, __m512i& sum, const std::uint32_t* value)
{
  asm("vpaddd %2%{1to16%}, %0, %0%{%1%}" : "+v"(sum) : "Yk"(mask), "m"(*value));
}

/** \brief All moments at once: there are registers enough, if the compiler sees each
 * sum as a variable of its own. */
template <bool with_ties>
HWY_NOINLINE void
addMoments(const QueryLanes<with_ties>& lanes_queries,
           const float* slots,
           const std::uint32_t* offsets,
           std::size_t begin,
           std::size_t end,
           std::size_t first_lane,
           BlockMoments& block)
{
  const QueryLanes<with_ties> queries = lanes_queries;
  const __m512i zero = _mm512_setzero_si512();
  __m512i s0 = zero;
  __m512i s1 = zero;
  __m512i s2 = zero;
  __m512i s3 = zero;
  __m512i s4 = zero;
  __m512i s5 = zero;
  __m512i s6 = zero;
  __m512i s7 = zero;
  __m512i s8 = zero;
  __m512i s9 = zero;
  __m512i s10 = zero;
  __m512i s11 = zero;
  __m512i s12 = zero;
  __m512i s13 = zero;
  __m512i s14 = zero;
  __m512i s15 = zero;
  constexpr std::uint32_t one = 1;
  for (std::size_t c = begin; c < end; ++c) {
    const float* candidate = slots + offsets[c];
    const __mmask16 mask = queries.neighborMask(candidate).raw;
    const auto* value = reinterpret_cast<const std::uint32_t*>(candidate);
    addWhere(mask, s0, value + momentAt(sum_x));
    addWhere(mask, s1, value + momentAt(sum_y));
    addWhere(mask, s2, value + momentAt(sum_z));
    addWhere(mask, s3, value + momentAt(low_xx));
    addWhere(mask, s4, value + momentAt(low_xy));
    addWhere(mask, s5, value + momentAt(low_xz));
    addWhere(mask, s6, value + momentAt(low_yy));
    addWhere(mask, s7, value + momentAt(low_yz));
    addWhere(mask, s8, value + momentAt(low_zz));
    addWhere(mask, s9, value + momentAt(high_xx));
    addWhere(mask, s10, value + momentAt(high_xy));
    addWhere(mask, s11, value + momentAt(high_xz));
    addWhere(mask, s12, value + momentAt(high_yy));
    addWhere(mask, s13, value + momentAt(high_yz));
    addWhere(mask, s14, value + momentAt(high_zz));
    addWhere(mask, s15, &one);
  }
  addLanes(hn::VFromD<Words>{s0}, block.values[sum_x] + first_lane);
  addLanes(hn::VFromD<Words>{s1}, block.values[sum_y] + first_lane);
  addLanes(hn::VFromD<Words>{s2}, block.values[sum_z] + first_lane);
  addLanes(hn::VFromD<Words>{s3}, block.values[low_xx] + first_lane);
  addLanes(hn::VFromD<Words>{s4}, block.values[low_xy] + first_lane);
  addLanes(hn::VFromD<Words>{s5}, block.values[low_xz] + first_lane);
  addLanes(hn::VFromD<Words>{s6}, block.values[low_yy] + first_lane);
  addLanes(hn::VFromD<Words>{s7}, block.values[low_yz] + first_lane);
  addLanes(hn::VFromD<Words>{s8}, block.values[low_zz] + first_lane);
  addLanes(hn::VFromD<Words>{s9}, block.values[high_xx] + first_lane);
  addLanes(hn::VFromD<Words>{s10}, block.values[high_xy] + first_lane);
  addLanes(hn::VFromD<Words>{s11}, block.values[high_xz] + first_lane);
  addLanes(hn::VFromD<Words>{s12}, block.values[high_yy] + first_lane);
  addLanes(hn::VFromD<Words>{s13}, block.values[high_yz] + first_lane);
  addLanes(hn::VFromD<Words>{s14}, block.values[high_zz] + first_lane);
  addLanes(hn::VFromD<Words>{s15}, block.count + first_lane);
}

#else

/** \brief A few moments at a time, from stored masks: registers are few. */
template <std::size_t first, std::size_t count>
HWY_INLINE void
addSomeMoments(const std::uint32_t* masks,
               const float* slots,
               const std::uint32_t* offsets,
               std::size_t size,
               std::size_t first_lane,
               BlockMoments& block)
{
  const Words w;
  hn::VFromD<Words> sums[count];
  for (auto& sum : sums)
    sum = hn::Zero(w);
  for (std::size_t c = 0; c < size; ++c) {
    const auto mask = hn::Load(w, masks + c * lanes);
    const auto* value = reinterpret_cast<const std::uint32_t*>(slots + offsets[c]);
    HWY_UNROLL(5)
    for (std::size_t m = 0; m < count; ++m)
      sums[m] = hn::Add(sums[m], hn::And(mask, hn::Set(w, value[momentAt(first + m)])));
  }
  for (std::size_t m = 0; m < count; ++m)
    addLanes(sums[m], block.values[first + m] + first_lane);
}

template <bool with_ties>
HWY_INLINE void
addMoments(const QueryLanes<with_ties>& queries,
           const float* slots,
           const std::uint32_t* offsets,
           std::size_t begin,
           std::size_t end,
           std::size_t first_lane,
           BlockMoments& block)
{
  const Words w;
  std::uint32_t* masks =
      simdScratch().masks.atLeast(candidates_between_widening * lanes);
  auto counts = hn::Zero(w);
  for (std::size_t c = begin; c < end; ++c) {
    const auto mask =
        hn::VecFromMask(w, hn::RebindMask(w, queries.neighborMask(slots + offsets[c])));
    counts = hn::Sub(counts, mask);
    hn::Store(mask, w, masks + (c - begin) * lanes);
  }
  addLanes(counts, block.count + first_lane);
  static_assert(moment_count == 15, "three parts of five");
  const std::size_t size = end - begin;
  offsets += begin;
  addSomeMoments<0, 5>(masks, slots, offsets, size, first_lane, block);
  addSomeMoments<5, 5>(masks, slots, offsets, size, first_lane, block);
  addSomeMoments<10, 5>(masks, slots, offsets, size, first_lane, block);
}

#endif

template <bool with_ties>
HWY_INLINE void
addPortion(const SweepBlock& block,
           const float* r2,
           const float* tie_d2,
           const CandidateList& candidates,
           BlockMoments& sums)
{
  for (std::size_t lane = 0; lane < block.size; lane += lanes) {
    const QueryLanes<with_ties> queries(block, r2, tie_d2, lane);
    for (std::size_t c = 0; c < candidates.size; c += candidates_between_widening) {
      const std::size_t end =
          std::min(candidates.size, c + candidates_between_widening);
      addMoments(queries, candidates.slots, candidates.offsets, c, end, lane, sums);
    }
  }
}

/** Neighborhoods up to this size have moments that fit in 63 bits. */
constexpr std::uint64_t most_for_63_bits = std::uint64_t{1} << 18;

/** \brief sum (a - a0) (b - b0) from sums about 0, exactly. */
template <typename Integer>
HWY_INLINE Integer
aboutQuery(Integer high,
           Integer low,
           Integer a0,
           Integer b0,
           Integer sum_a,
           Integer sum_b,
           Integer n)
{
  constexpr auto half = static_cast<Integer>(1) << half_bits;
  return high * half + low - a0 * (sum_b - n * b0) - b0 * sum_a;
}

/** Neighborhoods up to this size have moments, and terms of aboutQuery(), below 2^53:
 * doubles hold them exactly. */
constexpr std::uint64_t most_for_doubles = 256;

/** \brief The central second moments of one product of some queries with few neighbors.
 */
HWY_INLINE void
centerProductOfFew(const BlockMoments& m,
                   std::size_t i,
                   std::size_t product,
                   std::size_t a,
                   std::size_t b,
                   double* covariances)
{
  const Doubles d;
  const auto n = toDoubles(m.count + i);
  const auto inverse = hn::Div(hn::Set(d, 1.0), n);
  const auto a0 = hn::Load(d, m.own[a] + i), b0 = hn::Load(d, m.own[b] + i);
  const auto sum_a = toDoubles(m.values[a] + i), sum_b = toDoubles(m.values[b] + i);
  const auto all = hn::MulAdd(toDoubles(m.values[high_xx + product] + i),
                              hn::Set(d, static_cast<double>(1 << half_bits)),
                              toDoubles(m.values[low_xx + product] + i));
  const auto y = hn::NegMulAdd(n, b0, sum_b);
  const auto x = hn::NegMulAdd(n, a0, sum_a);
  const auto about = hn::NegMulAdd(b0, sum_a, hn::NegMulAdd(a0, y, all));
  const auto central = hn::Sub(about, hn::Mul(hn::Mul(x, y), inverse));
  hn::Store(hn::Mul(central, inverse), d, covariances + i);
}

/** \brief The central second moments of one product, of all queries. */
HWY_INLINE void
centerProduct(const BlockMoments& m,
              std::size_t product,
              std::size_t a,
              std::size_t b,
              double* covariances)
{
  for (std::size_t i = 0; i < block_size; ++i) {
    const auto n = static_cast<std::int64_t>(m.count[i]);
    const auto a0 = static_cast<std::int64_t>(m.own[a][i]);
    const auto b0 = static_cast<std::int64_t>(m.own[b][i]);
    const auto sum_a = static_cast<std::int64_t>(m.values[a][i]);
    const auto sum_b = static_cast<std::int64_t>(m.values[b][i]);
    const auto high = static_cast<std::int64_t>(m.values[high_xx + product][i]);
    const auto low = static_cast<std::int64_t>(m.values[low_xx + product][i]);
    // Unsigned: of neighborhoods that are too large, whose result is not used, it
    // wraps.
    const auto word = [](std::int64_t v) { return static_cast<std::uint64_t>(v); };
    const auto about = static_cast<
        double>(static_cast<std::int64_t>(aboutQuery<std::uint64_t>(
        word(high), word(low), word(a0), word(b0), word(sum_a), word(sum_b), word(n))));
    const double inverse = 1.0 / static_cast<double>(n);
    const auto x = static_cast<double>(sum_a - n * a0);
    const auto y = static_cast<double>(sum_b - n * b0);
    covariances[i] = (about - x * y * inverse) * inverse;
  }
}

/** \brief The same for a neighborhood that is too large for 63 bits. */
HWY_INLINE void
centerLargeProduct(const BlockMoments& m,
                   std::size_t i,
                   std::size_t product,
                   std::size_t a,
                   std::size_t b,
                   double* covariances)
{
  __extension__ using SignedWide = __int128;
  const SignedWide n = m.count[i], sum_a = m.values[a][i], sum_b = m.values[b][i];
  const auto a0 = static_cast<SignedWide>(m.own[a][i]);
  const auto b0 = static_cast<SignedWide>(m.own[b][i]);
  const auto about =
      static_cast<double>(aboutQuery<SignedWide>(m.values[high_xx + product][i],
                                                 m.values[low_xx + product][i],
                                                 a0,
                                                 b0,
                                                 sum_a,
                                                 sum_b,
                                                 n));
  const double inverse = 1.0 / static_cast<double>(n);
  const auto x = static_cast<double>(sum_a - n * a0);
  const auto y = static_cast<double>(sum_b - n * b0);
  covariances[i] = (about - x * y * inverse) * inverse;
}

/** \brief Central second moments of the neighbors, from exact sums. */
HWY_INLINE void
centerMoments(const BlockMoments& m, BlockCovariances& c)
{
  const std::size_t first[] = {0, 0, 0, 1, 1, 2};
  const std::size_t second[] = {0, 1, 2, 1, 2, 2};
  double* const products[] = {c.xx, c.xy, c.xz, c.yy, c.yz, c.zz};
  const std::uint64_t largest = *std::max_element(m.count, m.count + block_size);
  for (std::size_t p = 0; p < 6; ++p) {
    if (HWY_LIKELY(largest <= most_for_doubles)) {
      for (std::size_t i = 0; i < block_size; i += double_lanes)
        centerProductOfFew(m, i, p, first[p], second[p], products[p]);
      continue;
    }
    centerProduct(m, p, first[p], second[p], products[p]);
    for (std::size_t i = 0; i < block_size; ++i)
      if (HWY_UNLIKELY(m.count[i] > most_for_63_bits))
        centerLargeProduct(m, i, p, first[p], second[p], products[p]);
  }
}

/** \brief Sums over the neighbors' offsets from each query: first and second moments.
 */
struct alignas(64) OrderedMoments {
  enum Second : std::size_t { xx = sum_z + 1, xy, xz, yy, yz, zz, size };

  float counts[block_size];
  float sums[size][block_size];

  HWY_INLINE
  OrderedMoments()
  {
    const Floats d;
    for (std::size_t i = 0; i < block_size; i += lanes) {
      hn::Store(hn::Zero(d), d, counts + i);
      for (auto& sum : sums)
        hn::Store(hn::Zero(d), d, sum + i);
    }
  }
};

/** \brief sum += a b and sum += a where the mask is set. */
template <class M, class V>
HWY_INLINE V
mulAddWhere(M mask, V a, V b, V sum)
{
#if HWY_TARGET <= HWY_AVX3
  return V{_mm512_mask3_fmadd_ps(a.raw, b.raw, sum.raw, mask.raw)};
#else
  return hn::MulAdd(hn::IfThenElseZero(mask, a), b, sum);
#endif
}

template <class M, class V>
HWY_INLINE V
addWhere(M mask, V a, V sum)
{
#if HWY_TARGET <= HWY_AVX3
  return V{_mm512_mask_add_ps(sum.raw, mask.raw, sum.raw, a.raw)};
#else
  return hn::Add(sum, hn::IfThenElseZero(mask, a));
#endif
}

/** \brief Adds the moments of a row's points to what is so far summed over that row,
 * for as many queries as there are lanes. */
HWY_NOINLINE void
addPoints(const SweepBlock& block,
          const PackedPoints& points,
          std::size_t first,
          OrderedMoments& layer)
{
  const Floats d;
  const auto qx = hn::LoadU(d, block.qx + first), qy = hn::LoadU(d, block.qy + first),
             qz = hn::LoadU(d, block.qz + first), r2 = hn::LoadU(d, block.r2 + first);
  const auto one = hn::Set(d, 1.0f);
  const auto load = [&](std::size_t m) { return hn::Load(d, layer.sums[m] + first); };
  auto n = hn::Load(d, layer.counts + first);
  auto x = load(sum_x), y = load(sum_y), z = load(sum_z);
  auto xx = load(OrderedMoments::xx), xy = load(OrderedMoments::xy),
       xz = load(OrderedMoments::xz), yy = load(OrderedMoments::yy),
       yz = load(OrderedMoments::yz), zz = load(OrderedMoments::zz);
  for (std::size_t c = 0; c < points.size; ++c) {
    const auto dx = hn::Sub(hn::Set(d, points.x[c]), qx);
    const auto dy = hn::Sub(hn::Set(d, points.y[c]), qy);
    const auto dz = hn::Sub(hn::Set(d, points.z[c]), qz);
    const auto mask = hn::Lt(squaredLength(dx, dy, dz), r2);
    n = addWhere(mask, one, n);
    x = addWhere(mask, dx, x);
    y = addWhere(mask, dy, y);
    z = addWhere(mask, dz, z);
    xx = mulAddWhere(mask, dx, dx, xx);
    xy = mulAddWhere(mask, dx, dy, xy);
    xz = mulAddWhere(mask, dx, dz, xz);
    yy = mulAddWhere(mask, dy, dy, yy);
    yz = mulAddWhere(mask, dy, dz, yz);
    zz = mulAddWhere(mask, dz, dz, zz);
  }
  const auto store = [&](auto v, std::size_t m) {
    hn::Store(v, d, layer.sums[m] + first);
  };
  hn::Store(n, d, layer.counts + first);
  store(x, sum_x), store(y, sum_y), store(z, sum_z);
  store(xx, OrderedMoments::xx), store(xy, OrderedMoments::xy);
  store(xz, OrderedMoments::xz), store(yy, OrderedMoments::yy);
  store(yz, OrderedMoments::yz), store(zz, OrderedMoments::zz);
}

HWY_INLINE void
addLayer(const OrderedMoments& layer, OrderedMoments& all)
{
  const Floats d;
  const auto add = [&](const float* from, float* to) {
    hn::Store(hn::Add(hn::Load(d, to), hn::Load(d, from)), d, to);
  };
  for (std::size_t i = 0; i < block_size; i += lanes) {
    add(layer.counts + i, all.counts + i);
    for (std::size_t m = 0; m < OrderedMoments::size; ++m)
      add(layer.sums[m] + i, all.sums[m] + i);
  }
}

/** \brief Layer by layer of rows, each by itself, row by row, along x: so that sums of
 * few are added up, and the result does not depend on points that are no neighbors. */
HWY_INLINE void
sumInOrder(const SweepBlock& block, OrderedMoments& all)
{
  constexpr std::size_t portion = 256;
  const NearClusters near(block);
  std::size_t begin = 0;
  for (std::size_t r = 0; r < block.run_count; ++r) {
    const bool is_last = r + 1 == block.run_count;
    if (!is_last && block.runs[r + 1].layer == block.runs[r].layer)
      continue;
    const std::size_t end = near.endOfRun(r);
    OrderedMoments layer;
    for (; begin < end; begin += std::min(portion, end - begin)) {
      const PackedPoints points =
          packPoints<false>(block, near, begin, std::min(end, begin + portion));
      for (std::size_t first = 0; first < block.size; first += lanes)
        addPoints(block, points, first, layer);
    }
    addLayer(layer, all);
  }
}

} // namespace pcl::kernels::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
