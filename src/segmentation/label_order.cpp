/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * Point Cloud Library (PCL) - www.pointclouds.org
 * Copyright (c) 2026, pcl_shape contributors
 *
 * All rights reserved
 */

#include "label_order.h"

#include <algorithm>
#include <tuple>

namespace pcl::segmentation {

using detail::InstanceInput;

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
