// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Which flat parts carry things.

#include "instances/supports/support_choice.h"

#include "instances/supports/support_surroundings.h"

#include <algorithm>
#include <iterator>
#include <limits>
#include <optional>

namespace pcl::segmentation {
namespace {

using Eigen::Vector3f;
using Nodes = std::vector<SurfaceNode>;

// Of the largest part: supports are large. A table that stands high above a floor may
// be smaller, beside what is seen of the floor.
constexpr double min_share = 0.25, min_share_of_high = 0.1;
// Of what is around. Six tables of a Kinect and one of a RealSense have .75 to .99 on
// top and .01 to .25 behind, noise and rims: few things in the middle are enough, and a
// table with more behind it must have a thin rim.
constexpr double min_on_top = 0.2, max_behind = 0.2;
// Of its own area: rims of tables had .04 to .1, the sides of boxes .2 to .6.
constexpr double max_sides = 0.25;
// Likewise, without its rim. Tables and bottoms of bins have .03 at most, boxes in a
// heap .13 to .6.
constexpr double max_lower = 0.1;
// Likewise, of what stands high. A leg of a table has .01, the short side of a box that
// is four times as long as wide has .06; below a book there is the table that it lies
// on.
constexpr double max_lower_of_high = 0.04;
// Likewise: tables, bottoms and walls have .01 at most, tops of many things .1 to .3.
constexpr double max_through = 0.05;
// Likewise, of what is near it: a cup on a table of 50 x 50 cm has .0075.
constexpr double min_things = 0.005;
// Of a part's area, what is behind it by chance.
constexpr double max_stray_behind = 0.005;
constexpr double max_below = 0.02;   // of all that is not on the lowest part: noise
constexpr float same_level = 0.94f;  // cosine of 20 degrees
constexpr double min_in_plane = 0.8; // of a part's nodes, as of a face's points
constexpr double max_beyond = 0.02;  // of what ends at a wall: noise
// Of its width: where a thing stands in a corner a wall is not seen.
constexpr float min_along = 0.5f;

/** Walls around it, as those of a shelf, are before it and not on top: they say nothing
 * where things are. Below min_things there may be none, and walls count. */
bool
hasThingsOnTop(const SupportPart& part, const Surroundings& around)
{
  const double others =
      around.on_top >= min_things * part.area ? around.on_top : around.before;
  return around.on_top >= min_on_top * (others + around.behind);
}

bool
hasNothingBehind(const Surroundings& around)
{
  return around.behind <= max_behind * (around.before + around.behind);
}

bool
hasRim(const SupportPart& part, const Surroundings& around)
{
  return around.sides <= max_sides * part.area;
}

/** Nothing is lower beside it, as there is beside the top of a body. */
bool
isNoTop(const SupportPart& part, const Surroundings& around)
{
  return around.lower <= max_lower * part.area;
}

/** Nobody sees through it, as through a plane that the tops of many things are on. */
bool
isOpaque(const SupportPart& part, const Surroundings& around)
{
  return around.through <= max_through * part.area;
}

/** Whether things lie before it and nothing behind, or things stand on it and it has a
 * rim. */
bool
carries(const SupportPart& part, const PartSize& largest, const Surroundings& around)
{
  if (!isNoTop(part, around) || !isOpaque(part, around))
    return false;
  if (hasThingsOnTop(part, around))
    return hasNothingBehind(around) || hasRim(part, around);
  return hasNothingBehind(around) && part.area >= min_share * largest.area;
}

/** Whether things stand on it, and nothing is seen that it may lie on. */
bool
standsHigh(const SupportPart& part, const Surroundings& around)
{
  return around.on_top >= min_things * part.area && hasThingsOnTop(part, around) &&
         hasRim(part, around) && isOpaque(part, around) &&
         around.lower <= max_lower_of_high * part.area;
}

/** Whether a part is parallel to another one and behind it. */
bool
isBelow(const SupportPart& part, const SupportPart& other_part)
{
  const Plane<float>& plane = part.support.plane;
  const Plane<float>& other = other_part.support.plane;
  const Vector3f above = other.center - plane.center;
  return plane.normal.dot(other.normal) > same_level &&
         other.normal.dot(above) > 0.0f && plane.normal.dot(above) > 0.0f;
}

/** Whether a part is in the plane of another one, behind a gap: as a floor is that one
 * sees on several sides of a table or a bin. */
bool
isInPlaneOf(const SupportPart& part, const SupportPart& other)
{
  const Plane<float>& plane = other.support.plane;
  if (!(part.support.plane.normal.dot(plane.normal) > same_level))
    return false;
  const Nodes places = placesOf(part.nodes), others = placesOf(other.nodes);
  const auto in_plane =
      std::count_if(places.begin(), places.end(), [&](const SurfaceNode& node) {
        float gap = std::numeric_limits<float>::infinity();
        for (const SurfaceNode& near : others)
          gap = std::min(gap, (near.position - node.position).norm());
        return std::abs(heightOf(node, plane)) <
               bandOf(other) + max_plane_tilt * gap / node.spacing;
      });
  return static_cast<double>(in_plane) >
         min_in_plane * static_cast<double>(places.size());
}

/** From the first to the last of some nodes in a direction. */
float
extentAlong(const Vector3f& direction, const Nodes& nodes)
{
  float first = 0.0f, last = 0.0f;
  for (const SurfaceNode& node : nodes) {
    const float at = direction.dot(node.position - nodes.front().position);
    first = std::min(first, at);
    last = std::max(last, at);
  }
  return last - first;
}

/** What is around each part, looked at once. */
class Scene {
public:
  Scene(const std::vector<SupportPart>& parts,
        const Nodes& nodes,
        float unit,
        unsigned threads)
  : parts_(parts)
  , nodes_(nodes)
  , unit_(unit)
  , threads_(threads)
  , largest_(largestOf(parts))
  , around_(parts.size())
  , levels_(parts.size())
  {}

