// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Normals over the neighborhoods of a block of points, all lanes at a time.

// No include guard: simd_kernels.cpp includes it once for each target.

#include "sweep/portable/symmetric_eigen.h"
#include "sweep/simd/moments-inl.h"

HWY_BEFORE_NAMESPACE();
namespace pcl::kernels::HWY_NAMESPACE {

using DoubleV = hn::VFromD<Doubles>;

/** \brief Symmetric matrices, one a lane, scaled to trace 1, and their characteristic
 * polynomials l^3 - l^2 + c1 l - c0. */
struct MatrixLanes {
  DoubleV xx, xy, xz, yy, yz, zz, c1, c0;
};

/** \brief a b - c e. */
HWY_INLINE DoubleV
minorOf(DoubleV a, DoubleV b, DoubleV c, DoubleV e)
{
  return hn::NegMulAdd(c, e, hn::Mul(a, b));
}

HWY_INLINE MatrixLanes
scaledToTraceOne(const BlockCovariances& m, std::size_t first)
{
  const Doubles d;
  const auto load = [&](const double* values) { return hn::Load(d, values + first); };
  const auto trace = hn::Add(hn::Add(load(m.xx), load(m.yy)), load(m.zz));
  const auto scale = hn::Div(hn::Set(d, 1.0), trace);
  const auto xx = hn::Mul(load(m.xx), scale), xy = hn::Mul(load(m.xy), scale),
             xz = hn::Mul(load(m.xz), scale), yy = hn::Mul(load(m.yy), scale),
             yz = hn::Mul(load(m.yz), scale), zz = hn::Mul(load(m.zz), scale);
  const auto x_minor = minorOf(yy, zz, yz, yz);
  const auto c1 =
      hn::Add(hn::Add(minorOf(xx, yy, xy, xy), minorOf(xx, zz, xz, xz)), x_minor);
  const auto xy_term = hn::Mul(xy, minorOf(xy, zz, yz, xz));
  const auto xz_term = hn::Mul(xz, minorOf(xy, yz, yy, xz));
  const auto c0 = hn::Add(hn::MulSub(xx, x_minor, xy_term), xz_term);
  return {xx, xy, xz, yy, yz, zz, c1, c0};
}

/** \brief The smallest roots of l^3 - l^2 + c1 l - c0 by Newton's method from 0, from
 * where it climbs to them. Each stops by itself, whatever the others do; all vectors of
 * them take their steps in turn, as each waits for its divisions. */
HWY_INLINE void
findSmallestRoots(const double* c1, const double* c0, std::size_t size, double* roots)
{
  const Doubles d;
  constexpr int max_steps = 64;             // a bound: its square root is usual
  const auto min_climb = hn::Set(d, 1e-15); // rounding, beside a trace of 1
  HWY_ALIGN double moving[block_size];
  std::fill_n(moving, block_size, 1.0);
  std::fill_n(roots, block_size, 0.0);
  bool any_moves = true;
  for (int step = 0; step < max_steps && any_moves; ++step) {
    any_moves = false;
    for (std::size_t i = 0; i < size; i += double_lanes) {
      const auto root = hn::Load(d, roots + i), linear = hn::Load(d, c1 + i);
      const auto shifted = hn::Sub(root, hn::Set(d, 1.0));
      const auto value =
          hn::MulSub(hn::MulAdd(shifted, root, linear), root, hn::Load(d, c0 + i));
      const auto twice = hn::MulSub(hn::Set(d, 3.0), root, hn::Set(d, 2.0));
      const auto slope = hn::MulAdd(twice, root, linear);
      const auto climb = hn::Neg(hn::Div(value, slope));
      const auto climbs = hn::And(hn::Gt(climb, min_climb), hn::Gt(slope, hn::Zero(d)));
      const auto moves = hn::And(hn::Gt(hn::Load(d, moving + i), hn::Zero(d)), climbs);
      hn::Store(hn::IfThenElseZero(moves, hn::Set(d, 1.0)), d, moving + i);
      hn::Store(hn::Add(root, hn::IfThenElseZero(moves, climb)), d, roots + i);
      any_moves = any_moves || !hn::AllFalse(d, moves);
    }
  }
}

/** \brief Whether a root is the smallest one, with no other close to it. At a multiple
 * root the slope and the value are both rounding, and a step may go anywhere; the
 * smallest is at most a third of the trace, and up to there the slope is positive
 * before the first extremum only. */
HWY_INLINE MaskOf<Doubles>
isSimple(DoubleV root, DoubleV c1)
{
  const Doubles d;
  constexpr double min_slope = 1e-5; // a step then is exact to 1e-10
  const auto twice = hn::MulSub(hn::Set(d, 3.0), root, hn::Set(d, 2.0));
  const auto slope = hn::MulAdd(twice, root, c1);
  return hn::And(hn::Gt(slope, hn::Set(d, min_slope)),
                 hn::Lt(root, hn::Set(d, 1.0 / 3.0)));
}

/** \brief Vectors, one a lane. */
struct VectorLanes {
  DoubleV x, y, z, squared_length;
};

HWY_INLINE VectorLanes
vectorLanes(DoubleV x, DoubleV y, DoubleV z)
{
  return {x, y, z, hn::MulAdd(x, x, hn::MulAdd(y, y, hn::Mul(z, z)))};
}

HWY_INLINE VectorLanes
longer(const VectorLanes& a, const VectorLanes& b)
{
  const auto is_b = hn::Gt(b.squared_length, a.squared_length);
  return {hn::IfThenElse(is_b, b.x, a.x),
          hn::IfThenElse(is_b, b.y, a.y),
          hn::IfThenElse(is_b, b.z, a.z),
          hn::IfThenElse(is_b, b.squared_length, a.squared_length)};
}

/** \brief The longest cross product of two rows of M - l I. */
HWY_INLINE VectorLanes
eigenvectors(const MatrixLanes& m, DoubleV root)
{
  const auto xx = hn::Sub(m.xx, root), yy = hn::Sub(m.yy, root),
             zz = hn::Sub(m.zz, root);
  const auto first = vectorLanes(minorOf(m.xy, m.yz, m.xz, yy),
                                 minorOf(m.xz, m.xy, xx, m.yz),
                                 minorOf(xx, yy, m.xy, m.xy));
  const auto second = vectorLanes(minorOf(m.xy, zz, m.xz, m.yz),
                                  minorOf(m.xz, m.xz, xx, zz),
                                  minorOf(xx, m.yz, m.xy, m.xz));
  const auto third = vectorLanes(minorOf(yy, zz, m.yz, m.yz),
                                 minorOf(m.yz, m.xz, m.xy, zz),
                                 minorOf(m.xy, m.yz, yy, m.xz));
  return longer(longer(first, second), third);
}

/** \brief As normalOfCovariance(), for all queries at once. */
HWY_INLINE void
normalsOfCovariances(const BlockCovariances& covariances,
                     std::size_t size,
                     NormalResult* results)
{
  const Doubles d;
  HWY_ALIGN double x[block_size], y[block_size], z[block_size], roots[block_size];
  HWY_ALIGN double safe[block_size];
  HWY_ALIGN double c1[block_size], c0[block_size];
  for (std::size_t i = 0; i < size; i += double_lanes) {
    const auto m = scaledToTraceOne(covariances, i);
    hn::Store(m.c1, d, c1 + i);
    hn::Store(m.c0, d, c0 + i);
  }
  findSmallestRoots(c1, c0, size, roots);
  for (std::size_t i = 0; i < size; i += double_lanes) {
    const auto m = scaledToTraceOne(covariances, i);
    const auto root = hn::Load(d, roots + i);
    const auto v = eigenvectors(m, root);
    const auto scale = hn::Div(hn::Set(d, 1.0), hn::Sqrt(v.squared_length));
    hn::Store(hn::Mul(v.x, scale), d, x + i);
    hn::Store(hn::Mul(v.y, scale), d, y + i);
    hn::Store(hn::Mul(v.z, scale), d, z + i);
    // The other two roots have the sum s and the product q; q <= ratio s^2 on a line.
    const auto s = hn::Sub(hn::Set(d, 1.0), root);
    const auto q = hn::NegMulAdd(root, s, m.c1);
    // Shorter than 1e-8, half of a product's digits have canceled.
    const auto is_safe =
        hn::And(hn::Gt(v.squared_length, hn::Set(d, 1e-16)),
                hn::Gt(q, hn::Mul(hn::Set(d, 4.0 * line_ratio), hn::Mul(s, s))));
    const auto is_simple = isSimple(root, m.c1);
    hn::Store(
        hn::IfThenElseZero(hn::And(is_safe, is_simple), hn::Set(d, 1.0)), d, safe + i);
  }
  for (std::size_t i = 0; i < size; ++i) {
    results[i] = safe[i] != 0.0 ? NormalResult{static_cast<float>(x[i]),
                                               static_cast<float>(y[i]),
                                               static_cast<float>(z[i]),
                                               static_cast<float>(roots[i])}
                                : normalOfCovariance({covariances.xx[i],
                                                      covariances.xy[i],
                                                      covariances.xz[i],
                                                      covariances.yy[i],
                                                      covariances.yz[i],
                                                      covariances.zz[i]});
  }
}

/** More points than these, and sums in float lose what normals need. */
constexpr float max_for_float = 1 << 12;

/** The product of a plane's two larger eigenvalues over the square of the mean squared
 * offset, which is what float sums are exact to some 1e-7 of: normals turn by less than
 * 2e-4 rad then, mostly by less than 1e-5. */
constexpr double min_plane_ratio = 1e-2;

/** \brief Whether squares of offsets, and sums of them, are far from the limits of
 * float. */
inline bool
suitsFloat(const SweepBlock& block)
{
  constexpr float min = 1e-24f, max = 1e24f;
  return block.rows_by_radius && block.tie_d2[0] < 0.0f && block.r2[0] > min &&
         block.r2[0] < max;
}

HWY_INLINE void
covariancesOf(const OrderedMoments& m, BlockCovariances& c)
{
  const Doubles d;
  const hn::Rebind<float, Doubles> floats;
  const std::size_t first[] = {sum_x, sum_x, sum_x, sum_y, sum_y, sum_z};
  const std::size_t second[] = {sum_x, sum_y, sum_z, sum_y, sum_z, sum_z};
  double* const products[] = {c.xx, c.xy, c.xz, c.yy, c.yz, c.zz};
  for (std::size_t i = 0; i < block_size; i += double_lanes) {
    const auto at = [&](std::size_t moment) {
      return hn::PromoteTo(d, hn::LoadU(floats, m.sums[moment] + i));
    };
    const auto n = hn::PromoteTo(d, hn::LoadU(floats, m.counts + i));
    const auto inverse = hn::Div(hn::Set(d, 1.0), hn::Max(hn::Set(d, 1.0), n));
    for (std::size_t p = 0; p < 6; ++p) {
      const auto product = hn::Mul(at(first[p]), at(second[p]));
      const auto central = hn::NegMulAdd(product, inverse, at(OrderedMoments::xx + p));
      hn::Store(hn::Mul(central, inverse), d, products[p] + i);
    }
  }
}

/** \brief Whether the sums say what the normal is: there are not too many, and what is
 * left of them about the mean is not of a line, or a point, or small beside them. */
inline bool
isPlain(const OrderedMoments& m, const BlockCovariances& c, std::size_t i)
{
  const double minors = c.xx[i] * c.yy[i] - c.xy[i] * c.xy[i] + c.xx[i] * c.zz[i] -
                        c.xz[i] * c.xz[i] + c.yy[i] * c.zz[i] - c.yz[i] * c.yz[i];
  const double squares = static_cast<double>(m.sums[OrderedMoments::xx][i]) +
                         m.sums[OrderedMoments::yy][i] + m.sums[OrderedMoments::zz][i];
  const double mean_square = squares / m.counts[i];
  return m.counts[i] <= max_for_float &&
         minors > min_plane_ratio * mean_square * mean_square;
}

/** \brief Normals from sums of floats, in the order of the rows and of the points in
 * them, which depends on the radius and on the neighbors alone.
 * \return whether all are known; is_known tells which */
HWY_INLINE bool
orderedNormals(const SweepBlock& block, NormalResult* results, bool* is_known)
{
  OrderedMoments moments;
  sumInOrder(block, moments);
  BlockCovariances covariances;
  covariancesOf(moments, covariances);
  normalsOfCovariances(covariances, block.size, results);
  bool all_known = true;
  for (std::size_t i = 0; i < block.size; ++i) {
    const float count = moments.counts[i];
    const std::size_t own = hasOwnPoint(block, i, count > 0.0f) ? 1 : 0;
    const bool has_few =
        count < static_cast<float>(NeighborhoodSweep::min_neighbors + own);
    if (has_few)
      results[i] = unknown_normal;
    is_known[i] = has_few || isPlain(moments, covariances, i);
    all_known = all_known && is_known[i];
  }
  return all_known;
}

/** \brief Queries of a block whose moments are taken about one origin. */
struct Group {
  double has[block_size] = {}; ///< 1 or 0
  int level = 0;
};

/** \brief The origin in units: below all neighbors of the group. Returns the largest
 * coordinate of a neighbor of any query, absolute, in units. */
HWY_INLINE double
setOrigin(const SweepBlock& block, const Group& group, BlockMoments& sums)
{
  const Doubles d;
  const auto scale = hn::Set(d, std::ldexp(1.0, offset_bits - group.level));
  const float* coordinates[] = {block.qx, block.qy, block.qz};
  const hn::Rebind<float, Doubles> floats;
  auto largest = hn::Zero(d);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    auto min = hn::Set(d, std::numeric_limits<double>::infinity());
    for (std::size_t i = 0; i < block_size; i += double_lanes) {
      const auto q = hn::PromoteTo(d, hn::LoadU(floats, coordinates[axis] + i));
      const auto units = hn::Round(hn::Mul(q, scale));
      hn::Store(units, d, sums.own[axis] + i);
      const auto has = hn::Gt(hn::LoadU(d, group.has + i), hn::Zero(d));
      const auto is_query = hn::FirstN(d, block.size > i ? block.size - i : 0);
      min = hn::Min(min, hn::IfThenElse(has, units, min));
      largest = hn::Max(largest, hn::IfThenElseZero(is_query, hn::Abs(units)));
    }
    constexpr double below = (1 << offset_bits) + 2;
    sums.origin[axis] = hn::GetLane(hn::MinOfLanes(d, min)) - below;
    for (std::size_t i = 0; i < block_size; i += double_lanes) {
      const auto own = hn::Load(d, sums.own[axis] + i);
      hn::Store(hn::Sub(own, hn::Set(d, sums.origin[axis])), d, sums.own[axis] + i);
    }
  }
  constexpr double reach = 1 << (offset_bits + 1);
  return hn::GetLane(hn::MaxOfLanes(d, largest)) + reach;
}

