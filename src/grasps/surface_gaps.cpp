// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Holes, slots and gaps between points that no even or random sampling leaves by
// chance.

#include "grasps/surface_gaps.h"

#include "common/disjoint_sets.h"
#include "geometry/distance_map.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <map>

namespace pcl::segmentation {
namespace {

using Eigen::Vector2f;

constexpr float pi = 3.14159265f;
// Lengths in mean distances s between points: each stands for an area of s^2.
constexpr float cell_size = 0.25f;
// The 12th neighbor of a point is 2 s away, in a square grid as at random.
constexpr float per_spacing = 0.5f;
// Gaps of 3 s: circles of 1.5 s, but for half a diagonal of a cell by which the middle
// of the circle, and another one by which a point, may be off.
constexpr float min_gap = 1.5f - 1.414f * cell_size;
// What is far from all points. Of a square grid nothing is (0.71), of points at random
// exp(-2.0), 13 %.
constexpr float far_off = 0.8f;
// Around the disc: what reaches into it, and the points beside that.
constexpr float centers_beyond = 1.5f, points_beyond = 6.0f;
// Also around it, how even the points are: a small disc is too few of them.
constexpr float evenness_beyond = 3.0f;
constexpr float min_evenness = 0.5f; // clusters: they would leak everywhere or nowhere
// Of the length of a slot, as it counts: a bent one has many more ways to be there.
constexpr float length_share = 0.6f;
// Of all places with a cup, one in a thousand may have a gap by chance.
constexpr float max_chance = 0.001f;

/** An image of the distances to the points, in cells. */
struct Image {
  float cell;
  int half;
  std::vector<float> distances;

  int
  side() const
  {
    return 2 * half + 1;
  }

  /** \brief From the middle of a cell to the nearest point, meters. */
  float
  distance(std::size_t at) const
  {
    return distances[at] * cell;
  }

  /** \brief visit(position, column, row) for the cells of a disc. */
  template <typename Visit>
  void
  forEachWithin(float radius, const Visit& visit) const
  {
    const auto isInside = [&](int off, int row) {
      return center(half + off, row).squaredNorm() <= radius * radius;
    };
    int last = -1; // on either side of the middle; much as in the row before
    for (int row = 0; row < side(); ++row) {
      while (last < half && isInside(last + 1, row))
        ++last;
      while (last >= 0 && !isInside(last, row))
        --last;
      const auto first = static_cast<std::size_t>(row * side() + half - last);
      for (int k = 0; k <= 2 * last; ++k)
        visit(first + static_cast<std::size_t>(k), half - last + k, row);
    }
  }

  Vector2f
  center(int column, int row) const
  {
    return {static_cast<float>(column - half) * cell,
            static_cast<float>(row - half) * cell};
  }
};

Image
imageOf(const std::vector<Vector2f>& points, float reach, float cell)
{
  Image image{cell, static_cast<int>(std::ceil(reach / cell)), {}};
  const auto side = static_cast<std::size_t>(image.side());
  std::vector<char> marks(side * side, 0);
  for (const Vector2f& p : points) {
    const float column = std::round(p.x() / cell), row = std::round(p.y() / cell);
    const auto half = static_cast<float>(image.half);
    if (std::abs(column) <= half && std::abs(row) <= half)
      marks[static_cast<std::size_t>(row + half) * side +
            static_cast<std::size_t>(column + half)] = 1;
  }
  image.distances = distancesTo(marks, image.side());
  return image;
}

float
distanceToNearest(const std::vector<Vector2f>& points, const Vector2f& place)
{
  float squared = std::numeric_limits<float>::infinity();
  for (const Vector2f& p : points)
    squared = std::min(squared, (p - place).squaredNorm());
  return std::sqrt(squared);
}

/** The largest circle without points around a place, uphill to where it is largest. */
Gap
largestCircle(const std::vector<Vector2f>& points,
              Vector2f center,
              float s,
              float reach)
{
  std::vector<Vector2f> near;
  for (const Vector2f& p : points)
    if ((p - center).norm() < reach + 2.0f * s)
      near.push_back(p);
  Gap gap{center, distanceToNearest(near, center)};
  const Vector2f start = center;
  constexpr float first_step = 0.25f, last_step = 0.01f;
  for (float step = first_step * s; step > last_step * s;) {
    Gap best = gap;
    for (int dy = -1; dy <= 1; ++dy)
      for (int dx = -1; dx <= 1; ++dx) {
        const Vector2f place = gap.center + step * Vector2f(static_cast<float>(dx),
                                                            static_cast<float>(dy));
        const float radius = distanceToNearest(near, place);
        if (radius > best.radius && (place - start).norm() < s)
          best = {place, radius};
      }
    if (best.radius > gap.radius)
      gap = best;
    else
      step *= 0.5f;
  }
  return gap;
}

/** Cells far from all points that are connected. */
struct Hollow {
  int min_column, max_column, min_row, max_row;
  int column, row; ///< of the cell that is farthest from all points
  float depth;     ///< its distance, meters

