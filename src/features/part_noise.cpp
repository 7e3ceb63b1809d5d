// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// The noise of a part of a cloud, however its spacings are found.

#include "features/part_noise.h"

#include "features/local_spacing.h"
#include "features/noise_level.h"

#include <array>
#include <cmath>
#include <cstring>
#include <numeric>
#include <stdexcept>

namespace pcl::detail {
namespace {

/** Cells of space, in a hash table. */
class CellSet {
public:
  using Cell = std::array<float, 3>; // whole numbers

  void
  add(const Cell& cell)
  {
    Slot& slot = slots_[indexOf(cell)];
    if (slot.is_taken)
      return;
    slot = {cell, true};
    if (2 * ++size_ > slots_.size())
      grow();
  }

  bool
  holds(const Cell& cell) const
  {
    return slots_[indexOf(cell)].is_taken;
  }

private:
  struct Slot {
    Cell cell{};
    bool is_taken = false;
  };

  static std::size_t
  hashOf(const Cell& cell)
  {
    std::uint64_t hash = 0;
    for (const float c : cell) { // steps of SplitMix64
      std::uint32_t bits = 0;
      std::memcpy(&bits, &c, sizeof bits);
      hash += bits + 0x9e3779b97f4a7c15U;
      hash = (hash ^ hash >> 30) * 0xbf58476d1ce4e5b9U;
      hash ^= hash >> 27;
    }
    return hash;
  }

  /** Where a cell is, or could be. */
  std::size_t
  indexOf(const Cell& cell) const
  {
    const std::size_t mask = slots_.size() - 1;
    std::size_t at = hashOf(cell) & mask;
    while (slots_[at].is_taken && slots_[at].cell != cell)
      at = (at + 1) & mask;
    return at;
  }

  void
  grow()
  {
    std::vector<Slot> old(2 * slots_.size());
    old.swap(slots_);
    for (const Slot& slot : old)
      if (slot.is_taken)
        slots_[indexOf(slot.cell)] = slot;
  }

  std::vector<Slot> slots_ = std::vector<Slot>(64); // a power of two
  std::size_t size_ = 0;
};

CellSet::Cell
cellOf(const float* p, float size)
{
  return {std::floor(p[0] / size) + 0.0f, // 0 has one sign
          std::floor(p[1] / size) + 0.0f,
          std::floor(p[2] / size) + 0.0f};
}

/** A cell, and as many on each side of it. */
void
addAround(const CellSet::Cell& cell, int cells, CellSet& set)
{
  for (int x = -cells; x <= cells; ++x)
    for (int y = -cells; y <= cells; ++y)
      for (int z = -cells; z <= cells; ++z)
        set.add({cell[0] + static_cast<float>(x),
                 cell[1] + static_cast<float>(y),
                 cell[2] + static_cast<float>(z)});
}

pcl::Indices
measuredOf(const pcl::Indices& chosen, const std::vector<bool>& is_measured)
{
  pcl::Indices measured;
  for (const pcl::index_t i : chosen)
    if (is_measured[static_cast<std::size_t>(i)])
      measured.push_back(i);
  return measured;
}

} // namespace

void
requireOneEach(std::size_t places, std::size_t count, const std::string& what)
{
  if (count != places)
    throw std::invalid_argument(std::to_string(count) + " " + what + " are given for " +
                                std::to_string(places) +
                                " places: one for each is needed");
}

pcl::Indices
allOf(const XYZView& points)
{
  pcl::Indices all(points.size);
  std::iota(all.begin(), all.end(), 0);
  return all;
}

PointsNear::PointsNear(const XYZView& points,
                       const pcl::Indices& some,
                       double reach,
                       int cells)
{
  // Wider than the reach: what is rounded is not missed.
  constexpr double wider = 1.01;
  const auto size = static_cast<float>(wider * reach / cells);
  CellSet near;
  for (const pcl::index_t i : some)
    addAround(cellOf(points[static_cast<std::size_t>(i)], size), cells, near);
  auto next = some.begin();
  for (std::size_t i = 0; !some.empty() && i < points.size; ++i) {
    const float* const p = points[i];
    if (!near.holds(cellOf(p, size)))
      continue;
    const auto index = static_cast<pcl::index_t>(i);
    if (next != some.end() && *next == index) {
      some_.push_back(static_cast<pcl::index_t>(indices_.size()));
      ++next;
    }
    indices_.push_back(index);
    positions_.insert(positions_.end(), p, p + 3);
  }
  all_ = allOf(view());
}

NoiseMeasures
noiseOfPart(const XYZView& places,
            const std::vector<bool>& is_measured,
            const SpacingsOfPart& spacings,
            const CloudNumbers& numbers,
            std::uint64_t places_of_cloud,
            unsigned threads)
{
  const auto near = [&](const pcl::Indices& chosen, double reach, int cells) {
    return PointsNear(places,
                      measuredOf(chosen, is_measured),
                      spacings.reach + reach * mostSpacing(numbers.distance),
                      cells);
  };
  NoiseMeasures measures;
  // Many points with few around each, then few with many.
  const PointsNear flat =
      near(noisePoints(places, places_of_cloud), variationReach(), 1);
  if (!flat.some().empty()) {
    const Neighborhoods neighborhoods = flat.neighborhoods(threads);
    measures.variations =
        variationsAt(flat.some(), neighborhoods, spacings.of(flat, neighborhoods));
  }
  const PointsNear wide = near(anglePoints(places, places_of_cloud), angleReach(), 3);
  if (!wide.some().empty()) {
    const Neighborhoods neighborhoods = wide.neighborhoods(threads);
    measures.angles = normalAngles(
        wide.some(), neighborhoods, spacings.of(wide, neighborhoods), threads);
  }
  return measures;
}

} // namespace pcl::detail