/** So many are faster one by one. */
constexpr std::ptrdiff_t few_queries = 4;

/** With so many the sum of a lane is below 2^32. */
constexpr std::size_t clusters_between_widening =
    candidates_between_widening * lanes / block_size;

HWY_INLINE BlockMoments
sumMoments(const SweepBlock& block, const NearClusters& near, const Group& group)
{
  BlockMoments sums{};
  const double largest = setOrigin(block, group, sums);
  const Quantizer quantizer(group.level, sums.origin, largest);
  SweepBlock own = block; // the others have no neighbors
  for (std::size_t i = 0; i < block_size; ++i)
    if (group.has[i] == 0.0)
      own.r2[i] = own.tie_d2[i] = -1.0f;
  const bool are_few =
      !near.has_ties &&
      std::count(group.has, group.has + block_size, 1.0) <= few_queries;
  const std::size_t portion = are_few ? clusters_between_widening : max_clusters;
  for (std::size_t begin = 0; begin < near.size; begin += portion) {
    const std::size_t count = std::min(portion, near.size - begin);
    if (!are_few)
      near.has_ties ? addClusters<true>(own, near, begin, count, quantizer, sums)
                    : addClusters<false>(own, near, begin, count, quantizer, sums);
    for (std::size_t i = 0; are_few && i < block.size; ++i)
      if (group.has[i] != 0.0)
        addNeighborsOf(i, block, near, begin, count, quantizer, sums);
  }
  return sums;
}

