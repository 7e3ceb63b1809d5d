// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// The class NeighborhoodSweep: checks, sorts, and stores what the kernels compute.

#include "common/finite.h"
#include "common/number_text.h"
#include "sweep/block_sweep.h"
#include "sweep/index/row_width.h"
#include "sweep/portable/targets.h"

#include <pcl/features/sweep_index.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <optional>

namespace pcl {
namespace {

using namespace kernels;

void
checkRadius(double radius)
{
  if (!(radius > 0.0) || !std::isfinite(radius)) {
    throw std::invalid_argument("radius " + detail::numberText(radius) +
                                ": it must be positive and finite (meters)");
  }
}

void
checkSize(const NeighborhoodSize& size, std::size_t queries)
{
  const int given = (size.radius != 0.0) + (size.radii != nullptr) + (size.k != 0);
  if (given != 1) {
    throw std::invalid_argument("set one of radius, radii and k, not " +
                                std::to_string(given) + " of them");
  }
  if (size.radii)
    std::for_each(size.radii, size.radii + queries, checkRadius);
  else if (size.k == 0)
    checkRadius(size.radius);
}

/** With few points threads would wait for each other most of the time, and where others
 * use the processors, that is long. */
unsigned
threadsFor(std::size_t points, unsigned threads)
{
  constexpr std::size_t points_per_thread = 4096;
  return static_cast<unsigned>(
      std::clamp<std::size_t>(points / points_per_thread, 1, threadCount(threads)));
}

std::size_t
countFinite(const XYZView& points, unsigned threads)
{
  std::atomic<std::size_t> count{0};
  parallelForRanges(points.size, threads, [&](std::size_t begin, std::size_t end) {
    count += kernels::countFinite({points[begin], points.stride, end - begin});
  });
  return count;
}

} // namespace

/** \brief The surface and the queries, sorted for one call. */
class NeighborhoodSweep::Prepared {
public:
  /** \param[in] by_radius rows are as wide as the radius says, if there is one: then
   * the order of neighbors depends on nothing else. Otherwise the density decides.
   * \throws std::invalid_argument if the sizes are out of range */
  Prepared(const NeighborhoodSweep& sweep, const NeighborhoodSize& size, bool by_radius)
  : sweep_(sweep)
  , threads_(threadsFor(sweep.surface_.size + sweep.size(), sweep.threads_))
  {
    // Positions have 32 bits, and kernels compare them as signed numbers.
    constexpr std::size_t max_size = std::numeric_limits<std::int32_t>::max();
    if (sweep.surface_.size > max_size || sweep.size() > max_size)
      throw std::invalid_argument("more than 2^31 - 1 points: split the cloud");
    checkSize(size, sweep.size());
    const std::size_t finite = countFinite(sweep.surface_, threads_);
    if (size.k > finite) {
      throw std::invalid_argument("k " + std::to_string(size.k) + ": it must be 1 to " +
                                  std::to_string(finite) +
                                  ", the number of finite points");
    }
    if (sweep.size() == 0 || finite == 0)
      return;
    by_radius = by_radius && size.radius > 0.0;
    const double edge = by_radius ? rowWidthOf(size.radius)
                                  : rowWidth(size, sweep.surface_, sweep.size());
    SweepIndex index;
    surface_ = (sweep.index_ ? *sweep.index_ : index)
                   .rowsOf(sweep.surface_, finite, {edge, by_radius}, threads_);
    if (sweep.own_queries_ || sweep.has_indices_) {
      own_queries_ = buildRowIndex(
          sweep.queryPoints(), sweep.indices_, sweep.size(), surface_->edge, threads_);
    }
    blocks_.emplace(BlockSweep{*surface_,
                               own_queries_ ? *own_queries_ : *surface_,
                               size,
                               !sweep.own_queries_,
                               by_radius});
  }

  void
  setNormals(const XYZView& normals)
  {
    if (blocks_) {
      normals_ = unitNormals(normals, surface_.get(), threads_);
      blocks_->normals = &normals_;
    }
  }

  /** \brief Whether run() has no result for some queries: those that are not finite. */
  bool
  leavesSomeOut() const
  {
    return (blocks_ ? blocks_->queries.size() : 0) != sweep_.size();
  }

