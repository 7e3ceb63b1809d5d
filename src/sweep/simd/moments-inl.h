// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Sums of neighbors' offsets and of their products, and covariances from them.

// No include guard: normals-inl.h includes it once for each target.

#include "sweep/portable/neighborhood.h"
#include "sweep/simd/candidates-inl.h"

#include <cmath>
#include <utility>

HWY_BEFORE_NAMESPACE();
namespace pcl::kernels::HWY_NAMESPACE {

/** Products of two offsets take up to 44 bits, and are added up as two halves. */
constexpr int half_bits = 22;

/** \brief What is added up over neighbors: three offsets, then the low and the high
 * halves of the products xx, xy, xz, yy, yz and zz. */
enum Moment : std::size_t {
  sum_x,
  sum_y,
  sum_z,
  low_xx,
  high_xx = low_xx + 6,
  moment_count = high_xx + 6
};

/** \brief Moments of the neighbors of a block's queries, about one origin. */
struct alignas(64) BlockMoments {
  std::uint64_t count[block_size];
  std::uint64_t values[moment_count][block_size];
  double own[3][block_size]; ///< the queries, in units from the origin
  double origin[3];          ///< in units, below all neighbors
};

/** \brief Covariances of a block's neighborhoods, in units^2 that are the same for all.
 */
struct alignas(64) BlockCovariances {
  double xx[block_size], xy[block_size], xz[block_size];
  double yy[block_size], yz[block_size], zz[block_size];
};

/** \brief Offsets are counted in 2^(level - 20): the radius is below 2^level. */
inline int
levelOf(float r2)
{
  int exponent = 0;
  std::frexp(r2, &exponent);
  if (std::isinf(r2))
    return 64; // the square root of what is beyond float
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
  , fits_(largest < (1 << 30) && std::abs(level) < 100) // in 32 bits, and in float
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

/** \brief What a slot holds of each of up to block_size candidates, before its moments.
 */
enum SlotArray : std::size_t { slot_x, slot_y, slot_z, slot_order, slot_moments };

constexpr std::size_t slot_size = (slot_moments + moment_count) * block_size;

/** \brief Where a candidate's moment is, from where its x is. */
constexpr std::size_t
momentAt(std::size_t moment)
{
  return (slot_moments + moment) * block_size;
}

/** \brief Writes the moments of a vector of points into their slot. */
HWY_INLINE void
stageMoments(const Quantizer& quantizer,
             hn::VFromD<Floats> px,
             hn::VFromD<Floats> py,
             hn::VFromD<Floats> pz,
             float* slot)
{
  const Words w;
  const auto x = quantizer(px, 0), y = quantizer(py, 1), z = quantizer(pz, 2);
  auto* words = reinterpret_cast<std::uint32_t*>(slot);
  const auto at = [&](std::size_t moment) { return words + momentAt(moment); };
  hn::Store(x, w, at(sum_x));
  hn::Store(y, w, at(sum_y));
  hn::Store(z, w, at(sum_z));
  const auto store = [&](auto a, auto b, std::size_t product) {
    storeProduct(a, b, at(low_xx + product), at(high_xx + product));
  };
  store(x, x, 0), store(x, y, 1), store(x, z, 2);
  store(y, y, 3), store(y, z, 4), store(z, z, 5);
}

/** \brief Candidates, as offsets of their x from the first slot. */
struct CandidateList {
  const float* slots;
  const std::uint32_t* offsets;
  std::size_t size;
};

/** \brief Fills slots with `count` near clusters, and lists those of their points that
 * are near enough to the queries' box. */
template <bool with_order>
HWY_INLINE CandidateList
stageClusters(const SweepBlock& block,
              const NearClusters& near,
              std::size_t begin,
              std::size_t count,
              const Quantizer& quantizer)
{
  const Floats d;
  const Words w;
  float* slots = simdScratch().slots.atLeast(count * slot_size);
  std::uint32_t* offsets = simdScratch().offsets.atLeast(count * block_size + lanes);
  const BoxDistances distances(block.box);
  const auto reach2 = hn::Set(d, near.reach2);
  std::size_t listed = 0;
  for (std::size_t s = 0; s < count; ++s) {
    const std::uint32_t cluster = near.clusters[begin + s];
    const std::uint32_t first = block.cluster_begin[cluster];
    const std::uint32_t points = block.cluster_begin[cluster + 1] - first;
    for (std::size_t i = 0; i < points; i += lanes) {
      const std::size_t offset = s * slot_size + i;
      float* slot = slots + offset;
      const auto x = hn::LoadU(d, block.x + first + i),
                 y = hn::LoadU(d, block.y + first + i),
                 z = hn::LoadU(d, block.z + first + i);
      hn::Store(x, d, slot + slot_x * block_size);
      hn::Store(y, d, slot + slot_y * block_size);
      hn::Store(z, d, slot + slot_z * block_size);
      if constexpr (with_order) {
        hn::Store(hn::LoadU(w, block.order + first + i),
                  w,
                  reinterpret_cast<std::uint32_t*>(slot + slot_order * block_size));
      }
      stageMoments(quantizer, x, y, z, slot);
      const auto mask = hn::And(hn::Lt(distances.squared(x, y, z), reach2),
                                pointsOfCluster(points, i));
      listed += packStore(w,
                          numbersFrom(static_cast<std::uint32_t>(offset)),
                          hn::RebindMask(w, mask),
                          offsets + listed);
    }
  }
  return {slots, offsets, listed};
}

/** \brief Which queries the candidate in a slot is a neighbor of. */
template <bool with_ties>
HWY_INLINE MaskOf<Floats>
neighborMask(const QueryLanes<with_ties>& queries, const float* candidate)
{
  std::uint32_t order = 0;
  if constexpr (with_ties)
    std::memcpy(&order, candidate + slot_order * block_size, sizeof(order));
  return queries.neighborMask(candidate[slot_x * block_size],
                              candidate[slot_y * block_size],
                              candidate[slot_z * block_size],
                              order);
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
template <bool with_ties, std::size_t... m>
HWY_NOINLINE void
addMoments(const QueryLanes<with_ties>& lanes_of_queries,
           const CandidateList& candidates,
           std::size_t begin,
           std::size_t end,
           std::size_t first_lane,
           BlockMoments& block,
           std::index_sequence<m...>)
{
  const QueryLanes<with_ties> queries = lanes_of_queries;
  const float* slots = candidates.slots;
  const std::uint32_t* offsets = candidates.offsets;
  __m512i sums[] = {(static_cast<void>(m), _mm512_setzero_si512())...};
  __m512i counts = _mm512_setzero_si512();
  constexpr std::uint32_t one = 1;
  for (std::size_t c = begin; c < end; ++c) {
    const float* candidate = slots + offsets[c];
    const __mmask16 mask = neighborMask(queries, candidate).raw;
    const auto* value = reinterpret_cast<const std::uint32_t*>(candidate);
    (addWhere(mask, sums[m], value + momentAt(m)), ...);
    addWhere(mask, counts, &one);
  }
  (addLanes(hn::VFromD<Words>{sums[m]}, block.values[m] + first_lane), ...);
  addLanes(hn::VFromD<Words>{counts}, block.count + first_lane);
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

template <bool with_ties, std::size_t... m>
HWY_INLINE void
addMoments(const QueryLanes<with_ties>& queries,
           const CandidateList& candidates,
           std::size_t begin,
           std::size_t end,
           std::size_t first_lane,
           BlockMoments& block,
           std::index_sequence<m...>)
{
  const Words w;
  const float* slots = candidates.slots;
  const std::uint32_t* offsets = candidates.offsets + begin;
  const std::size_t size = end - begin;
  std::uint32_t* masks =
      simdScratch().masks.atLeast(candidates_between_widening * lanes);
  auto counts = hn::Zero(w);
  for (std::size_t c = 0; c < size; ++c) {
    const auto mask = hn::VecFromMask(
        w, hn::RebindMask(w, neighborMask(queries, slots + offsets[c])));
    counts = hn::Sub(counts, mask);
    hn::Store(mask, w, masks + c * lanes);
  }
  addLanes(counts, block.count + first_lane);
  static_assert(moment_count == 15, "three parts of five");
  addSomeMoments<0, 5>(masks, slots, offsets, size, first_lane, block);
  addSomeMoments<5, 5>(masks, slots, offsets, size, first_lane, block);
  addSomeMoments<10, 5>(masks, slots, offsets, size, first_lane, block);
}

#endif

/** \brief Adds the neighbors in `count` near clusters. */
template <bool with_ties>
HWY_INLINE void
addClusters(const SweepBlock& block,
            const NearClusters& near,
            std::size_t begin,
            std::size_t count,
            const Quantizer& quantizer,
            BlockMoments& sums)
{
  const CandidateList candidates =
      stageClusters<with_ties>(block, near, begin, count, quantizer);
  for (std::size_t lane = 0; lane < block.size; lane += lanes) {
    const QueryLanes<with_ties> queries(block, lane);
    for (std::size_t c = 0; c < candidates.size; c += candidates_between_widening) {
      const std::size_t end =
          std::min(candidates.size, c + candidates_between_widening);
      addMoments(queries,
                 candidates,
                 c,
                 end,
                 lane,
                 sums,
                 std::make_index_sequence<moment_count>());
    }
  }
}

/** \brief The sum of all lanes. */
HWY_INLINE std::uint64_t
totalOf(hn::VFromD<Words> sums)
{
  const Longs l;
  const auto both = hn::BitCast(l, sums);
  const auto even = hn::And(both, hn::Set(l, 0xffffffffu));
  return hn::GetLane(hn::SumOfLanes(l, hn::Add(even, hn::ShiftRight<32>(both))));
}

/** \brief Adds the neighbors of one query in `count` near clusters: as many points at a
 * time as there are lanes, and nothing is staged for other queries. */
HWY_NOINLINE void
addNeighborsOf(std::size_t query,
               const SweepBlock& block,
               const NearClusters& near,
               std::size_t begin,
               std::size_t count,
               const Quantizer& quantizer,
               BlockMoments& sums)
{
  const Floats d;
  const Words w;
  const Longs l;
  const auto odd = [&](auto v) {
    return hn::BitCast(w, hn::ShiftRight<32>(hn::BitCast(l, v)));
  };
  const auto qx = hn::Set(d, block.qx[query]), qy = hn::Set(d, block.qy[query]),
             qz = hn::Set(d, block.qz[query]), r2 = hn::Set(d, block.r2[query]);
  auto x_sum = hn::Zero(w), y_sum = hn::Zero(w), z_sum = hn::Zero(w);
  auto xx = hn::Zero(l), xy = hn::Zero(l), xz = hn::Zero(l), yy = hn::Zero(l),
       yz = hn::Zero(l), zz = hn::Zero(l);
  for (std::size_t c = begin; c < begin + count; ++c) {
    const std::uint32_t first = block.cluster_begin[near.clusters[c]];
    const std::uint32_t points = block.cluster_begin[near.clusters[c] + 1] - first;
    for (std::size_t i = 0; i < points; i += lanes) {
      const auto px = hn::LoadU(d, block.x + first + i),
                 py = hn::LoadU(d, block.y + first + i),
                 pz = hn::LoadU(d, block.z + first + i);
      const auto d2 = squaredLength(hn::Sub(px, qx), hn::Sub(py, qy), hn::Sub(pz, qz));
      const auto mask = hn::And(hn::Lt(d2, r2), pointsOfCluster(points, i));
      if (hn::AllFalse(d, mask))
        continue;
      sums.count[query] += hn::CountTrue(d, mask);
      const auto offset = [&](hn::VFromD<Floats> v, std::size_t axis) {
        return hn::IfThenElseZero(hn::RebindMask(w, mask), quantizer(v, axis));
      };
      const auto x = offset(px, 0), y = offset(py, 1), z = offset(pz, 2);
      const auto odd_x = odd(x), odd_y = odd(y), odd_z = odd(z);
      const auto add = [&](auto& sum, auto a, auto b, auto odd_a, auto odd_b) {
        sum = hn::Add(sum, hn::Add(hn::MulEven(a, b), hn::MulEven(odd_a, odd_b)));
      };
      x_sum = hn::Add(x_sum, x), y_sum = hn::Add(y_sum, y), z_sum = hn::Add(z_sum, z);
      add(xx, x, x, odd_x, odd_x), add(xy, x, y, odd_x, odd_y);
      add(xz, x, z, odd_x, odd_z), add(yy, y, y, odd_y, odd_y);
      add(yz, y, z, odd_y, odd_z), add(zz, z, z, odd_z, odd_z);
    }
  }
  sums.values[sum_x][query] += totalOf(x_sum);
  sums.values[sum_y][query] += totalOf(y_sum);
  sums.values[sum_z][query] += totalOf(z_sum);
  std::size_t product = 0;
  for (const auto& sum : {xx, xy, xz, yy, yz, zz}) {
    const std::uint64_t total = hn::GetLane(hn::SumOfLanes(l, sum));
    sums.values[low_xx + product][query] +=
        total & ((std::uint64_t{1} << half_bits) - 1);
    sums.values[high_xx + product++][query] += total >> half_bits;
  }
}

/** Neighborhoods up to this size have moments, and terms of aboutQuery(), below 2^53:
 * doubles hold them exactly. */
constexpr std::uint64_t max_for_doubles = 256;

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

/** Neighborhoods up to this size have moments that fit in 63 bits. */
constexpr std::uint64_t max_for_63_bits = std::uint64_t{1} << 18;

/** \brief The central second moment of one product, of one query. The sums are made
 * unsigned: those that do not fit wrap, and are not used. */
template <typename Signed, typename Unsigned>
HWY_INLINE double
centralProduct(const BlockMoments& m,
               std::size_t i,
               std::size_t product,
               std::size_t a,
               std::size_t b)
{
  const auto real = [](Unsigned v) {
    return static_cast<double>(static_cast<Signed>(v));
  };
  const auto own = [&](std::size_t axis) {
    return static_cast<Unsigned>(static_cast<Signed>(m.own[axis][i]));
  };
  const Unsigned n = m.count[i], a0 = own(a), b0 = own(b);
  const Unsigned sum_a = m.values[a][i], sum_b = m.values[b][i];
  const Unsigned low = m.values[low_xx + product][i];
  const Unsigned high = m.values[high_xx + product][i];
  // sum (a - a0) (b - b0) from sums about 0, exactly.
  const double about =
      real((high << half_bits) + low - a0 * (sum_b - n * b0) - b0 * sum_a);
  const double inverse = 1.0 / real(n);
  return (about - real(sum_a - n * a0) * real(sum_b - n * b0) * inverse) * inverse;
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
    if (HWY_LIKELY(largest <= max_for_doubles)) {
      for (std::size_t i = 0; i < block_size; i += double_lanes)
        centerProductOfFew(m, i, p, first[p], second[p], products[p]);
      continue;
    }
    for (std::size_t i = 0; i < block_size; ++i) {
      products[p][i] =
          HWY_LIKELY(m.count[i] <= max_for_63_bits)
              ? centralProduct<std::int64_t, std::uint64_t>(
                    m, i, p, first[p], second[p])
              : centralProduct<SignedWide, Wide>(m, i, p, first[p], second[p]);
    }
  }
}

/** \brief Sums over the neighbors' offsets from each query, and over their products. */
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
  const NearClusters near(block);
  std::size_t begin = 0;
  for (std::size_t r = 0; r < block.run_count; ++r) {
    const bool is_last = r + 1 == block.run_count;
    if (!is_last && block.runs[r + 1].layer == block.runs[r].layer)
      continue;
    const std::size_t run_end = near.run_ends[r];
    OrderedMoments layer;
    while (begin < run_end) {
      const std::size_t end = std::min(run_end, begin + max_clusters);
      const PackedPoints points = packPoints<false>(block, near, begin, end);
      for (std::size_t first = 0; first < block.size; first += lanes)
        addPoints(block, points, first, layer);
      begin = end;
    }
    addLayer(layer, all);
  }
}

} // namespace pcl::kernels::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
