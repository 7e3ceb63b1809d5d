// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Narrows the neighbors of a block's queries to the k nearest.

// No include guard: simd_kernels.cpp includes it once for each target.

#include "sweep/simd/candidates-inl.h"

#include <cmath>
#include <utility>

HWY_BEFORE_NAMESPACE();
namespace pcl::kernels::HWY_NAMESPACE {

/** With more, keeping the smallest takes longer than counting. */
constexpr std::size_t max_kept = 16;

/** \brief What is known of the k-th nearest points besides kth_d2. */
struct KthOfQueries {
  bool has_tie[block_size];     ///< whether the next one is as far
  std::size_t less[block_size]; ///< with a tie: how many are nearer
};

/** \brief The k nearest of all queries; kth_d2 is NaN if a query has fewer than k
 * neighbors. Of each lane as many values are kept as there are n, more than k, sorted:
 * in registers, if the compiler sees each as a variable of its own. */
template <std::size_t... n>
HWY_NOINLINE KthOfQueries
keepNearest(SweepBlock& block,
            std::size_t k,
            const PackedPoints& candidates,
            std::index_sequence<n...>)
{
  const Floats d;
  const auto infinity = hn::Set(d, std::numeric_limits<float>::infinity());
  KthOfQueries kth;
  for (std::size_t first = 0; first < block.size; first += lanes) {
    const QueryLanes<false> queries(block, first);
    hn::VFromD<Floats> smallest[] = {(static_cast<void>(n), infinity)...};
    for (std::size_t c = 0; c < candidates.size; ++c) {
      auto value =
          queries.squaredDistances(candidates.x[c], candidates.y[c], candidates.z[c]);
      const auto insert = [&](hn::VFromD<Floats>& kept) {
        const auto larger = hn::Max(kept, value);
        kept = hn::Min(kept, value);
        value = larger;
      };
      (insert(smallest[n]), ...);
    }
    HWY_ALIGN float values[sizeof...(n) * lanes];
    (hn::StoreU(smallest[n], d, values + n * lanes), ...);
    for (std::size_t lane = 0; lane < lanes; ++lane) {
      const auto at = [&](std::size_t rank) { return values[rank * lanes + lane]; };
      const std::size_t i = first + lane;
      const bool has_enough = at(k - 1) < block.r2[i];
      block.kth_d2[i] = has_enough ? at(k - 1) : nan;
      kth.has_tie[i] = has_enough && at(k) == at(k - 1);
      kth.less[i] = k - 1;
      while (kth.has_tie[i] && kth.less[i] > 0 && at(kth.less[i] - 1) == at(k - 1))
        --kth.less[i];
    }
  }
  return kth;
}

/** \brief How many of the distances are below a bound. The padding is infinite. */
HWY_INLINE std::size_t
countBelow(const float* d2, std::size_t count, float bound)
{
  const Floats d;
  std::size_t below = 0;
  for (std::size_t c = 0; c < count; c += lanes)
    below += hn::CountTrue(d, hn::Lt(hn::LoadU(d, d2 + c), hn::Set(d, bound)));
  return below;
}

/** \brief A value, and how many of a list are less, and not greater. */
struct Ranked {
  float value;
  std::size_t less, not_greater;
};

/** \brief One more where the mask is set. Whole numbers: adding floats takes four times
 * as long. */
template <class M>
HWY_INLINE hn::VFromD<Ints>
countWhere(M mask, hn::VFromD<Ints> count)
{
  const Ints w;
#if HWY_TARGET <= HWY_AVX3
  return hn::VFromD<Ints>{
      _mm512_mask_add_epi32(count.raw, mask.raw, count.raw, hn::Set(w, 1).raw)};
#else
  // A mask's lanes are -1.
  return hn::Sub(count, hn::VecFromMask(w, hn::RebindMask(w, mask)));
#endif
}

/** \brief As many values as two vectors have are ranked by comparing all with all. */
constexpr std::size_t few_values = 2 * lanes;

/** \brief The n-th smallest of the values of some vectors, none negative, padded with
 * infinity: the largest of those that fewer than n are less than. Without branches:
 * none could be predicted. */
template <std::size_t vectors>
HWY_INLINE Ranked
nthOfVectors(const float* values, std::size_t n)
{
  const Floats d;
  hn::VFromD<Floats> v[vectors];
  hn::VFromD<Ints> less[vectors];
  for (std::size_t u = 0; u < vectors; ++u) {
    v[u] = hn::LoadU(d, values + u * lanes);
    less[u] = hn::Zero(Ints());
  }
  for (std::size_t i = 0; i < vectors * lanes; ++i) {
    const auto value = hn::Set(d, values[i]);
    for (std::size_t u = 0; u < vectors; ++u)
      less[u] = countWhere(hn::Gt(v[u], value), less[u]);
  }
  const auto rank = hn::Set(Ints(), static_cast<std::int32_t>(n));
  auto largest = hn::Zero(d);
  for (std::size_t u = 0; u < vectors; ++u) {
    const auto is_small = hn::RebindMask(d, hn::Lt(less[u], rank));
    largest = hn::Max(largest, hn::IfThenElseZero(is_small, v[u]));
  }
  const auto nth = hn::MaxOfLanes(d, largest);
  Ranked found{hn::GetLane(nth), 0, 0};
  for (std::size_t u = 0; u < vectors; ++u) {
    found.less += hn::CountTrue(d, hn::Lt(v[u], nth));
    found.not_greater += hn::CountTrue(d, hn::Le(v[u], nth));
  }
  return found;
}

/** \brief The n-th smallest of however many. Moves them. */
inline Ranked
nthOfMany(float* values, std::size_t count, std::size_t n)
{
  float* nth = values + (n - 1);
  std::nth_element(values, nth, values + count);
  const auto is_less = [nth](float v) { return v < *nth; };
  return {*nth,
          static_cast<std::size_t>(std::count_if(values, nth, is_less)),
          n + static_cast<std::size_t>(std::count(nth + 1, values + count, *nth))};
}

/** \brief Packs the distances in [low, high), in place, and pads them with infinity.
 * \return how many they are */
HWY_INLINE std::size_t
keepInside(float* d2, std::size_t count, float low, float high)
{
  const Floats d;
  std::size_t kept = 0;
  for (std::size_t c = 0; c < count; c += lanes) {
    const auto v = hn::LoadU(d, d2 + c);
    const auto inside =
        hn::AndNot(hn::Lt(v, hn::Set(d, low)), hn::Lt(v, hn::Set(d, high)));
    kept += packStore(d, v, inside, d2 + kept);
  }
  hn::StoreU(hn::Set(d, std::numeric_limits<float>::infinity()), d, d2 + kept);
  return kept;
}

/** \brief The k-th smallest of squared distances in [low, high), k at most their
 * number. Moves them.
 *
 * On a surface the number of points within d grows like d^2: interpolating between
 * bounds finds the k-th in a few counts; halving between them, now and then, bounds
 * their number.
 */
HWY_INLINE Ranked
kthSmallest(float* d2, std::size_t count, std::size_t k, float low, float high)
{
  std::size_t below_low = 0, below_high = count;
  for (int step = 0; below_high - below_low > few_values; ++step) {
    const double share = step % 4 == 3
                             ? 0.5
                             : (static_cast<double>(k - below_low) - 0.5) /
                                   static_cast<double>(below_high - below_low);
    const auto middle =
        static_cast<float>(low + share * (static_cast<double>(high) - low));
    if (!(middle > low && middle < high))
      break;
    const std::size_t below = countBelow(d2, count, middle);
    (below >= k ? high : low) = middle;
    (below >= k ? below_high : below_low) = below;
  }
  const std::size_t kept =
      below_high - below_low < count ? keepInside(d2, count, low, high) : count;
  const std::size_t n = k - below_low;
  Ranked kth = kept <= lanes        ? nthOfVectors<1>(d2, n)
               : kept <= few_values ? nthOfVectors<2>(d2, n)
                                    : nthOfMany(d2, kept, n);
  kth.less += below_low;
  kth.not_greater += below_low;
  return kth;
}

/** \brief Squared distances of a query to candidates from c on. */
HWY_INLINE hn::VFromD<Floats>
squaredDistances(const SweepBlock& block,
                 std::size_t i,
                 const PackedPoints& candidates,
                 std::size_t c)
{
  const Floats d;
  return squaredLength(
      hn::Sub(hn::LoadU(d, candidates.x + c), hn::Set(d, block.qx[i])),
      hn::Sub(hn::LoadU(d, candidates.y + c), hn::Set(d, block.qy[i])),
      hn::Sub(hn::LoadU(d, candidates.z + c), hn::Set(d, block.qz[i])));
}

/** \brief How many values are below a range, and how many in it. */
struct Ring {
  std::size_t below, inside;
};

/** \brief Squared distances of a query's candidates in [low, high), packed and padded
 * with infinity. */
HWY_INLINE Ring
collectRing(const SweepBlock& block,
            std::size_t i,
            const PackedPoints& candidates,
            float low,
            float high,
            float* d2)
{
  const Floats d;
  const auto min = hn::Set(d, low), max = hn::Set(d, high);
  Ring ring{0, 0};
  for (std::size_t c = 0; c < candidates.size; c += lanes) {
    const auto v = squaredDistances(block, i, candidates, c);
    const auto is_below = hn::Lt(v, min);
    const auto is_inside = hn::AndNot(is_below, hn::Lt(v, max));
    ring.below += hn::CountTrue(d, is_below);
    ring.inside += packStore(d, v, is_inside, d2 + ring.inside);
  }
  hn::StoreU(hn::Set(d, std::numeric_limits<float>::infinity()), d, d2 + ring.inside);
  return ring;
}

/** \brief Of the candidates at this squared distance, the index of the n-th in order.
 */
HWY_INLINE std::uint32_t
nthIndexAt(const SweepBlock& block,
           std::size_t i,
           const PackedPoints& candidates,
           float d2,
           std::size_t n)
{
  const Floats d;
  const Words w;
  std::uint32_t* indices = simdScratch().masks.atLeast(candidates.size + lanes);
  std::size_t count = 0;
  for (std::size_t c = 0; c < candidates.size; c += lanes) {
    const auto equal =
        hn::Eq(squaredDistances(block, i, candidates, c), hn::Set(d, d2));
    count += packStore(w,
                       hn::LoadU(w, candidates.order + c),
                       hn::RebindMask(w, equal),
                       indices + count);
  }
  std::nth_element(indices, indices + (n - 1), indices + count);
  return indices[n - 1];
}

/** \brief The points up to this squared distance, finite and not negative, are the
 * query's neighbors: those nearer than the next larger float. */
HWY_INLINE void
setRadiusTo(SweepBlock& block, std::size_t i, float d2)
{
  std::uint32_t bits = 0;
  std::memcpy(&bits, &d2, sizeof(bits));
  ++bits;
  std::memcpy(&block.r2[i], &bits, sizeof(bits));
}

/** \brief Of the points at this squared distance, which is the k-th, those of the
 * smallest indices are neighbors, too. */
HWY_INLINE void
setTieAt(SweepBlock& block,
         std::size_t i,
         const PackedPoints& candidates,
         float d2,
         std::size_t wanted)
{
  block.r2[i] = block.tie_d2[i] = d2;
  block.tie_index[i] = nthIndexAt(block, i, candidates, d2, wanted);
}

/** \brief Sets a query's neighbors to the k nearest candidates. */
HWY_INLINE void
setNearest(SweepBlock& block,
           std::size_t i,
           std::size_t k,
           const PackedPoints& candidates,
           const Ranked& kth)
{
  block.kth_d2[i] = kth.value;
  if (kth.not_greater == k)
    setRadiusTo(block, i, kth.value);
  else
    setTieAt(block, i, candidates, kth.value, k - kth.less);
}

/** \brief The k nearest of one query, if its k-th is about as far as that of a query
 * close by, k at least 16; most distances then need not be kept.
 *
 * The number of points within a distance varies by sqrt(k) where they are random, by
 * less where they are regular; the k-th squared distance varies likewise, by
 * 1 / sqrt(k) of itself. 1.2 times that, on both sides, seldom misses the k-th. If the
 * distance close by is unknown (NaN), nothing is in the ring. */
HWY_INLINE bool
narrowNear(SweepBlock& block,
           std::size_t i,
           std::size_t k,
           const PackedPoints& candidates,
           float kth_nearby,
           float* d2)
{
  const float width = 1.2f / std::sqrt(static_cast<float>(k));
  const float low = kth_nearby * (1.0f - width);
  const float wide = kth_nearby * (1.0f + width);
  const float high = wide > block.r2[i] ? block.r2[i] : wide;
  const Ring ring = collectRing(block, i, candidates, low, high, d2);
  if (k <= ring.below || k > ring.below + ring.inside)
    return false;
  Ranked kth = kthSmallest(d2, ring.inside, k - ring.below, low, high);
  kth.less += ring.below;
  kth.not_greater += ring.below;
  setNearest(block, i, k, candidates, kth);
  return true;
}

/** \brief The k nearest of one query; false if it has fewer neighbors. */
HWY_INLINE bool
narrow(SweepBlock& block,
       std::size_t i,
       std::size_t k,
       const PackedPoints& candidates,
       float* d2)
{
  const std::size_t count =
      collectRing(block, i, candidates, 0.0f, block.r2[i], d2).inside;
  if (count < k) {
    block.kth_d2[i] = nan;
    return false;
  }
  setNearest(block, i, k, candidates, kthSmallest(d2, count, k, 0.0f, block.r2[i]));
  return true;
}

/** \brief Few nearest: of all queries at once, the smallest distances are kept. */
HWY_INLINE bool
narrowToFew(SweepBlock& block, std::size_t k, const PackedPoints& candidates)
{
  constexpr std::size_t some = 11; // for the usual k of 10
  const KthOfQueries kth =
      k < some
          ? keepNearest(block, k, candidates, std::make_index_sequence<some>())
          : keepNearest(block, k, candidates, std::make_index_sequence<max_kept>());
  bool all = true;
  for (std::size_t i = 0; i < block.size; ++i) {
    const float d2 = block.kth_d2[i];
    if (std::isnan(d2))
      all = false;
    else if (kth.has_tie[i])
      setTieAt(block, i, candidates, d2, k - kth.less[i]);
    else
      setRadiusTo(block, i, d2);
  }
  return all;
}

inline bool
nearest(SweepBlock& block, std::size_t k)
{
  const NearClusters near(block);
  if (near.size > max_clusters)
    return portableKernels().nearest(block, k);
  const PackedPoints candidates = packPoints<true>(block, near, 0, near.size);
  if (k < max_kept)
    return narrowToFew(block, k, candidates);
  float* d2 = simdScratch().values.atLeast(candidates.size + lanes);
  bool all = true;
  for (std::size_t i = 0; i < block.size; ++i)
    if (i == 0 || !narrowNear(block, i, k, candidates, block.kth_d2[i - 1], d2))
      all = narrow(block, i, k, candidates, d2) && all;
  return all;
}

} // namespace pcl::kernels::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