  /** \brief kernel(block, order, results), then store(position, result) for each query,
   * or copy(position, same) where another query has the same result. */
  template <typename Result, typename Kernel, typename Store, typename Copy>
  void
  run(const Kernel& kernel, const Store& store, const Copy& copy) const
  {
    if (!blocks_)
      return;
    blocks_->forEachBlock(threads_, [&](SweepBlock& block, const std::uint32_t* order) {
      Result results[block_size];
      kernel(block, order, results);
      for (std::size_t i = 0; i < block.size; ++i)
        store(order[i], results[i]);
    });
    blocks_->forEachRepeat(copy);
  }

private:
  const NeighborhoodSweep& sweep_;
  unsigned threads_;
  std::shared_ptr<const RowIndex> surface_;
  std::optional<RowIndex> own_queries_;
  UnitNormals normals_;
  std::optional<BlockSweep> blocks_;
};

bool
NeighborhoodSweep::computeNormals(const NeighborhoodSize& neighborhood,
                                  float* normals,
                                  float* curvature,
                                  std::size_t stride) const
{
  const Prepared prepared(*this, neighborhood, true);
  std::atomic<bool> is_finite{!prepared.leavesSomeOut()};
  const auto store = [&](std::size_t i, const NormalResult& result) {
    float* normal = normals + i * stride;
    normal[0] = result.x;
    normal[1] = result.y;
    normal[2] = result.z;
    curvature[i * stride] = result.curvature;
    if (std::isnan(result.x))
      is_finite = false;
  };
  for (std::size_t i = 0; prepared.leavesSomeOut() && i < size(); ++i)
    store(i, unknown_normal);
  prepared.run<NormalResult>(
      [](const SweepBlock& block, const std::uint32_t*, NormalResult* results) {
        chosenKernels().normals(block, results);
      },
      store,
      [&](std::size_t i, std::size_t same) {
        std::copy_n(normals + same * stride, 3, normals + i * stride);
        curvature[i * stride] = curvature[same * stride];
      });
  return is_finite;
}

bool
NeighborhoodSweep::computeINAD(const NeighborhoodSize& neighborhood,
                               const XYZView& normals,
                               double outlier_rate,
                               float* mu_sigma) const
{
  checkINADInput(surface_.size, normals.size, outlier_rate);
  Prepared prepared(*this, neighborhood, false);
  prepared.setNormals(normals);
  std::atomic<bool> is_finite{!prepared.leavesSomeOut()};
  if (prepared.leavesSomeOut())
    std::fill_n(mu_sigma, 2 * size(), nan);
  prepared.run<INADResult>(
      [&](SweepBlock& block, const std::uint32_t* order, INADResult* results) {
        for (std::size_t i = 0;
             has_indices_ && block.queries_on_surface && i < block.size;
             ++i) {
          const UnitNormal own = unitNormal(normals[surfaceIndex(order[i])]);
          block.qnx[i] = own.x;
          block.qny[i] = own.y;
          block.qnz[i] = own.z;
        }
        chosenKernels().inad(block, outlier_rate, results);
      },
      [&](std::size_t i, const INADResult& result) {
        mu_sigma[2 * i] = result.mu;
        mu_sigma[2 * i + 1] = result.sigma;
        if (std::isnan(result.mu))
          is_finite = false;
      },
      [&](std::size_t i, std::size_t same) {
        std::copy_n(mu_sigma + 2 * same, 2, mu_sigma + 2 * i);
      });
  return is_finite;
}

void
NeighborhoodSweep::countNeighbors(const NeighborhoodSize& neighborhood,
                                  std::uint32_t* counts) const
{
  const Prepared prepared(*this, neighborhood, false);
  std::fill_n(counts, size(), 0);
  prepared.run<std::uint32_t>(
      [](const SweepBlock& block, const std::uint32_t*, std::uint32_t* results) {
        chosenKernels().count(block, results);
      },
      [&](std::size_t i, std::uint32_t count) { counts[i] = count; },
      [&](std::size_t i, std::size_t same) { counts[i] = counts[same]; });
}

void
NeighborhoodSweep::computeDistanceToNearest(std::size_t k, float* distances) const
{
  const Prepared prepared(*this, NeighborhoodSize::ofNearest(k), false);
  std::fill_n(distances, size(), nan);
  prepared.run<float>(
      [](const SweepBlock& block, const std::uint32_t*, float* results) {
        std::copy_n(block.kth_d2, block.size, results);
      },
      [&](std::size_t i, float d2) { distances[i] = std::sqrt(d2); },
      [&](std::size_t i, std::size_t same) { distances[i] = distances[same]; });
}

} // namespace pcl
