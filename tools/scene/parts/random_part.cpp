// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Outlines, and features that are milled into level faces or stand on them.

#include "scene/parts/part.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace pcl::scene {
namespace {

/** Lengths are shares of the part's size. */
constexpr double min_feature = 0.025; // radius of the smallest hole: 2.5 mm of 10 cm
constexpr double max_feature = 0.20;
constexpr double min_width = 0.02; // of slots, ribs and letters' bars
constexpr double min_gap = 0.02;   // between features: thin walls and narrow lands
constexpr double max_gap = 0.06;
constexpr double max_rim = 0.4 * min_gap; // of an edge's finish outside its outline
constexpr double min_finish = 0.006;
constexpr unsigned max_depth = 2; // features on features

struct Plan {
  Loop loop;
  Vec3 center;
  double reach = 0.0;    /**< of a circle around it */
  double rounding = 0.0; /**< the smallest radius of its corners, 0 if any is sharp */
  double width = 0.0;    /**< the narrowest */
};

std::vector<Vec3>
turned(std::vector<Vec3> corners, const UnitVector& turn, const Vec3& center)
{
  for (Vec3& p : corners)
    p = center +
        Vec3{turn.cosine * p.x - turn.sine * p.y, turn.sine * p.x + turn.cosine * p.y};
  return corners;
}

Plan
planOf(const std::vector<Vec3>& corners,
       const Vec3& center,
       const UnitVector& turn,
       double rounding,
       double width)
{
  double reach = 0.0;
  for (const Vec3& p : corners)
    reach = std::max(reach, norm(p));
  const std::vector<double> radii(corners.size(), rounding);
  return {Loop::polygon(turned(corners, turn, center), radii),
          center,
          reach,
          rounding,
          width};
}

std::vector<Vec3>
rectangleCorners(double length, double width)
{
  const double a = 0.5 * length, b = 0.5 * width;
  return {{-a, -b}, {a, -b}, {a, b}, {-a, b}};
}

std::vector<Vec3>
regularCorners(unsigned count, double reach)
{
  std::vector<Vec3> corners;
  for (unsigned i = 0; i < count; ++i) {
    const UnitVector at = fromTurns(static_cast<double>(i) / count);
    corners.push_back({reach * at.cosine, reach * at.sine});
  }
  return corners;
}

/** An outline from its right half, upwards, of which so many corners on the left come
 * first. */
std::vector<Vec3>
mirrored(const std::vector<Vec3>& right, std::size_t first)
{
  std::vector<Vec3> corners;
  const auto addLeft = [&](std::size_t end, std::size_t begin) {
    for (std::size_t i = end; i-- > begin;)
      corners.push_back({-right[i].x, right[i].y});
  };
  addLeft(first, 0);
  corners.insert(corners.end(), right.begin(), right.end());
  addLeft(right.size(), first);
  return corners;
}

/** L, T, U, H and plus: rectilinear profiles and letters, `bar` wide. */
std::vector<Vec3>
letterCorners(unsigned which, double length, double width, double bar)
{
  const double a = 0.5 * length, b = 0.5 * width, c = 0.5 * bar;
  switch (which % 5) {
  case 0: // L
    return {
        {-a, -b}, {a, -b}, {a, -b + bar}, {-a + bar, -b + bar}, {-a + bar, b}, {-a, b}};
  case 1: // T
    return mirrored({{c, -b}, {c, b - bar}, {a, b - bar}, {a, b}}, 1);
  case 2: // U
    return mirrored({{a, -b}, {a, b}, {a - bar, b}, {a - bar, -b + bar}}, 1);
  case 3: // H
    return mirrored(
        {{a - bar, -c}, {a - bar, -b}, {a, -b}, {a, b}, {a - bar, b}, {a - bar, c}}, 3);
  default: // plus
    return mirrored({{c, -b}, {c, -c}, {a, -c}, {a, c}, {c, c}, {c, b}}, 1);
  }
}

/** What is done to the edge between a wall and a level face. */
struct Finish {
  double size = 0.0; /**< 0 leaves it sharp */
  bool is_round = false;
};

/** \brief Makes one part, from the outline to the last feature. */
class Mill {
public:
  Mill(double size, Random& random) : size_(size), random_(random) {}

  Part
  run()
  {
    const Plan outline = randomOutline();
    height_ = size_ * randomLog(0.12, 0.5);
    const Finish top = randomFinish(outline, 0.25 * height_, 0.6);
    // Not wider than above: what goes through has been placed inside the upper one.
    const Finish bottom = randomFinish(outline, top.size, 0.4);
    std::vector<SectionPiece> section;
    addFinish(bottom, {bottom.size, 0.0}, -1.0, 1.0, Bend::FromLevel, section);
    section.push_back({{0.0, bottom.size}, {0.0, height_ - top.size}});
    addFinish(top, {0.0, height_ - top.size}, 1.0, 1.0, Bend::FromUpright, section);
    part_.addWall(outline.loop, section);
    mill(outline, top.size, height_, 0);
    part_.addLevel(0.0, false, {outline.loop, bottom.size}, through_);
    return std::move(part_);
  }

private:
  double
  randomLog(double low, double high)
  {
    // Geometric: as many small ones as large ones, by a power series' logarithm
    double value = low;
    for (const double factor : {1.0, 0.5, 0.25, 0.125, 0.0625})
      if (random_.chance(0.5))
        value *= power(high / low, 0.5 * factor);
    return value;
  }

