// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Which points are at the same place, by a hash of their coordinates.

#include "common/finite.h"

#include <pcl/features/distinct_points.h>

#include <algorithm>
#include <array>
#include <cstring>

namespace pcl {
namespace {

// A slot has some bits of a hash and one more than a place; 0 if it is free.
using Slot = std::uint64_t;
constexpr Slot place_mask = 0xffffffffU;
constexpr std::size_t ahead = 16; // slots that are fetched before they are needed

/** A zero of either sign has the same bits. */
std::uint64_t
bitsOf(float coordinate)
{
  const float without_sign_of_zero = coordinate + 0.0f;
  std::uint32_t bits = 0;
  std::memcpy(&bits, &without_sign_of_zero, sizeof bits);
  return bits;
}

/** Coordinates of sensors differ in few bits: each must reach all bits of the hash. The
 * steps and factors are those of MurmurHash3's last mixing. */
std::uint64_t
hashOf(const float* p)
{
  std::uint64_t hash = bitsOf(p[0]) | bitsOf(p[1]) << 32;
  hash = (hash ^ hash >> 33) * 0xff51afd7ed558ccdU;
  hash ^= bitsOf(p[2]) * 0x9e3779b97f4a7c15U; // 2^64 over the golden ratio
  hash = (hash ^ hash >> 33) * 0xc4ceb9fe1a85ec53U;
  return hash ^ hash >> 33;
}

bool
areEqual(const float* p, const float* q)
{
  return p[0] == q[0] && p[1] == q[1] && p[2] == q[2];
}

std::int32_t
placeIn(Slot slot)
{
  return static_cast<std::int32_t>((slot & place_mask) - 1);
}

class Places {
public:
  explicit Places(const XYZView& points) : points_(points)
  {
    // At most half of the slots are taken. A cloud with many repeats needs few of them,
    // and does not leave the cache then.
    std::size_t slots = 2 * ahead;
    while (slots < points.size / 8)
      slots *= 2;
    slots_.resize(slots);
    distinct_.place.reserve(points.size);
  }

  DistinctPoints
  run()
  {
    std::array<std::uint64_t, ahead> hashes{};
    for (std::size_t begin = 0; begin < points_.size; begin += ahead) {
      const std::size_t count = std::min(ahead, points_.size - begin);
      if (2 * (distinct_.first.size() + count) > slots_.size())
        grow();
      for (std::size_t k = 0; k < count; ++k) {
        hashes[k] = hashOf(points_[begin + k]);
        __builtin_prefetch(&slots_[hashes[k] & (slots_.size() - 1)]);
      }
      for (std::size_t k = 0; k < count; ++k)
        add(begin + k, hashes[k]);
    }
    if (distinct_.first.size() == points_.size)
      return {};
    return std::move(distinct_);
  }

private:
  void
  grow()
  {
    std::vector<Slot> old(4 * slots_.size());
    old.swap(slots_);
    for (const Slot slot : old) {
      if (slot == 0)
        continue;
      const auto first = distinct_.first[static_cast<std::size_t>(placeIn(slot))];
      const std::uint64_t hash = hashOf(points_[static_cast<std::size_t>(first)]);
      std::size_t at = hash & (slots_.size() - 1);
      while (slots_[at] != 0)
        at = (at + 1) & (slots_.size() - 1);
      slots_[at] = slot;
    }
  }

  void
  add(std::size_t i, std::uint64_t hash)
  {
    const float* const p = points_[i];
    const bool is_finite = kernels::isFinite(p);
    // Mostly so, if there are many repeats.
    if (i > 0 && is_finite && areEqual(p, points_[i - 1])) {
      distinct_.place.push_back(distinct_.place.back());
      return;
    }
    const auto next = static_cast<std::int32_t>(distinct_.first.size());
    std::int32_t place = next;
    if (is_finite) {
      const Slot tag = hash & ~place_mask;
      std::size_t at = hash & (slots_.size() - 1);
      for (; slots_[at] != 0; at = (at + 1) & (slots_.size() - 1)) {
        if ((slots_[at] & ~place_mask) != tag)
          continue;
        const std::int32_t other = placeIn(slots_[at]);
        const auto first = distinct_.first[static_cast<std::size_t>(other)];
        if (areEqual(p, points_[static_cast<std::size_t>(first)])) {
          place = other;
          break;
        }
      }
      if (place == next)
        slots_[at] = tag | (static_cast<Slot>(next) + 1);
    }
    if (place == next)
      distinct_.first.push_back(static_cast<std::int32_t>(i));
    distinct_.place.push_back(place);
  }

  XYZView points_;
  std::vector<Slot> slots_;
  DistinctPoints distinct_;
};

} // namespace

DistinctPoints
distinctPoints(const XYZView& points)
{
  return Places(points).run();
}

} // namespace pcl