  void
  add(int at_column, int at_row, float distance)
  {
    min_column = std::min(min_column, at_column);
    max_column = std::max(max_column, at_column);
    min_row = std::min(min_row, at_row);
    max_row = std::max(max_row, at_row);
    if (distance > depth) {
      depth = distance;
      column = at_column;
      row = at_row;
    }
  }

  /** The area without points around it: of its largest circle, or of a slot of the
   * smallest width that is as long, whichever is more. */
  float
  area(float cell, float narrow, float radius) const
  {
    const float length = cell * std::hypot(static_cast<float>(max_column - min_column),
                                           static_cast<float>(max_row - min_row));
    return std::max(pi * radius * radius,
                    pi * narrow * narrow + 2.0f * length_share * narrow * length);
  }
};

/** Joins the marked cells that touch each other. */
DisjointSets
connected(const std::vector<char>& marks, int side)
{
  const auto below = static_cast<std::size_t>(side);
  DisjointSets sets(marks.size());
  for (std::size_t at = below + 1; at + below + 1 < marks.size(); ++at) {
    if (!marks[at])
      continue;
    for (const std::size_t other : {at - 1, at - below - 1, at - below, at - below + 1})
      if (marks[other])
        sets.unite(static_cast<std::uint32_t>(at), static_cast<std::uint32_t>(other));
  }
  return sets;
}

/** The mean distance between the points of a disc, where there are points; 0 if they
 * are too few to tell. */
float
meanDistance(const Image& image,
             const std::vector<Vector2f>& points,
             float radius,
             float spacing)
{
  constexpr std::size_t min_points = 12;
  const auto count = static_cast<std::size_t>(
      std::count_if(points.begin(), points.end(), [&](const Vector2f& p) {
        return p.squaredNorm() <= radius * radius;
      }));
  std::size_t inside = 0;
  image.forEachWithin(radius, [&](std::size_t at, int, int) {
    inside += image.distance(at) <= spacing ? 1 : 0;
  });
  if (count < min_points)
    return 0.0f;
  return image.cell * std::sqrt(static_cast<float>(inside) / static_cast<float>(count));
}

/** How fast large empty circles get rare with their area in s^2, by the share of places
 * that are far off all points: 1 at random, more the more even they are. Gaps wider
 * than the spacing do not count. */
float
evenness(const Image& image, float radius, float s, float spacing)
{
  std::vector<char> is_far(image.distances.size(), 0);
  image.forEachWithin(radius, [&](std::size_t at, int, int) {
    is_far[at] = image.distance(at) > far_off * s;
  });
  DisjointSets sets = connected(is_far, image.side());
  std::vector<char> is_wide(is_far.size(), 0);
  for (std::size_t at = 0; at < is_far.size(); ++at)
    if (is_far[at] && image.distance(at) > spacing)
      is_wide[sets.find(static_cast<std::uint32_t>(at))] = 1;
  float inside = 1.0f, far = 0.5f; // the half: there may just be too few places
  image.forEachWithin(radius, [&](std::size_t at, int, int) {
    if (is_far[at] && is_wide[sets.find(static_cast<std::uint32_t>(at))])
      return;
    inside += 1.0f;
    far += static_cast<float>(is_far[at]);
  });
  return std::max(min_evenness, -std::log(far / inside) / (pi * far_off * far_off));
}

/** The smallest area without points that is none by chance. */
float
minArea(const Image& image, float radius, float s, float spacing)
{
  // Of n points at random the circles that touch three and hold none are 2 n; the
  // chance that one is larger than a s^2 is (1 + a) exp(-a), with 1 + a of some 20.
  const float count = pi * radius * radius / (s * s);
  const float area = std::log(2.0f * count * 20.0f / max_chance);
  const float min_radius = min_gap * s;
  return std::max(pi * min_radius * min_radius,
                  s * s * area /
                      evenness(image, radius + evenness_beyond * s, s, spacing));
}

/** What tells gaps from the places between points: lengths and an area. */
struct GapRules {
  float s; ///< the mean distance between points
  float spacing;
  float min_radius;
  float min_area;
};

/** The cells of a disc that are far from all points, by the sets of those that touch.
 */
class FarCells {
public:
  FarCells(const Image& image, float reach, float min_distance)
  : image_(image)
  , reach_(reach)
  , marks_(marksOf(image, reach, min_distance))
  , sets_(connected(marks_, image.side()))
  {}

