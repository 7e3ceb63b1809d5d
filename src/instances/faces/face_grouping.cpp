// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Faces grouped to bodies.

#include "instances/faces/face_grouping.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace pcl::segmentation {
namespace {

// Of the width of a group: faces of one body share a side, bodies that touch may not.
constexpr float min_side = 1.0f;
// Narrow groups need less: the arc of a handle is cut across, where it is as wide as it
// is thick.
constexpr float min_narrow_side = 0.5f;

/** How large a group of faces is, in spacings. */
struct GroupSize {
  float width;     ///< the root of its area
  float thickness; ///< of a strip; of other shapes the width

  static GroupSize
  of(const Face& face)
  {
    return {face.width(), face.thickness()};
  }

  GroupSize
  with(const GroupSize& other) const
  {
    return {std::hypot(width, other.width), std::hypot(thickness, other.thickness)};
  }

  bool
  isNarrow() const
  {
    return thickness < narrow;
  }

  /** The least border with another group of the same body. */
  float
  minSide() const
  {
    return isNarrow() ? min_narrow_side * thickness : min_side * width;
  }
};

/** Groups of faces, at first of one each, that are joined step by step. */
class FaceGroups {
public:
  FaceGroups(const std::vector<Face>& faces,
             const std::vector<char>& left_out,
             const std::vector<FaceContact>& contacts)
  : is_on_support_(faces.size(), 0)
  {
    for (std::size_t i = 0; i < faces.size(); ++i) {
      group_.push_back(left_out[i] ? -1 : static_cast<std::int32_t>(i));
      sizes_.push_back(GroupSize::of(faces[i]));
    }
    for (const FaceContact& contact : contacts) {
      const auto first = static_cast<std::size_t>(contact.first);
      const auto second = static_cast<std::size_t>(contact.second);
      if (!left_out[first] && !left_out[second])
        borders_[{contact.first, contact.second}].add(
            {contact.convex, contact.concave, contact.sloping});
      is_on_support_[first] = is_on_support_[first] || left_out[second];
      is_on_support_[second] = is_on_support_[second] || left_out[first];
    }
  }

  Labels
  joined()
  {
    joinBy([](const Pair&, const Border& border) {
      return border.convex - border.concave;
    });
    // What stands on nothing is held: at the root of a handle the surface is concave,
    // but nothing stands on a slope.
    joinBy([this](const Pair& pair, const Border& border) {
      return mayHold(pair.first, pair.second) || mayHold(pair.second, pair.first)
                 ? border.convex + border.sloping
                 : 0.0f;
    });
    return group_;
  }

private:
  using Pair = std::pair<std::int32_t, std::int32_t>; ///< the smaller one first

  struct Border {
    float convex = 0.0f, concave = 0.0f, sloping = 0.0f;

    void
    add(const Border& other)
    {
      convex += other.convex;
      concave += other.concave;
      sloping += other.sloping;
    }
  };

  GroupSize&
  sizeOf(std::int32_t group)
  {
    return sizes_[static_cast<std::size_t>(group)];
  }

  /** A group may be held by a body if it is too narrow for one, and on no support. */
  bool
  mayHold(std::int32_t body, std::int32_t held)
  {
    return !sizeOf(body).isNarrow() && sizeOf(held).isNarrow() &&
           !is_on_support_[static_cast<std::size_t>(held)];
  }

  /** The pair that wants it most first, as long as any does.
   * \param[in] lengthOf how long the border is that speaks for it */
  template <typename LengthOf>
  void
  joinBy(const LengthOf& lengthOf)
  {
    for (;;) {
      auto best = borders_.end();
      float longest = 0.0f;
      for (auto at = borders_.begin(); at != borders_.end(); ++at) {
        const auto& [pair, border] = *at;
        const float length = lengthOf(pair, border);
        const bool is_neck = length < std::min(sizeOf(pair.first).minSide(),
                                               sizeOf(pair.second).minSide());
        if (!is_neck && length > longest) {
          longest = length;
          best = at;
        }
      }
      if (best == borders_.end())
        return;
      join(best);
    }
  }

  void
  join(std::map<Pair, Border>::iterator best)
  {
    const auto [kept, gone] = best->first;
    borders_.erase(best);
    for (auto at = borders_.begin(); at != borders_.end();) {
      const auto [pair, border] = *at;
      if (pair.first != gone && pair.second != gone) {
        ++at;
        continue;
      }
      at = borders_.erase(at);
      const std::int32_t other = pair.first == gone ? pair.second : pair.first;
      borders_[{std::min(kept, other), std::max(kept, other)}].add(border);
    }
    sizeOf(kept) = sizeOf(kept).with(sizeOf(gone));
    char& is_on_support = is_on_support_[static_cast<std::size_t>(kept)];
    is_on_support = is_on_support || is_on_support_[static_cast<std::size_t>(gone)];
    std::replace(group_.begin(), group_.end(), gone, kept);
  }

  Labels group_;
  std::vector<GroupSize> sizes_;
  std::vector<char> is_on_support_; ///< of each group
  std::map<Pair, Border> borders_;
};

} // namespace

Labels
groupFaces(const std::vector<Face>& faces,
           const std::vector<char>& left_out,
           const std::vector<FaceContact>& contacts)
{
  return FaceGroups(faces, left_out, contacts).joined();
}

} // namespace pcl::segmentation
