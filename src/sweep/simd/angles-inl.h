// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Angles between the normals of queries and of their neighbors, and statistics of them.

// No include guard: inad-inl.h includes it once for each target.

#include "sweep/portable/angle.h"
#include "sweep/simd/candidates-inl.h"

#include <cmath>

HWY_BEFORE_NAMESPACE();
namespace pcl::kernels::HWY_NAMESPACE {

/** \brief The smallest squared chord: it has an inverse, and its angle is 0 units. */
constexpr float min_chord = 1e-30f;

/** \brief Angles of squared chords, in units (angle.h). */
template <class V>
HWY_INLINE hn::VFromD<Words>
anglesOf(V chords)
{
  const Floats d;
#if HWY_ARCH_X86
  // A step of Newton's from an estimate y of 1 / sqrt(t), which is much sooner known
  // than the root: sqrt(t) = t y (3 - t y^2) / 2.
  constexpr float scale = 0.5f * units_per_radian;
  const auto y = hn::ApproximateReciprocalSqrt(chords);
  const auto estimate = hn::Mul(chords, y);
  const auto root = hn::Mul(estimate, hn::NegMulAdd(estimate, y, hn::Set(d, 3.0f)));
#else
  constexpr float scale = units_per_radian;
  const auto root = hn::Sqrt(chords);
#endif
  const auto coefficient = [&](int i) {
    return hn::Set(d, angle_polynomial[i] * scale);
  };
  auto q = coefficient(6);
  for (int i = 5; i >= 0; --i)
    q = hn::MulAdd(q, chords, coefficient(i));
  return hn::BitCast(Words(), nearestInt(hn::Mul(root, q)));
}

/** \brief Squared chord between two normals, and min_chord more.
 * \tparam is_smooth both are known to be on the same side; otherwise they have either
 * sign: the nearer one counts */
template <bool is_smooth, class V>
HWY_INLINE V
squaredChords(V ax, V ay, V az, V bx, V by, V bz)
{
  const auto mx = hn::Sub(ax, bx), my = hn::Sub(ay, by), mz = hn::Sub(az, bz);
  const auto min = hn::Set(hn::DFromV<V>(), min_chord);
  const auto chord = hn::MulAdd(mx, mx, hn::MulAdd(my, my, hn::MulAdd(mz, mz, min)));
  if constexpr (is_smooth)
    return chord;
  const auto px = hn::Add(ax, bx), py = hn::Add(ay, by), pz = hn::Add(az, bz);
  return hn::Min(chord,
                 hn::MulAdd(px, px, hn::MulAdd(py, py, hn::MulAdd(pz, pz, min))));
}

/** 128 angles fit in 32 bits. */
constexpr std::size_t additions_between_widening = 128;

/** \brief Sums of angles and of their squares. Squares of even and odd lanes are added
 * up apart, in 64 bits. */
class AngleAdder {
public:
  // A constructor that the compiler makes would not have the target's instructions.
  HWY_INLINE
  AngleAdder()
  : sum_(hn::Zero(Words()))
  , even_(hn::Zero(Longs()))
  , odd_(hn::Zero(Longs()))
  , even_squares_(hn::Zero(Longs()))
  , odd_squares_(hn::Zero(Longs()))
  {}

  /** \brief Lanes that are 0 add nothing. */
  template <class V>
  HWY_INLINE void
  add(V units)
  {
    const Words w;
    const Longs l;
    const auto odd = hn::BitCast(w, hn::ShiftRight<32>(hn::BitCast(l, units)));
    sum_ = hn::Add(sum_, units);
    even_squares_ = hn::Add(even_squares_, hn::MulEven(units, units));
    odd_squares_ = hn::Add(odd_squares_, hn::MulEven(odd, odd));
  }

  /** \brief To be called at least every additions_between_widening. */
  HWY_INLINE void
  widen()
  {
    const Longs l;
    const auto sum = hn::BitCast(l, sum_);
    even_ = hn::Add(even_, hn::And(sum, hn::Set(l, 0xffffffffu)));
    odd_ = hn::Add(odd_, hn::ShiftRight<32>(sum));
    sum_ = hn::Zero(Words());
  }

  /** \brief What lanes add up to. */
  HWY_INLINE hn::VFromD<Longs>
  parts() const
  {
    return hn::Add(even_, odd_);
  }