  bool
  isCarrier(std::size_t part)
  {
    if (!isLarge(parts_[part], largest_, min_share))
      return false;
    return isAlone(part) ? surroundsOthers(part)
                         : carries(parts_[part], largest_, around(part));
  }

  bool
  isHighCarrier(std::size_t part)
  {
    return isLarge(parts_[part], largest_, min_share_of_high) &&
           standsHigh(parts_[part], around(part));
  }

  /** Whether things lie before it and nothing behind. Around the lid of a box seen from
   * above there is nothing at all: of such parts only a floor has nothing below. */
  bool
  isFoot(std::size_t part)
  {
    return isAlone(part) ? isLowest(part) : goesOnBehind(part);
  }

  /** Likewise, or nothing is near it. */
  bool
  goesOnBehind(std::size_t part)
  {
    return (isAlone(part) || hasNothingBehind(around(part))) &&
           isNoTop(parts_[part], around(part));
  }

  /** Whether nothing is behind it but a rim. */
  bool
  isWall(std::size_t part)
  {
    return !isAlone(part) &&
           (hasNothingBehind(around(part)) || hasRim(parts_[part], around(part)));
  }

private:
  const Surroundings&
  around(std::size_t part)
  {
    if (!around_[part])
      around_[part] = surroundingsOf(parts_[part], nodes_, unit_, threads_);
    return *around_[part];
  }

  const Levels&
  levels(std::size_t part)
  {
    if (!levels_[part])
      levels_[part] = levelsOf(parts_[part], nodes_, unit_, threads_);
    return *levels_[part];
  }

  /** Nothing is near, but for noise: shadows may hide where things stand. */
  bool
  isAlone(std::size_t part)
  {
    return !(around(part).before > 0.0) &&
           around(part).behind <= max_stray_behind * parts_[part].area;
  }

  bool
  isLowest(std::size_t part)
  {
    return levels(part).below <= max_below * around(part).others;
  }

  /** Whether it is larger than all else, or the lowest of all with things above it. */
  bool
  surroundsOthers(std::size_t part)
  {
    const double others = around(part).others;
    return parts_[part].area > others ||
           (isLowest(part) && levels(part).above >= min_on_top * others);
  }

  const std::vector<SupportPart>& parts_;
  const Nodes& nodes_;
  float unit_;
  unsigned threads_;
  PartSize largest_;
  std::vector<std::optional<Surroundings>> around_;
  std::vector<std::optional<Levels>> levels_;
};

} // namespace

bool
isWallOf(const SupportPart& part, const SupportPart& bottom, float unit)
{
  const Vector3f& normal = part.support.plane.normal;
  const Vector3f& up = bottom.support.plane.normal;
  if (!isSteep(normal, bottom))
    return false;
  const auto behind =
      std::count_if(bottom.nodes.begin(), bottom.nodes.end(), [&](const auto& node) {
        return heightOf(node, part.support.plane) < -bandOf(part);
      });
  if (static_cast<double>(behind) >
      max_beyond * static_cast<double>(bottom.nodes.size()))
    return false;
  const PointGrid grid(positionsOf(bottom.nodes), around_spacings * unit);
  Nodes foot;
  std::copy_if(part.nodes.begin(),
               part.nodes.end(),
               std::back_inserter(foot),
               [&](const auto& node) {
                 return isNear(node.position, grid, around_spacings * node.spacing);
               });
  const Vector3f along = normal.cross(up).normalized();
  return extentAlong(along, foot) >= min_along * extentAlong(along, bottom.nodes);
}

std::vector<std::size_t>
carriersAmong(const std::vector<SupportPart>& parts,
              const Nodes& nodes,
              float unit,
              unsigned threads)
{
  Scene scene(parts, nodes, unit, threads);
  std::vector<std::size_t> carriers;
  const auto isAbove = [](const auto& part, const auto& other) {
    return isBelow(other, part);
  };
  for (std::size_t k = 0; k < parts.size(); ++k)
    if (scene.isCarrier(k))
      carriers.push_back(k);
  const auto addOthers = [&](const auto& isRelated, const auto& isCarrier) {
    const std::vector<std::size_t> known = carriers;
    const auto isRelatedToKnown = [&](std::size_t part) {
      return std::any_of(known.begin(), known.end(), [&](std::size_t carrier) {
        return isRelated(parts[part], parts[carrier]);
      });
    };
    for (std::size_t k = 0; k < parts.size(); ++k)
      if (std::find(known.begin(), known.end(), k) == known.end() &&
          isRelatedToKnown(k) && isCarrier(k))
        carriers.push_back(k);
  };
  addOthers(isAbove, [&](std::size_t k) { return scene.isHighCarrier(k); });
  addOthers(isBelow, [&](std::size_t k) { return scene.isFoot(k); });
  addOthers(isInPlaneOf, [&](std::size_t k) { return scene.goesOnBehind(k); });
  const auto isWallOfKnown = [unit](const auto& part, const auto& bottom) {
    return isWallOf(part, bottom, unit);
  };
  addOthers(isWallOfKnown, [&](std::size_t k) { return scene.isWall(k); });
  return carriers;
}

} // namespace pcl::segmentation