/** \brief The group of query i: those of its level, if all of them fit around one
 * origin, else i alone. The sums are exact: which, makes no difference to them. */
HWY_INLINE Group
groupOf(const SweepBlock& block, const int* levels, std::size_t query)
{
  Group group;
  group.level = levels[query];
  const double scale = std::ldexp(1.0, offset_bits - group.level);
  for (std::size_t i = 0; i < block.size; ++i)
    group.has[i] = levels[i] == group.level ? 1.0 : 0.0;
  for (const float* coordinates : {block.qx, block.qy, block.qz}) {
    double min = coordinates[query], max = coordinates[query];
    for (std::size_t i = 0; i < block.size; ++i) {
      if (group.has[i] != 0.0) {
        min = std::min<double>(min, coordinates[i]);
        max = std::max<double>(max, coordinates[i]);
      }
    }
    constexpr double max_units = (1 << (offset_bits + 1)) - 16;
    if (!((max - min) * scale <= max_units)) {
      group = {};
      group.level = levels[query];
      group.has[query] = 1.0;
      break;
    }
  }
  return group;
}

/** Units are a fraction of the radius: neighbors that are all within a hundredth of it
 * are too few units apart, and are left to the portable kernel. */
constexpr double min_trace = 1 << 26;

/** \brief Squared, what follows from the neighbors alone: of k nearest points, r2 is
 * above the k-th's unless another one is as far. */