  HWY_INLINE hn::VFromD<Longs>
  partsOfSquares() const
  {
    return hn::Add(even_squares_, odd_squares_);
  }

private:
  hn::VFromD<Words> sum_;
  hn::VFromD<Longs> even_, odd_, even_squares_, odd_squares_;
};

/** \brief Points with a normal that may be neighbors of a block's queries, packed, and
 * apart those that surely are of all. */
struct INADSlots {
  enum Array { x, y, z, nx, ny, nz, order, array_count };

  const float* arrays[array_count]; ///< of those that may be; the last vector has NaN
  std::size_t size;
  const std::uint32_t* sure; ///< where in the surface vectors of those that are begin
  std::size_t sure_size;     ///< how many vectors
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
    while (first + 1 < block.size && std::isnan(own.nx[first]))
      ++first;
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
    return near_.has_ties ? list<true>(begin, count) : list<false>(begin, count);
  }

  /** \brief Whether all normals make at most a right angle with all queries': theirs
   * and the queries' angles to one of these are together less. */
  bool
  isSmooth() const
  {
    constexpr float margin = 1e-4f; // more than floats lose
    return own_cosine_ > 0.0f && min_cosine_ > 0.0f &&
           own_cosine_ * own_cosine_ + min_cosine_ * min_cosine_ > 1.0f + margin;
  }

private:
  /** What the loop works with is local: what it writes might be a member. */
  template <bool with_ties>
  HWY_NOINLINE INADSlots
  list(std::size_t begin, std::size_t count)
  {
    const Floats d;
    const SweepBlock block = block_;
    const std::size_t max_size = count * block_size + lanes;
    INADSlots slots{};
    float* floats = simdScratch().slots.atLeast(INADSlots::array_count * max_size);
    float* out[INADSlots::array_count];
    for (std::size_t array = 0; array < INADSlots::array_count; ++array)
      slots.arrays[array] = out[array] = floats + array * max_size;
    std::uint32_t* sure_vectors = simdScratch().offsets.atLeast(max_size);
    const std::uint32_t* near = near_.clusters + begin;
    const BoxDistances distances(block.box);
    const auto reach2 = hn::Set(d, near_.reach2);
    const auto sure_reach2 = hn::Set(d, with_ties ? -1.0f : near_.sure_reach2);
    const auto x = hn::Set(d, x_), y = hn::Set(d, y_), z = hn::Set(d, z_);
    auto min_cosine = hn::Set(d, 1.0f);
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
        const auto mask = hn::And(hn::And(pointsOfCluster(points, i), hn::Eq(nx, nx)),
                                  hn::Lt(distances.squared(px, py, pz), reach2));
        const auto cosine = hn::MulAdd(nx, x, hn::MulAdd(ny, y, hn::Mul(nz, z)));
        min_cosine =
            hn::Min(min_cosine, hn::IfThenElse(mask, cosine, hn::Set(d, 1.0f)));
        const auto is_sure =
            hn::Lt(distances.squaredToFurthest(px, py, pz), sure_reach2);
        if (hn::AllTrue(d, hn::And(is_sure, mask))) {
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
    for (const auto array : {INADSlots::x, INADSlots::y, INADSlots::z})
      hn::StoreU(hn::NaN(d), d, out[array] + size);
    min_cosine_ = hn::GetLane(hn::MinOfLanes(d, min_cosine));
    slots.size = size;
    slots.sure = sure_vectors;
    slots.sure_size = sure_size;
    return slots;
  }

  const SweepBlock& block_;
  const NearClusters& near_;
  float x_, y_, z_; ///< a query's normal
  float own_cosine_ = 1.0f;
  float min_cosine_ = 1.0f;
};

/** \brief Sums over the angles of each query of a block, in units. */
struct BlockSums {
  std::uint64_t count[block_size];
  std::uint64_t sum[block_size];
  std::uint64_t squares[block_size];
};

/** \brief Means and standard deviations of a block's queries. */
struct BlockSpreads {
  double mean[block_size];
  double sd[block_size];
};

/** \brief Ranges of angles, [min, min + width]. */
struct BlockRanges {
  std::uint32_t min[block_size] = {};
  std::uint32_t width[block_size] = {};
};

/** \brief As BlockSums, of however many angles. */
struct ManySums {
  std::uint64_t count[block_size] = {};
  std::uint64_t sum[block_size] = {};
  Wide squares[block_size] = {};