  /** A power of two in the exponent's denominator, by square roots. */
  static double
  power(double base, double exponent)
  {
    for (; exponent < 1.0; exponent *= 2.0)
      base = std::sqrt(base);
    return base;
  }

  UnitVector
  randomTurn()
  {
    return random_.chance(0.6) ? fromTurns(0.25 * random_.below(4))
                               : fromTurns(random_.uniform());
  }

  Plan
  randomOutline()
  {
    const double length = size_, width = size_ * random_.uniform(0.5, 1.0);
    const bool is_round = random_.chance(0.5);
    switch (random_.below(6)) {
    case 0: {
      const double radius = 0.5 * size_ * random_.uniform(0.7, 1.0);
      return {Loop::circle({}, radius), {}, radius, radius, 2.0 * radius};
    }
    case 1: {
      const double reach = 0.5 * size_;
      return planOf(regularCorners(5 + random_.below(2), reach),
                    {},
                    {},
                    is_round ? 0.2 * reach : 0.0,
                    1.6 * reach);
    }
    case 2: {
      const double bar = size_ * random_.uniform(0.24, 0.34);
      const double rounding = is_round ? size_ * random_.uniform(0.03, 0.1) : 0.0;
      return planOf(
          letterCorners(random_.below(5), length, size_, bar), {}, {}, rounding, bar);
    }
    default: {
      const double rounding = is_round ? size_ * random_.uniform(0.04, 0.24) : 0.0;
      return planOf(rectangleCorners(length, width), {}, {}, rounding, width);
    }
    }
  }

  /** \param[in] most meters */
  Finish
  randomFinish(const Plan& plan, double most, double probability)
  {
    const double by_corners = plan.rounding > 0.0 ? 0.8 * plan.rounding : most;
    const double largest = std::min({most, 0.2 * plan.width, by_corners});
    const double smallest = min_finish * size_;
    if (largest < smallest || !random_.chance(probability))
      return {};
    const bool is_round = plan.rounding > 0.0 && random_.chance(0.6);
    return {random_.uniform(smallest, largest), is_round};
  }

  /** Between a level face and a wall. \param[in] across, up which way it goes: 1, -1 */
  static void
  addFinish(const Finish& finish,
            const SectionPoint& begin,
            double across,
            double up,
            Bend bend,
            std::vector<SectionPiece>& section)
  {
    const double size = finish.size;
    if (size > 0.0)
      section.push_back({begin,
                         {begin.depth + across * size, begin.height + up * size},
                         finish.is_round ? bend : Bend::Straight});
  }

  /** The plan of a feature around a center. */
  Plan
  randomPlan(const Vec3& center)
  {
    const double reach = size_ * randomLog(min_feature, max_feature);
    const UnitVector turn = randomTurn();
    const bool is_round = random_.chance(0.6);
    switch (random_.below(7)) {
    case 0:
    case 1:
    case 2:
      return {Loop::circle(center, reach), center, reach, reach, 2.0 * reach};
    case 3: // hexagon
      return planOf(regularCorners(6, reach),
                    center,
                    turn,
                    is_round ? 0.25 * reach : 0.0,
                    1.7 * reach);
    case 4: { // slot or narrow rib
      const double width =
          std::max(reach * random_.uniform(0.25, 0.5), min_width * size_);
      return planOf(rectangleCorners(1.9 * reach, width),
                    center,
                    turn,
                    is_round ? 0.5 * width : 0.0,
                    width);
    }
    case 5: {                                       // letter
      const double least = 4.0 * min_width * size_; // its bars and what is between them
      const double large = std::max(reach, least);
      const double bar = large * random_.uniform(0.25, 0.4);
      return planOf(letterCorners(random_.below(5), 1.3 * large, 1.4 * large, bar),
                    center,
                    turn,
                    0.0,
                    bar);
    }
    default: {
      const double width = reach * random_.uniform(0.8, 1.3);
      return planOf(rectangleCorners(1.5 * reach, width),
                    center,
                    turn,
                    is_round ? width * random_.uniform(0.1, 0.4) : 0.0,
                    width);
    }
    }
  }

  /** A plan somewhere on a level face, clear of its outline and of what is there. */
  std::optional<Plan>
  place(const Plan& face, double depth, const std::vector<Plan>& there)
  {
    const double gap = size_ * random_.uniform(min_gap, max_gap);
    const auto coordinate = [&] { return face.reach * random_.uniform(-1.0, 1.0); };
    const double x = coordinate();
    const Plan plan = randomPlan(face.center + Vec3{x, coordinate()});
    const bool is_inside = face.loop.contains(plan.center, depth) &&
                           face.loop.distance(plan.center, depth) > plan.reach + gap;
    const bool is_clear =
        std::none_of(there.begin(), there.end(), [&](const Plan& other) {
          return norm(other.center - plan.center) < other.reach + plan.reach + gap;
        });
    return is_inside && is_clear ? std::make_optional(plan) : std::nullopt;
  }