HWY_INLINE float
reach2Of(const SweepBlock& block, std::size_t i)
{
  return block.kth_d2[i] > 0.0f ? block.kth_d2[i] : block.r2[i];
}

/** \brief From exact sums: in whatever order. */
HWY_NOINLINE void
exactNormals(const SweepBlock& block, NormalResult* results)
{
  int levels[block_size];
  bool done[block_size] = {};
  for (std::size_t i = 0; i < block.size; ++i) {
    const bool is_as_before = i > 0 && reach2Of(block, i) == reach2Of(block, i - 1);
    levels[i] = is_as_before ? levels[i - 1] : levelOf(reach2Of(block, i));
  }
  const NearClusters near(block);
  for (std::size_t first = 0; first < block.size; ++first) {
    if (done[first])
      continue;
    const Group group = groupOf(block, levels, first);
    const BlockMoments sums = sumMoments(block, near, group);
    BlockCovariances covariances;
    NormalResult normals[block_size];
    centerMoments(sums, covariances);
    normalsOfCovariances(covariances, block.size, normals);
    for (std::size_t i = 0; i < block.size; ++i) {
      if (group.has[i] == 0.0)
        continue;
      done[i] = true;
      const std::size_t own = hasOwnPoint(block, i, sums.count[i] > 0) ? 1 : 0;
      if (sums.count[i] < NeighborhoodSweep::min_neighbors + own) {
        results[i] = unknown_normal;
        continue;
      }
      const double trace = covariances.xx[i] + covariances.yy[i] + covariances.zz[i];
      results[i] = trace < min_trace ? normalAt(block, i) : normals[i];
    }
  }
}

inline void
normals(const SweepBlock& block, NormalResult* results)
{
  bool is_known[block_size];
  if (!suitsFloat(block)) {
    exactNormals(block, results);
  }
  else if (!orderedNormals(block, results, is_known)) {
    NormalResult exact[block_size];
    exactNormals(block, exact);
    for (std::size_t i = 0; i < block.size; ++i)
      results[i] = is_known[i] ? results[i] : exact[i];
  }
}

} // namespace pcl::kernels::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