  void
  add(const BlockSums& part)
  {
    for (std::size_t i = 0; i < block_size; ++i) {
      count[i] += part.count[i];
      sum[i] += part.sum[i];
      squares[i] += part.squares[i];
    }
  }
};

/** \brief From sums over at most max_for_64_bits angles. */
HWY_INLINE void
spreadsOf(const BlockSums& sums, BlockSpreads& spreads)
{
  const Doubles d;
  for (std::size_t i = 0; i < block_size; i += double_lanes) {
    const auto n = hn::Max(hn::Set(d, 1.0), toDoubles(sums.count + i));
    const auto inverse = hn::Div(hn::Set(d, 1.0), n);
    const auto sum = toDoubles(sums.sum + i);
    const auto mean = hn::Div(sum, n);
    // What the squares' 2^47 lose in 53 bits is less than a unit^2.
    const auto variance =
        hn::Mul(hn::Sub(toDoubles(sums.squares + i), hn::Mul(mean, sum)), inverse);
    hn::StoreU(mean, d, spreads.mean + i);
    hn::StoreU(hn::Sqrt(hn::Max(hn::Zero(d), variance)), d, spreads.sd + i);
  }
}

/** \brief As of few angles, if they are few: the same angles give the same result. */
inline void
spreadsOf(const ManySums& sums, BlockSpreads& spreads)
{
  BlockSums few{};
  for (std::size_t i = 0; i < block_size; ++i) {
    if (sums.count[i] <= max_for_64_bits) {
      few.count[i] = sums.count[i];
      few.sum[i] = sums.sum[i];
      few.squares[i] = static_cast<std::uint64_t>(sums.squares[i]);
    }
  }
  spreadsOf(few, spreads);
  for (std::size_t i = 0; i < block_size; ++i) {
    if (sums.count[i] > max_for_64_bits) {
      const Spread spread =
          AngleSums{sums.count[i], sums.sum[i], sums.squares[i]}.spread();
      spreads.mean[i] = spread.mean;
      spreads.sd[i] = spread.sd;
    }
  }
}

/** \brief As keptRange(). */
HWY_INLINE BlockRanges
keptRanges(const BlockSpreads& spreads, double outlier_rate)
{
  BlockRanges ranges;
  const Doubles d;
  const hn::Rebind<std::int32_t, Doubles> ints;
  const auto max = hn::Set(d, std::numeric_limits<std::int32_t>::max());
  for (std::size_t i = 0; i < block_size; i += double_lanes) {
    const auto mean = hn::LoadU(d, spreads.mean + i);
    const auto sd = hn::LoadU(d, spreads.sd + i);
    const auto width = hn::Mul(sd, hn::Set(d, outlier_rate * rejection_margin));
    // The product may be infinite: with no deviation it would not be a number.
    const auto all =
        hn::Or(hn::Eq(sd, hn::Zero(d)), hn::Eq(hn::Set(d, outlier_rate), hn::Zero(d)));
    const auto first = hn::IfThenZeroElse(
        all, hn::Ceil(hn::Min(max, hn::Max(hn::Zero(d), hn::Sub(mean, width)))));
    const auto last =
        hn::IfThenElse(all, max, hn::Floor(hn::Min(max, hn::Add(mean, width))));
    const auto store = [&](auto values, std::uint32_t* to) {
      hn::StoreU(hn::DemoteTo(ints, values), ints, reinterpret_cast<std::int32_t*>(to));
    };
    // Nothing is in an empty range: angles are less than the largest number.
    const auto is_empty = hn::Lt(last, first);
    store(hn::IfThenElse(is_empty, max, first), ranges.min + i);
    store(hn::IfThenZeroElse(is_empty, hn::Sub(last, first)), ranges.width + i);
  }
  return ranges;
}

/** \brief The squared chords between the normals of a query and its neighbors, packed,
 * then a vector of smallest chords.
 * \return how many neighbors there are, the query's own point among them */
template <bool with_ties, bool is_smooth>
HWY_NOINLINE std::size_t
collectChords(const SweepBlock& block,
              const OwnPoints& own,
              std::size_t i,
              const INADSlots& slots,
              float* HWY_RESTRICT chords)
{
  const Floats d;
  const auto qx = hn::Set(d, block.qx[i]), qy = hn::Set(d, block.qy[i]),
             qz = hn::Set(d, block.qz[i]), r2 = hn::Set(d, block.r2[i]),
             tie_d2 = hn::Set(d, block.tie_d2[i]);
  const auto tie_index = hn::Set(Ints(), static_cast<std::int32_t>(block.tie_index[i]));
  const auto own_nx = hn::Set(d, own.nx[i]), own_ny = hn::Set(d, own.ny[i]),
             own_nz = hn::Set(d, own.nz[i]);
  const auto chordsFrom = [&](const float* nx, const float* ny, const float* nz) {
    return squaredChords<is_smooth>(
        hn::LoadU(d, nx), hn::LoadU(d, ny), hn::LoadU(d, nz), own_nx, own_ny, own_nz);
  };
  // Local: what is written might be one of these.
  const float* arrays[INADSlots::array_count];
  std::copy_n(slots.arrays, std::size_t{INADSlots::array_count}, arrays);
  const std::size_t size = slots.size;
  std::size_t count = 0;
  for (std::size_t c = 0; c < size; c += lanes) {
    const auto d2 = squaredLength(hn::Sub(hn::LoadU(d, arrays[INADSlots::x] + c), qx),
                                  hn::Sub(hn::LoadU(d, arrays[INADSlots::y] + c), qy),
                                  hn::Sub(hn::LoadU(d, arrays[INADSlots::z] + c), qz));
    auto mask = hn::Lt(d2, r2);
    if constexpr (with_ties) {
      const auto index =
          hn::BitCast(Ints(), hn::LoadU(d, arrays[INADSlots::order] + c));
      const auto first = hn::RebindMask(d, hn::Not(hn::Gt(index, tie_index)));
      mask = hn::Or(mask, hn::And(hn::Eq(d2, tie_d2), first));
    }
    const auto chord = chordsFrom(arrays[INADSlots::nx] + c,
                                  arrays[INADSlots::ny] + c,
                                  arrays[INADSlots::nz] + c);
    count += packStore(d, chord, mask, chords + count);
  }
  const float *nx = block.nx, *ny = block.ny, *nz = block.nz;
  for (std::size_t s = 0; s < slots.sure_size; ++s, count += lanes) {
    const std::size_t j = slots.sure[s];
    hn::StoreU(chordsFrom(nx + j, ny + j, nz + j), d, chords + count);
  }
  hn::StoreU(hn::Set(d, min_chord), d, chords + count);
  return count;
}

/** \brief Squared chords, of which a vector follows them, to angles, and their sums. */
HWY_INLINE void
chordsToAngles(const float* HWY_RESTRICT chords,
               std::size_t count,
               std::uint32_t* HWY_RESTRICT angles,
               AngleAdder& adder)
{
  const Floats d;
  const Words w;
  for (std::size_t c = 0; c < count;) {
    const std::size_t end = std::min(count, c + additions_between_widening * lanes);
    for (; c < end; c += lanes) {
      const auto units = anglesOf(hn::Load(d, chords + c));
      hn::Store(units, w, angles + c);
      adder.add(units);
    }
    adder.widen();
  }
}

/** \brief Packs the angles that are not in a range, in place; of what follows them, a
 * vector is overwritten. \return how many they are */
template <bool from_zero>
HWY_INLINE std::size_t
packRejected(std::uint32_t* HWY_RESTRICT angles,
             std::size_t count,
             std::uint32_t min,
             std::uint32_t width)
{
  const Words w;
  // One unsigned comparison: what is below the first wraps around.
  const auto from = hn::Set(w, min);
  const auto max = hn::Set(w, width);
  std::size_t rejected = 0;
  const auto isRejected = [&](auto units) {
    return hn::Gt(from_zero ? units : hn::Sub(units, from), max);
  };
  std::size_t c = 0;
  for (; c + lanes <= count; c += lanes) {
    const auto units = hn::Load(w, angles + c);
    rejected += packStore(w, units, isRejected(units), angles + rejected);
  }
  const auto units = hn::Load(w, angles + c);
  const auto mask = hn::And(isRejected(units), hn::FirstN(w, count - c));
  rejected += packStore(w, units, mask, angles + rejected);
  hn::StoreU(hn::Zero(w), w, angles + rejected);
  return rejected;
}

HWY_INLINE std::size_t
packRejected(std::uint32_t* angles,
             std::size_t count,
             std::uint32_t min,
             std::uint32_t width)
{
  // In one vector, a subtraction takes less time than a branch that goes either way.
  return min == 0 && count > lanes ? packRejected<true>(angles, count, min, width)
                                   : packRejected<false>(angles, count, min, width);
}

/** \brief Sums over angles that a vector of zeros follows. */
HWY_INLINE void
addAngles(const std::uint32_t* HWY_RESTRICT angles,
          std::size_t count,
          AngleAdder& adder)
{
  const Words w;
  // At least one: mostly there are one or none, and which cannot be predicted.
  std::size_t c = 0;
  do {
    const std::size_t end = std::min(count, c + additions_between_widening * lanes);
    do {
      adder.add(hn::Load(w, angles + c));
      c += lanes;
    }
    while (c < end);
    adder.widen();
  }
  while (c < count);
}

} // namespace pcl::kernels::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