  /** A pocket that leaves a thin wall around a face. */
  bool
  mayShell(const Plan& face, unsigned level)
  {
    return level == 0 && random_.chance(0.25) && face.width > 0.3 * size_ &&
           height_ > 0.15 * size_;
  }

  /** Put features on a level face, and the face around them. */
  void
  mill(const Plan& face, double depth, double height, unsigned level)
  {
    std::vector<Outline> holes;
    if (mayShell(face, level)) {
      const double wall = size_ * random_.uniform(0.02, 0.06);
      if (face.rounding == 0.0 || face.rounding > depth + wall + 0.01 * size_) {
        shell(face, depth + wall, height, level);
        holes.push_back({face.loop, depth + wall});
        part_.addLevel(height, true, {face.loop, depth}, holes);
        return;
      }
    }
    std::vector<Plan> plans;
    const unsigned wanted = level == 0 ? 3 + random_.below(8) : random_.below(4);
    constexpr unsigned attempts = 25; // for each: what does not fit stays away
    for (unsigned i = 0; i < attempts * wanted && plans.size() < wanted; ++i)
      if (const auto plan = place(face, depth, plans)) {
        plans.push_back(*plan);
        holes.push_back(addFeature(*plan, height, level));
      }
    part_.addLevel(height, true, {face.loop, depth}, holes);
  }

  void
  shell(const Plan& face, double depth, double height, unsigned level)
  {
    const double floor = height * random_.uniform(0.2, 0.6);
    part_.addWall(face.loop, {{{depth, height}, {depth, floor}}});
    mill(face, depth, floor, level + 1);
  }

  /** A hole through everything below, a pocket or a boss. */
  Outline
  addFeature(const Plan& plan, double height, unsigned level)
  {
    const double kind = random_.uniform();
    if (kind < 0.3)
      return throughHole(plan, height);
    return kind < 0.65 ? pocket(plan, height, level) : boss(plan, height, level);
  }

  Finish
  randomRim(const Plan& plan, double room)
  {
    return randomFinish(plan, std::min(0.3 * room, max_rim * size_), 0.35);
  }

  Outline
  throughHole(const Plan& plan, double height)
  {
    const Finish rim = randomRim(plan, height);
    std::vector<SectionPiece> section;
    addFinish(rim, {-rim.size, height}, 1.0, -1.0, Bend::FromLevel, section);
    section.push_back({{0.0, height - rim.size}, {0.0, 0.0}});
    part_.addWall(plan.loop, section);
    through_.push_back({plan.loop, 0.0});
    return {plan.loop, -rim.size};
  }

  Outline
  pocket(const Plan& plan, double height, unsigned level)
  {
    const double floor = height * random_.uniform(0.3, 0.85);
    const Finish rim = randomRim(plan, height - floor);
    const Finish foot = randomFinish(plan, 0.4 * (height - floor), 0.4);
    std::vector<SectionPiece> section;
    addFinish(rim, {-rim.size, height}, 1.0, -1.0, Bend::FromLevel, section);
    section.push_back({{0.0, height - rim.size}, {0.0, floor + foot.size}});
    if (foot.size > 0.0)
      section.push_back({{0.0, floor + foot.size},
                         {foot.size, floor},
                         foot.is_round ? Bend::FromUpright : Bend::Straight});
    part_.addWall(plan.loop, section);
    fill(plan, foot.size, floor, level);
    return {plan.loop, -rim.size};
  }

  Outline
  boss(const Plan& plan, double height, unsigned level)
  {
    const double up = std::min(size_ * random_.uniform(0.02, 0.25), 3.0 * plan.width);
    const Finish foot = randomRim(plan, up);
    const Finish edge = randomFinish(plan, 0.4 * up, 0.4);
    std::vector<SectionPiece> section;
    addFinish(foot, {-foot.size, height}, 1.0, 1.0, Bend::FromLevel, section);
    section.push_back({{0.0, height + foot.size}, {0.0, height + up - edge.size}});
    addFinish(
        edge, {0.0, height + up - edge.size}, 1.0, 1.0, Bend::FromUpright, section);
    part_.addWall(plan.loop, section);
    fill(plan, edge.size, height + up, level);
    return {plan.loop, -foot.size};
  }

  void
  fill(const Plan& plan, double depth, double height, unsigned level)
  {
    if (level < max_depth)
      mill(plan, depth, height, level + 1);
    else
      part_.addLevel(height, true, {plan.loop, depth}, {});
  }

  double size_;
  Random& random_;
  double height_ = 0.0;
  Part part_;
  std::vector<Outline> through_; /**< of the lowest face */
};

} // namespace

Part
randomPart(double size, Random& random)
{
  return Mill(size, random).run();
}

} // namespace pcl::scene
