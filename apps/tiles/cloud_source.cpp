// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// The offset of clouds that are larger than memory.

#include "tiles/cloud_source.h"

#include "cli/input.h"
#include "tiles/selection.h"

#include <pcl/features/coordinate_offset.h>

#include <algorithm>
#include <cmath>

namespace pcl::app {
namespace {

using Position = std::array<double, 3>;

template <typename Use>
void
forEachFinite(const CloudSources& sources, const Use& use)
{
  for (const auto& source : sources)
    source->stream().forEachPosition([&](const Position* points, std::size_t count) {
      for (std::size_t i = 0; i < count; ++i)
        if (std::isfinite(points[i][0]) && std::isfinite(points[i][1]) &&
            std::isfinite(points[i][2]))
          use(points[i]);
    });
}

pcl::CoordinateScale
scaleOf(const CloudSources& sources)
{
  struct Wanted {
    std::size_t axis = 0;
    Selection<double> selection;
  };
  std::vector<Wanted> all;
  pcl::coordinateScaleOf(1, 0, [&](std::size_t axis, double share) {
    all.push_back({axis, Selection<double>([share](std::uint64_t count) {
                     return static_cast<std::uint64_t>(share *
                                                       static_cast<double>(count - 1));
                   })});
    return 0.0; // the values are found below: here it only says which it needs
  });
  for (int pass = 0; pass < Selection<double>::passes; ++pass) {
    forEachFinite(sources, [&](const Position& p) {
      for (Wanted& wanted : all)
        wanted.selection.add(p[wanted.axis]);
    });
    for (Wanted& wanted : all)
      wanted.selection.endPass();
  }
  auto next = all.begin();
  return pcl::coordinateScaleOf(
      all.front().selection.count(), 0, [&](std::size_t, double) {
        return (next++)->selection.value();
      });
}

} // namespace

void
setOffset(CloudFile& cloud, const std::array<double, 3>& offset, bool is_given)
{
  cloud.offset = offset;
  if (offset == Position{} || is_given)
    return;
  const auto& v = cloud.viewpoint; // nobody scans from there
  cloud.is_view_known = v[0] != 0.0f || v[1] != 0.0f || v[2] != 0.0f;
}

std::array<float, 3>
viewPointOf(const CloudSources& sources,
            const std::array<double, 3>& offset,
            bool is_given)
{
  std::vector<std::array<float, 3>> views;
  for (const auto& source : sources) {
    CloudFile cloud = source->stream().description();
    setOffset(cloud, offset, is_given);
    views.push_back(viewOriginOf(cloud));
  }
  return *std::min_element(views.begin(), views.end());
}

std::vector<float>
boxOf(const CloudSources& sources, const std::array<double, 3>& offset)
{
  std::vector<float> box;
  forEachFinite(sources, [&](const Position& p) {
    std::array<float, 3> at{};
    for (std::size_t axis = 0; axis < 3; ++axis)
      at[axis] = static_cast<float>(p[axis] - offset[axis]);
    if (!std::all_of(at.begin(), at.end(), [](float a) { return std::isfinite(a); }))
      return;
    if (box.empty())
      for (int corner = 0; corner < 2; ++corner)
        box.insert(box.end(), at.begin(), at.end());
    for (std::size_t axis = 0; axis < 3; ++axis) {
      box[axis] = std::min(box[axis], at[axis]);
      box[3 + axis] = std::max(box[3 + axis], at[axis]);
    }
  });
  return box;
}

std::array<double, 3>
offsetOf(const CloudSources& sources)
{
  const bool exceed_floats =
      std::any_of(sources.begin(), sources.end(), [](const auto& source) {
        return exceedFloats(source->stream().description());
      });
  return exceed_floats ? pcl::coordinateOffset(scaleOf(sources)) : Position{};
}

} // namespace pcl::app