  bool
  empty() const
  {
    return std::find(marks_.begin(), marks_.end(), 1) == marks_.end();
  }

  /** visit(set, distance to the nearest point, column, row) */
  template <typename Visit>
  void
  forEach(const Visit& visit)
  {
    image_.forEachWithin(reach_, [&](std::size_t at, int column, int row) {
      if (marks_[at])
        visit(sets_.find(static_cast<std::uint32_t>(at)),
              image_.distance(at),
              column,
              row);
    });
  }

private:
  static std::vector<char>
  marksOf(const Image& image, float reach, float min_distance)
  {
    std::vector<char> marks(image.distances.size(), 0);
    image.forEachWithin(reach, [&](std::size_t at, int, int) {
      marks[at] = image.distance(at) >= min_distance;
    });
    return marks;
  }

  const Image& image_;
  float reach_;
  std::vector<char> marks_;
  DisjointSets sets_;
};

std::map<std::uint32_t, Hollow>
hollowsOf(FarCells& cells)
{
  std::map<std::uint32_t, Hollow> hollows;
  cells.forEach([&](std::uint32_t set, float distance, int column, int row) {
    hollows.try_emplace(set, Hollow{column, column, row, row, column, row, 0.0f})
        .first->second.add(column, row, distance);
  });
  return hollows;
}

/** Whether a hollow is a gap. Where only its exact circle tells, that is added. */
bool
isGap(const Hollow& hollow,
      const Image& image,
      const std::vector<Vector2f>& points,
      const GapRules& rules,
      std::vector<Gap>& exact_gaps)
{
  const auto isLarge = [&](float radius) {
    return hollow.area(image.cell, rules.min_radius, radius) >= rules.min_area;
  };
  if (isLarge(hollow.depth) && hollow.depth > rules.spacing)
    return true;
  const float off = 1.414f * image.cell; // the image tells the depth to a diagonal
  if (!isLarge(hollow.depth + off))
    return false;
  const Vector2f middle = image.center(hollow.column, hollow.row);
  const Gap exact = largestCircle(points, middle, rules.s, hollow.depth + off);
  if (!isLarge(exact.radius))
    return false;
  exact_gaps.push_back(exact);
  return true;
}

} // namespace

std::vector<Gap>
gapsWithin(float radius, const std::vector<Vector2f>& points, float spacing)
{
  const float expected = per_spacing * spacing;
  const Image image =
      imageOf(points, radius + points_beyond * expected, cell_size * expected);
  const float s = meanDistance(image, points, radius, spacing);
  if (s == 0.0f)
    return {};
  const float min_radius = min_gap * s;
  FarCells cells(image, radius + centers_beyond * s, min_radius);
  if (cells.empty())
    return {};
  const GapRules rules{s, spacing, min_radius, minArea(image, radius, s, spacing)};
  std::vector<Gap> gaps;
  std::map<std::uint32_t, float> ball; // of each hollow that is a gap: what rolls in it
  for (const auto& [set, hollow] : hollowsOf(cells))
    if (isGap(hollow, image, points, rules, gaps))
      ball[set] = std::min(hollow.depth, spacing);
  cells.forEach([&](std::uint32_t set, float distance, int column, int row) {
    const auto found = ball.find(set);
    if (found != ball.end() && distance >= found->second)
      gaps.push_back({image.center(column, row), distance});
  });
  return gaps;
}

} // namespace pcl::segmentation
