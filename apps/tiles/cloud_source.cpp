// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// The offset of clouds that are larger than memory.

#include "tiles/cloud_source.h"

#include "cli/input.h"

#include <pcl/features/coordinate_offset.h>

#include <algorithm>
#include <cmath>
#include <cstring>

namespace pcl::app {
namespace {

using Position = std::array<double, 3>;

/** Doubles as whole numbers in the same order. */
std::uint64_t
keyOf(double value)
{
  std::uint64_t bits = 0;
  std::memcpy(&bits, &value, sizeof bits);
  constexpr std::uint64_t sign = std::uint64_t{1} << 63;
  return bits & sign ? ~bits : bits | sign;
}

double
valueOf(std::uint64_t key)
{
  constexpr std::uint64_t sign = std::uint64_t{1} << 63;
  const std::uint64_t bits = key & sign ? key ^ sign : ~key;
  double value = 0.0;
  std::memcpy(&value, &bits, sizeof value);
  return value;
}

/** Finds one of the sorted values of an axis, some bits of it in each pass. */
class Selection {
public:
  static constexpr int bits = 16, passes = 64 / bits;

  Selection(std::size_t axis, std::uint64_t rank) : axis_(axis), rank_(rank) {}

  std::size_t
  axis() const
  {
    return axis_;
  }

  void
  begin()
  {
    counts_.assign(std::size_t{1} << bits, 0);
  }

  void
  count(std::uint64_t key)
  {
    const int shift = 64 - bits * (pass_ + 1);
    if (pass_ == 0 || key >> (shift + bits) == found_)
      ++counts_[key >> shift & ((1U << bits) - 1)];
  }

  void
  end()
  {
    std::uint64_t digit = 0;
    while (rank_ >= counts_[digit])
      rank_ -= counts_[digit++];
    found_ = found_ << bits | digit;
    ++pass_;
  }

  double
  value() const
  {
    return valueOf(found_);
  }

private:
  std::size_t axis_;
  std::uint64_t rank_; ///< among the values that begin with what is found
  std::uint64_t found_ = 0;
  int pass_ = 0;
  std::vector<std::uint64_t> counts_;
};

template <typename Use>
void
forEachFinite(const CloudSources& sources, const Use& use)
{
  for (const auto& source : sources)
    source->read([&](const Position* points, std::size_t count) {
      for (std::size_t i = 0; i < count; ++i)
        if (std::isfinite(points[i][0]) && std::isfinite(points[i][1]) &&
            std::isfinite(points[i][2]))
          use(points[i]);
    });
}

pcl::CoordinateScale
scaleOf(const CloudSources& sources)
{
  std::size_t count = 0;
  forEachFinite(sources, [&](const Position&) { ++count; });
  if (count == 0)
    return {};
  std::vector<Selection> selections;
  pcl::coordinateScaleOf(count, 0, [&](std::size_t axis, double share) {
    selections.emplace_back(
        axis, static_cast<std::uint64_t>(share * static_cast<double>(count - 1)));
    return 0.0; // the values are found below: here it only says which it needs
  });
  for (int pass = 0; pass < Selection::passes; ++pass) {
    for (Selection& selection : selections)
      selection.begin();
    forEachFinite(sources, [&](const Position& p) {
      const std::array<std::uint64_t, 3> keys{keyOf(p[0]), keyOf(p[1]), keyOf(p[2])};
      for (Selection& selection : selections)
        selection.count(keys[selection.axis()]);
    });
    for (Selection& selection : selections)
      selection.end();
  }
  auto next = selections.begin();
  return pcl::coordinateScaleOf(
      count, 0, [&](std::size_t, double) { return (next++)->value(); });
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
  const bool has_doubles =
      std::any_of(sources.begin(), sources.end(), [](const auto& source) {
        return hasDoubles(source->stream().description());
      });
  return has_doubles ? pcl::coordinateOffset(scaleOf(sources)) : Position{};
}

} // namespace pcl::app
