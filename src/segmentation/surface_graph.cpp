/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * Point Cloud Library (PCL) - www.pointclouds.org
 * Copyright (c) 2026, pcl_shape contributors
 *
 * All rights reserved
 */

#include "surface_graph.h"

#include "../kernels/finite.h"
#include "../kernels/parallel.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>

namespace pcl::segmentation {
namespace {

using detail::InstanceInput;
using Eigen::Vector3f;

// In spacings d; doc/instances.md has the reason of each number.
constexpr float reach = 1.5f;
constexpr float bond_reach = 1.0f;
constexpr float same_direction = 0.94f; // cosine of 20 degrees
constexpr float core_share = 0.5f;

/** A forest whose trees are sets of points; the root is the smallest index. */
class DisjointSets {
public:
  explicit DisjointSets(std::size_t size) : parent_(size)
  {
    std::iota(parent_.begin(), parent_.end(), 0U);
  }

  std::uint32_t
  find(std::uint32_t i)
  {
    while (parent_[i] != i)
      i = parent_[i] = parent_[parent_[i]];
    return i;
  }

  void
  unite(std::uint32_t i, std::uint32_t j)
  {
    i = find(i);
    j = find(j);
    parent_[std::max(i, j)] = std::min(i, j);
  }

private:
  std::vector<std::uint32_t> parent_;
};

class Bonds {
public:
  Bonds(const InstanceInput& input,
        const PointGrid& grid,
        const std::vector<char>& members)
  : input_(input)
  , grid_(grid)
  , members_(members)
  , limit_(offsetLimit(input))
  {}

  bool
  bonded(std::size_t i, std::size_t j) const
  {
    const Vector3f n = normalOf(input_, i), m = normalOf(input_, j);
    if (!(std::abs(n.dot(m)) > same_direction))
      return false;
    const Vector3f between =
        positionOf(input_.points, j) - positionOf(input_.points, i);
    const float limit = limit_ * std::min(input_.spacings[i], input_.spacings[j]);
    return std::abs(n.dot(between)) < limit && std::abs(m.dot(between)) < limit;
  }

  /** Members that are bonded to at least half of the points around them. */
  std::vector<char>
  cores() const
  {
    std::vector<char> result(members_.size(), 0);
    kernels::parallelForRanges(
        members_.size(), input_.threads, [&](std::size_t begin, std::size_t end) {
          for (std::size_t i = begin; i < end; ++i)
            result[i] = members_[i] && isCore(i) ? 1 : 0;
        });
    return result;
  }

  /** visit(j, squared distance) for the bonded members among some points. */
  template <typename Visit>
  void
  forEachBond(std::size_t i, const std::vector<char>& among, const Visit& visit) const
  {
    grid_.forEachWithin(positionOf(input_.points, i),
                        bond_reach * input_.spacings[i],
                        [&](std::uint32_t j, float squared) {
                          if (j != i && among[j] && bonded(i, j))
                            visit(j, squared);
                        });
  }

private:
  bool
  isCore(std::size_t i) const
  {
    int all = 0, bonds = 0;
    grid_.forEachWithin(positionOf(input_.points, i),
                        reach * input_.spacings[i],
                        [&](std::uint32_t j, float) {
                          if (j == i)
                            return;
                          ++all;
                          bonds += members_[j] && bonded(i, j) ? 1 : 0;
                        });
    return bonds > 0 &&
           static_cast<float>(bonds) >= core_share * static_cast<float>(all);
  }

  const InstanceInput& input_;
  const PointGrid& grid_;
  const std::vector<char>& members_;
  float limit_;
};

using Pair = std::pair<std::uint32_t, std::uint32_t>;

std::vector<std::vector<Pair>>
bondsBetween(const Bonds& bonds, const std::vector<char>& cores, unsigned threads)
{
  constexpr std::size_t part = 8192;
  std::vector<std::vector<Pair>> pairs((cores.size() + part - 1) / part);
  kernels::parallelFor(pairs.size(), threads, [&](std::size_t p) {
    const std::size_t end = std::min(cores.size(), (p + 1) * part);
    for (std::size_t i = p * part; i < end; ++i)
      if (cores[i])
        bonds.forEachBond(i, cores, [&](std::uint32_t j, float) {
          pairs[p].emplace_back(static_cast<std::uint32_t>(i), j);
        });
  });
  return pairs;
}

/** Members that are no cores take the piece of the nearest core that they are bonded
 * to. */
void
attachMembers(const Bonds& bonds,
              const std::vector<char>& members,
              const std::vector<char>& cores,
              unsigned threads,
              Labels& pieces)
{
  kernels::parallelForRanges(
      members.size(), threads, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
          if (!members[i] || cores[i])
            continue;
          float nearest = std::numeric_limits<float>::infinity();
          bonds.forEachBond(i, cores, [&](std::uint32_t j, float squared) {
            if (squared < nearest) {
              nearest = squared;
              pieces[i] = pieces[j];
            }
          });
        }
      });
}

} // namespace

float
medianSpacing(const InstanceInput& input)
{
  std::vector<float> sorted;
  for (const float spacing : input.spacings)
    if (std::isfinite(spacing))
      sorted.push_back(spacing);
  if (sorted.empty())
    return 1.0f;
  const auto middle = sorted.begin() + static_cast<std::ptrdiff_t>(sorted.size() / 2);
  std::nth_element(sorted.begin(), middle, sorted.end());
  return *middle;
}

float
offsetLimit(const InstanceInput& input)
{
  return 0.3f + 2.5f * static_cast<float>(input.noise);
}

Labels
smoothPieces(const InstanceInput& input,
             const PointGrid& grid,
             const std::vector<char>& members)
{
  const Bonds bonds(input, grid, members);
  const std::vector<char> cores = bonds.cores();
  DisjointSets sets(members.size());
  for (const auto& pairs : bondsBetween(bonds, cores, input.threads))
    for (const auto& [i, j] : pairs)
      sets.unite(i, j);
  Labels pieces(members.size(), -1);
  for (std::size_t i = 0; i < pieces.size(); ++i)
    if (cores[i])
      pieces[i] = static_cast<std::int32_t>(sets.find(static_cast<std::uint32_t>(i)));
  attachMembers(bonds, members, cores, input.threads, pieces);
  sortLabels(input, 1, pieces);
  return pieces;
}

void
sortLabels(const InstanceInput& input, std::size_t min_points, Labels& labels)
{
  struct Entry {
    std::size_t points = 0;
    std::tuple<float, float, float> first;
    std::size_t label = 0;
  };
  std::vector<Entry> entries;
  for (std::size_t i = 0; i < labels.size(); ++i) {
    if (labels[i] < 0)
      continue;
    const auto label = static_cast<std::size_t>(labels[i]);
    if (entries.size() <= label)
      entries.resize(label + 1);
    const float* p = input.points[i];
    const std::tuple<float, float, float> position(p[0], p[1], p[2]);
    Entry& entry = entries[label];
    entry.first = entry.points++ == 0 ? position : std::min(entry.first, position);
    entry.label = label;
  }
  std::sort(entries.begin(), entries.end(), [](const Entry& a, const Entry& b) {
    return a.points != b.points ? a.points > b.points : a.first < b.first;
  });
  std::vector<std::int32_t> renamed(entries.size(), -1);
  std::int32_t next = 0;
  for (const Entry& entry : entries)
    if (entry.points >= std::max<std::size_t>(1, min_points))
      renamed[entry.label] = next++;
  for (std::int32_t& label : labels)
    if (label >= 0)
      label = renamed[static_cast<std::size_t>(label)];
}

} // namespace pcl::segmentation
