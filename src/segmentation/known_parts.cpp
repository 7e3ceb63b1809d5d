// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// The noise and the edges of a part of a cloud whose neighbors were found before.

#include "edges/edge_detection.h"

#include <pcl/segmentation/known_parts.h>
#include <pcl/features/impl/neighborhoods.hpp>

#include <array>
#include <cmath>
#include <cstring>
#include <limits>
#include <numeric>
#include <stdexcept>
#include <string>

namespace pcl {
namespace {

using namespace detail;

float
spacingAt(const KnownPart& part, std::size_t place, const CloudNumbers& numbers)
{
  const float distance = part.distances[place];
  return spacingOf(std::isinf(distance) ? std::numeric_limits<float>::max() : distance,
                   numbers.distance);
}

pcl::Indices
allOf(const XYZView& points)
{
  pcl::Indices all(points.size);
  std::iota(all.begin(), all.end(), 0);
  return all;
}

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

/** The points of a part within a distance of some of them, and others. */
class Surroundings {
public:
  /** \param[in] cells in the distance: the more, the fewer others */
  Surroundings(const KnownPart& part,
               const CloudNumbers& numbers,
               const pcl::Indices& chosen,
               double reach,
               int cells)
  {
    // Wider than the reach: what is rounded is not missed.
    constexpr double wider = 1.01;
    const auto cell = static_cast<float>(wider * reach / cells);
    std::vector<bool> is_chosen(part.places.size);
    CellSet near;
    for (const pcl::index_t i : chosen)
      if (const auto at = static_cast<std::size_t>(i); part.is_measured[at]) {
        is_chosen[at] = true;
        addAround(cellOf(part.places[at], cell), cells, near);
      }
    for (std::size_t i = 0; i < part.places.size; ++i) {
      const float* const p = part.places[i];
      if (!near.holds(cellOf(p, cell)))
        continue;
      if (is_chosen[i])
        this->chosen.push_back(static_cast<pcl::index_t>(spacings.size()));
      spacings.push_back(spacingAt(part, i, numbers));
      positions_.insert(positions_.end(), p, p + 3);
    }
    all_ = allOf(view());
  }

  XYZView
  view() const
  {
    return {positions_.data(), 3, positions_.size() / 3};
  }

  /** Of all points in view(). */
  Neighborhoods
  neighborhoods(unsigned threads) const
  {
    return {view(), view(), all_, threads};
  }

  pcl::Indices chosen; ///< of the points in view()
  std::vector<float> spacings;

private:
  static CellSet::Cell
  cellOf(const float* p, float cell)
  {
    return {std::floor(p[0] / cell) + 0.0f, // 0 has one sign
            std::floor(p[1] / cell) + 0.0f,
            std::floor(p[2] / cell) + 0.0f};
  }

  static void
  addAround(const CellSet::Cell& cell, int cells, CellSet& near)
  {
    for (int x = -cells; x <= cells; ++x)
      for (int y = -cells; y <= cells; ++y)
        for (int z = -cells; z <= cells; ++z)
          near.add({cell[0] + static_cast<float>(x),
                    cell[1] + static_cast<float>(y),
                    cell[2] + static_cast<float>(z)});
  }

  std::vector<float> positions_;
  pcl::Indices all_;
};

} // namespace

NoiseMeasures
measureNoise(const KnownPart& part,
             const CloudNumbers& numbers,
             std::uint64_t places,
             unsigned threads)
{
  const double most = mostSpacing(numbers.distance);
  NoiseMeasures measures;
  // Many points with few around each, then few with many.
  const Surroundings flat(
      part, numbers, noisePoints(part.places, places), variationReach() * most, 1);
  if (!flat.chosen.empty())
    measures.variations =
        variationsAt(flat.chosen, flat.neighborhoods(threads), flat.spacings);
  const Surroundings wide(
      part, numbers, anglePoints(part.places, places), angleReach() * most, 3);
  if (!wide.chosen.empty())
    measures.angles =
        normalAngles(wide.chosen,
                     wide.neighborhoods(threads),
                     wide.spacings,
                     segmentation::PointGrid(wide.view(), 2.0f * numbers.spacing));
  return measures;
}

ShapeField
edgesOf(const KnownPart& part,
        const shared_ptr<const void>& cloud,
        const CloudNumbers& numbers,
        unsigned threads)
{
  if (part.distances.size() != part.places.size)
    throw std::invalid_argument(
        std::to_string(part.distances.size()) + " distances are given for " +
        std::to_string(part.places.size) + " places: one for each is needed");
  const pcl::Indices all = allOf(part.places);
  const Neighborhoods neighborhoods(part.places, part.places, all, threads);
  const FieldInput input{neighborhoods, part.places, {}, threads, false, &numbers};
  ShapeField field;
  field.cloud = cloud;
  field.points = part.places;
  for (std::size_t i = 0; i < part.places.size; ++i)
    field.spacings.push_back(spacingAt(part, i, numbers));
  field.noise = numbers.noise;
  field.noise_level = numbers.noise_level;
  const segmentation::Bounds bounds = boundsOf(numbers);
  const MeasuredCloud measured{
      bounds,
      numbers.spacing,
      segmentation::PointGrid(part.places, 2.0f * numbers.spacing, bounds),
      {numbers.noise_level, numbers.noise_correlation},
      part.places.size};
  findEdges(input, measured, ShapeModel::defaultEdges(), field);
  return field;
}

} // namespace pcl
