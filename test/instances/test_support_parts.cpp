// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Flat parts that may be supports, in clutter and behind gaps.

#include "instances/supports/support_choice.h"
#include "instances/supports/support_parts.h"
#include "instances/supports/support_planes.h"
#include "small_surfaces.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <vector>

namespace {

using namespace pcl::segmentation;
using Eigen::Vector3f;
using Nodes = std::vector<SurfaceNode>;

/** \brief A patch of so many nodes to a side; the spacing is 1. */
void
addPatch(const Vector3f& corner,
         int columns,
         int rows,
         Nodes& nodes,
         const Vector3f& right = Vector3f::UnitX(),
         const Vector3f& up = Vector3f::UnitY())
{
  for (int row = 0; row < rows; ++row)
    for (int column = 0; column < columns; ++column) {
      const Vector3f offset =
          static_cast<float>(column) * right + static_cast<float>(row) * up;
      nodes.push_back({corner + node_spacings * offset,
                       right.cross(up),
                       1.0f,
                       0.0f,
                       static_cast<std::uint32_t>(nodes.size())});
    }
}

/** \brief Whether one of the parts is all of the nodes at a height. */
bool
hasPartAt(float height, std::size_t size, const std::vector<SupportPart>& parts)
{
  return std::any_of(parts.begin(), parts.end(), [&](const SupportPart& part) {
    return part.nodes.size() == size &&
           std::abs(part.support.plane.center.z() - height) < 0.1f;
  });
}

constexpr float min_offset = 0.5f;
constexpr float level = 30.0f; // between the planes

TEST(SupportParts, AreFoundBehindPlanesOfClutter)
{
  Nodes nodes;
  addPatch({0, 0, 0}, 110, 100, nodes);
  // More nodes on one plane than the board below has; none of its parts is large.
  for (int k = 0; k < 30; ++k)
    addPatch(
        {40.0f * static_cast<float>(k % 6), 40.0f * static_cast<float>(k / 6), level},
        12,
        12,
        nodes);
  addPatch({0, 0, 2 * level}, 40, 30, nodes);
  const std::vector<SupportPart> parts = supportParts(nodes, min_offset, 1.0f);
  EXPECT_EQ(2u, parts.size());
  EXPECT_TRUE(hasPartAt(0.0f, 11000, parts));
  EXPECT_TRUE(hasPartAt(2 * level, 1200, parts));
}

TEST(SupportParts, GoOnBehindAGapOfAQuarterOfTheirWidth)
{
  for (const float gap : {6.0f, 30.0f}) {
    Nodes nodes;
    addPatch({0, 0, 0}, 40, 40, nodes);
    addPatch({60.0f + gap, 0, 0}, 20, 40, nodes);
    const std::vector<SupportPart> parts = supportParts(nodes, min_offset, 1.0f);
    ASSERT_FALSE(parts.empty());
    const bool is_narrow = gap < 15.0f;
    const bool goes_on = parts.front().nodes.size() > 1600u;
    EXPECT_EQ(is_narrow, goes_on) << gap;
  }
}

/** \brief The walls around a patch of 100 by 80 nodes, but for the nearest one. */
void
addWalls(int rows, Nodes& nodes)
{
  const Vector3f x = Vector3f::UnitX(), y = Vector3f::UnitY(), z = Vector3f::UnitZ();
  addPatch({0, 0, 3}, 80, rows, nodes, y, z);
  addPatch({149, 119, 3}, 80, rows, nodes, -y, z);
  addPatch({0, 119, 3}, 100, rows, nodes, x, z);
}

TEST(SupportParts, APlaneHasItsNormalsAndDoesNotCutThroughWalls)
{
  Nodes nodes;
  addPatch({0, 0, 0}, 100, 80, nodes);
  addWalls(7, nodes); // of each, three rows are less than two spacings from one height
  const std::vector<SupportPart> parts = supportParts(nodes, min_offset, 1.0f);
  std::multiset<std::size_t> sizes;
  for (const SupportPart& part : parts)
    sizes.insert(part.nodes.size());
  EXPECT_EQ((std::multiset<std::size_t>{560, 560, 700, 8000}), sizes);
}

TEST(SupportParts, LargestAreaAndMostPointsMayBeOfTwoParts)
{
  SupportPart near, far;
  near.area = 1.0;
  near.points = 1000.0;
  far.area = 10.0;
  far.points = 100.0;
  const PartSize largest = largestOf({near, far});
  EXPECT_EQ(10.0, largest.area);
  EXPECT_EQ(1000.0, largest.points);
  EXPECT_TRUE(isLarge(near, largest, 0.25));
  EXPECT_TRUE(isLarge(far, largest, 0.25));
  near.points = 200.0;
  EXPECT_FALSE(isLarge(near, largest, 0.25));
}

/** \brief How many supports there are at a height. */
std::size_t
supportsAt(float height, const Nodes& nodes)
{
  const std::vector<SupportPart> parts = supportParts(nodes, min_offset, 1.0f);
  std::size_t count = 0;
  for (const std::size_t k : carriersAmong(parts, nodes, 1.0f, 1))
    if (std::abs(parts[k].support.plane.center.z() - height) < 0.1f)
      ++count;
  return count;
}

/** \brief A floor and above it a level patch, a seventh as large, with something on it.
 */
Nodes
patchAbove(float height)
{
  Nodes nodes;
  addPatch({0, 0, 0}, 110, 100, nodes);
  addPatch({50, 50, height}, 40, 40, nodes);
  addPatch({75, 75, height + 4.0f}, 7, 7, nodes);
  return nodes;
}

TEST(SupportChoice, ASmallTableStandsHighAndABookDoesNot)
{
  EXPECT_EQ(1u, supportsAt(60.0f, patchAbove(60.0f)));
  EXPECT_EQ(0u, supportsAt(5.0f, patchAbove(5.0f)));
  EXPECT_EQ(1u, supportsAt(0.0f, patchAbove(60.0f)));
}

TEST(SupportChoice, ASmallBoxHasSides)
{
  Nodes nodes = patchAbove(60.0f);
  addPatch({50, 50, 2.0f}, 40, 36, nodes, Vector3f::UnitX(), Vector3f::UnitZ());
  EXPECT_EQ(0u, supportsAt(60.0f, nodes));
}

TEST(SupportChoice, NobodySeesThroughASupport)
{
  constexpr float tops = 60.0f, gaps = 50.0f;
  const auto clutterOn = [&](int columns, bool is_seen_through) {
    Nodes nodes;
    addPatch({0, 0, 0}, columns, 80, nodes);
    for (int k = 0; k < 16; ++k) {
      const float y = 20.0f + 5.5f * static_cast<float>(k);
      addPatch({40, y, tops}, 40, 2, nodes);
      if (is_seen_through && k < 15)
        addPatch({46, y + 3.0f, gaps}, 32, 1, nodes);
    }
    addPatch({60, 50, tops + 4.0f}, 7, 7, nodes);
    return nodes;
  };
  for (const int columns : {100, 40}) { // then the tops are large
    EXPECT_EQ(1u, supportsAt(tops, clutterOn(columns, false))) << columns;
    EXPECT_EQ(0u, supportsAt(tops, clutterOn(columns, true))) << columns;
  }
}

/** \brief A floor, and two tables above each other with things on them; each is
 * parallel to the next one only. */
Nodes
leaningTables()
{
  Nodes nodes;
  addPatch({0, 0, 0}, 110, 100, nodes);
  for (const float turn : {0.25f, 0.5f}) {
    const Vector3f x(std::cos(turn), 0.0f, std::sin(turn));
    const Vector3f z(-std::sin(turn), 0.0f, std::cos(turn));
    const Vector3f corner(50.0f, 50.0f, 240.0f * turn);
    addPatch(corner, 40, 40, nodes, x);
    addPatch(corner + 25.0f * (x + Vector3f::UnitY()) + 4.0f * z, 7, 7, nodes, x);
  }
  return nodes;
}

TEST(SupportChoice, HighTablesDoNotDependOnTheOrderOfParts)
{
  const Nodes nodes = leaningTables();
  std::vector<SupportPart> parts = supportParts(nodes, min_offset, 1.0f);
  std::sort(parts.begin(), parts.end(), [](const auto& one, const auto& other) {
    return one.support.plane.center.z() < other.support.plane.center.z();
  });
  const std::vector<std::size_t> upwards = carriersAmong(parts, nodes, 1.0f, 1);
  std::reverse(parts.begin(), parts.end());
  std::set<std::size_t> downwards;
  for (const std::size_t k : carriersAmong(parts, nodes, 1.0f, 1))
    downwards.insert(parts.size() - 1 - k);
  EXPECT_EQ(std::set<std::size_t>(upwards.begin(), upwards.end()), downwards);
  EXPECT_EQ(2u, upwards.size());
}

TEST(SupportChoice, WallsAroundABoardAreNoThingsOnIt)
{
  Nodes nodes;
  addPatch({0, 0, 0}, 60, 40, nodes);
  addPatch({42, 27, 4}, 7, 7, nodes);
  const Vector3f x = Vector3f::UnitX(), y = Vector3f::UnitY(), z = Vector3f::UnitZ();
  addPatch({0, 60, 3}, 60, 40, nodes, x, z); // its back, and sides
  addPatch({0, 0, 3}, 40, 40, nodes, y, z);
  addPatch({90, 0, 3}, 40, 40, nodes, y, z);
  addPatch({0, 0, -6}, 60, 3, nodes, x, z); // its rim
  EXPECT_EQ(1u, supportsAt(0.0f, nodes));
}

TEST(SupportChoice, TheTopOfABodyHasSomethingLowerBeside)
{
  Nodes nodes;
  addPatch({0, 0, 0}, 41, 40, nodes);
  addPatch({25, 25, 4}, 7, 7, nodes);
  EXPECT_EQ(1u, supportsAt(0.0f, nodes));
  addPatch({67, 0, -4}, 10, 40, nodes); // nobody sees its side
  EXPECT_EQ(0u, supportsAt(0.0f, nodes));
}

/** \brief A level frame: nothing is seen of what its hole has. */
void
addFrame(float height, Nodes& nodes)
{
  addPatch({0, 0, height}, 100, 15, nodes);
  addPatch({0, 127.5f, height}, 100, 15, nodes);
  addPatch({0, 22.5f, height}, 15, 70, nodes);
  addPatch({127.5f, 22.5f, height}, 15, 70, nodes);
}

/** \brief More than a frame has, in the middle, and a level lid of one of the things.
 */
void
addHeap(Nodes& nodes)
{
  addPatch({60, 55, 20}, 25, 25, nodes);
  for (const float y : {40.0f, 50.0f, 100.0f, 110.0f})
    addPatch(
        {50, y, 20}, 40, 40, nodes, Vector3f::UnitX(), Vector3f(0.0f, -0.8f, 0.6f));
}

TEST(SupportChoice, ShadowsMayHideWhereThingsStand)
{
  Nodes nodes;
  addFrame(0.0f, nodes);
  addHeap(nodes);
  EXPECT_EQ(1u, supportsAt(0.0f, nodes));
  EXPECT_EQ(0u, supportsAt(20.0f, nodes));
  addPatch({0, 400, -40}, 10, 50, nodes); // and then it is not the lowest
  EXPECT_EQ(0u, supportsAt(0.0f, nodes));
}

TEST(SupportChoice, OfPartsAloneOnlyTheLowestIsAFoot)
{
  Nodes nodes;
  addPatch({0, 0, 60}, 60, 60, nodes);
  addPatch({0, 0, 62}, 60, 60, nodes, Vector3f::UnitY(), Vector3f::UnitZ()); // a wall
  addPatch({200, 0, 20}, 20, 20, nodes);
  EXPECT_EQ(1u, supportsAt(60.0f, nodes));
  EXPECT_EQ(1u, supportsAt(20.0f, nodes));
  addPatch({-100, 0, 0}, 20, 20, nodes); // then the other one is a lid
  EXPECT_EQ(0u, supportsAt(20.0f, nodes));
  EXPECT_EQ(1u, supportsAt(0.0f, nodes));
}

/** \brief A table with a wall, and something around it. */
Nodes
tableAt(float height)
{
  Nodes nodes;
  addPatch({0, 0, height}, 60, 60, nodes);
  addPatch({0, 0, height + 2}, 60, 60, nodes, Vector3f::UnitY(), Vector3f::UnitZ());
  return nodes;
}

/** \brief A narrow strip along y that rises along x, with its middle at z = 0. */
void
addStrip(float x, float slope, Nodes& nodes)
{
  const Vector3f right = Vector3f(1.0f, 0.0f, slope).normalized();
  addPatch(Vector3f(x, 0, 0) - 6.75f * right, 10, 60, nodes, right);
}

TEST(SupportChoice, NarrowPartsOfAFloorAreTilted)
{
  // Each is far below the plane of the other, and their middles are of one height.
  Nodes nodes = tableAt(60.0f);
  addStrip(-100.0f, 0.025f, nodes);
  addStrip(200.0f, -0.025f, nodes);
  EXPECT_EQ(2u, supportsAt(0.0f, nodes));
}

TEST(SupportChoice, AFloorGoesOnBehindABin)
{
  Nodes nodes = tableAt(60.0f);
  addPatch({200, 0, 0}, 60, 60, nodes);
  addStrip(-100.0f, 0.08f, nodes); // the floor is below its plane
  EXPECT_EQ(2u, supportsAt(0.0f, nodes));
  addPatch({-130, 0, 20}, 10, 60, nodes); // the lid of a thing
  EXPECT_EQ(0u, supportsAt(20.0f, nodes));
}

TEST(SupportChoice, NoiseIsNothingNear)
{
  Nodes nodes = tableAt(60.0f);
  addPatch({200, 0, 0}, 60, 60, nodes);
  addPatch({196, 40, -3}, 1, 4, nodes);
  EXPECT_EQ(1u, supportsAt(0.0f, nodes));
  addPatch({196, 0, -3}, 1, 60, nodes);
  EXPECT_EQ(0u, supportsAt(0.0f, nodes));
}

TEST(SupportChoice, AFootHasNothingLowerBeside)
{
  Nodes nodes;
  addPatch({0, 0, 60}, 80, 80, nodes);
  addPatch({0, 0, 62}, 80, 80, nodes, Vector3f::UnitY(), Vector3f::UnitZ());
  addPatch({200, 0, 0}, 31, 40, nodes);
  addPatch({215, 15, 4}, 4, 4, nodes);
  EXPECT_EQ(1u, supportsAt(0.0f, nodes));
  addPatch({252, 0, -4}, 8, 40, nodes);
  EXPECT_EQ(0u, supportsAt(0.0f, nodes));
}

/** \brief The bottom of a bin with a thing on it. */
Nodes
bottomOfABin()
{
  Nodes nodes;
  addPatch({0, 0, 0}, 100, 80, nodes);
  addPatch({70, 60, 5}, 12, 12, nodes);
  return nodes;
}

/** \brief How many supports face along x. */
std::size_t
wallsAmong(const Nodes& nodes)
{
  const std::vector<SupportPart> parts = supportParts(nodes, min_offset, 1.0f);
  std::size_t walls = 0;
  for (const std::size_t k : carriersAmong(parts, nodes, 1.0f, 1))
    walls += parts[k].support.plane.normal.x() > 0.5f ? 1 : 0;
  return walls;
}

TEST(SupportChoice, AWallStandsWhereTheBottomOfABinEnds)
{
  const Vector3f y = Vector3f::UnitY(), z = Vector3f::UnitZ();
  const auto wallsOf = [&](int columns, const Vector3f& corner, const Vector3f& up) {
    Nodes nodes = bottomOfABin();
    addPatch(corner, columns, 12, nodes, y, up);
    return wallsAmong(nodes);
  };
  EXPECT_EQ(1u, wallsOf(60, {0, 10, 3}, z));
  EXPECT_EQ(1u, wallsOf(60, {0, 10, 2}, Vector3f(-0.6f, 0.0f, 0.8f))); // it leans
  EXPECT_EQ(0u, wallsOf(60, {0, 10, 2}, Vector3f(-0.8f, 0.0f, 0.6f))); // too far
  EXPECT_EQ(0u, wallsOf(60, {30, 10, 3}, z));  // the bottom goes on behind it
  EXPECT_EQ(0u, wallsOf(20, {0, 10, 3}, z));   // the side of a thing in a corner
  EXPECT_EQ(0u, wallsOf(60, {-20, 10, 3}, z)); // apart from the bottom
  EXPECT_EQ(0u, wallsOf(60, {0, 10, 20}, z));
}

TEST(SupportChoice, BeforeAWallIsAllOfTheBottom)
{
  const Vector3f y = Vector3f::UnitY(), z = Vector3f::UnitZ();
  for (const float shadow : {30.0f, 0.0f}) { // where the bottom begins behind a screen
    Nodes nodes = bottomOfABin();
    addPatch({0, 10, 3}, 60, 12, nodes, y, z);
    if (shadow > 0.0f)
      addPatch({-shadow, 0, 0}, 8, 80, nodes);
    EXPECT_EQ(shadow > 0.0f ? 0u : 1u, wallsAmong(nodes));
  }
}

TEST(SupportChoice, AWallTouchesTheBottom)
{
  Nodes nodes = bottomOfABin();
  addPatch({-40, 10, 3}, 60, 12, nodes, Vector3f::UnitY(), Vector3f::UnitZ());
  addPatch({-37, 40, 10}, 4, 12, nodes); // a thing before it
  EXPECT_EQ(0u, wallsAmong(nodes));
}

TEST(SupportChoice, BehindAWallIsOnlyItsRim)
{
  Nodes nodes = bottomOfABin();
  addPatch({0, 10, 3}, 60, 12, nodes, Vector3f::UnitY(), Vector3f::UnitZ());
  EXPECT_EQ(1u, wallsAmong(nodes));
  addPatch({-4, 10, 20}, 2, 60, nodes);
  EXPECT_EQ(1u, wallsAmong(nodes));
  addPatch({-16, 10, 20}, 10, 60, nodes); // the lid of a thing
  EXPECT_EQ(0u, wallsAmong(nodes));
}

TEST(SupportChoice, OfABinDoesNotDependOnTheOrderOfPartsOrThreads)
{
  Nodes nodes = bottomOfABin();
  addPatch({0, 10, 3}, 60, 12, nodes, Vector3f::UnitY(), Vector3f::UnitZ());
  addPatch({300, 0, -90}, 60, 60, nodes); // a floor, and nothing around it
  addHeap(nodes);
  std::vector<SupportPart> parts = supportParts(nodes, min_offset, 1.0f);
  const std::vector<std::size_t> carriers = carriersAmong(parts, nodes, 1.0f, 1);
  EXPECT_EQ(3u, carriers.size());
  EXPECT_EQ(carriers, carriersAmong(parts, nodes, 1.0f, 3));
  std::reverse(parts.begin(), parts.end());
  std::set<std::size_t> reversed;
  for (const std::size_t k : carriersAmong(parts, nodes, 1.0f, 1))
    reversed.insert(parts.size() - 1 - k);
  EXPECT_EQ(std::set<std::size_t>(carriers.begin(), carriers.end()), reversed);
}

/** \brief A level floor, 100 wide, with a bump of a cosine's shape in the middle. */
pcl::test::Surface
floorWithBump(double height, double radius = 5.0)
{
  constexpr int points = 200;
  constexpr double middle = 0.5 * pcl::test::half * points;
  pcl::test::Surface floor;
  for (int row = 0; row < points; ++row)
    for (int column = 0; column < points; ++column) {
      const Eigen::Vector2d from(pcl::test::half * column - middle,
                                 pcl::test::half * row - middle);
      const double phase = M_PI * std::min(1.0, from.norm() / radius);
      const double z = 0.5 * height * (1.0 + std::cos(phase));
      const double slope = 0.5 * height * M_PI / radius * std::sin(phase);
      const Eigen::Vector2d out =
          from.norm() > 0.0 ? from.normalized() : Eigen::Vector2d(1.0, 0.0);
      floor.add({Eigen::Vector3d(from.x(), from.y(), z),
                 Eigen::Vector3d(slope * out.x(), slope * out.y(), 1.0).normalized()});
    }
  return floor;
}

std::vector<Support>
supportsOf(const pcl::test::Surface& surface)
{
  const pcl::detail::InstanceInput input = pcl::test::inputOf(surface);
  return supportPlanes(
      input, PointGrid(input.points, 1.5f), std::vector<char>(surface.size(), 1));
}

TEST(SupportPlanes, KnowWhatIsSmearedWhereThingsTouchThem)
{
  const auto floor = floorWithBump(0.9);
  const std::vector<Support> supports = supportsOf(floor);
  ASSERT_EQ(1u, supports.size());
  const Support& support = supports.front();
  // All but the very top, which is farther from the floor than a camera's window is.
  std::set<std::uint32_t> known(support.points.begin(), support.points.end());
  known.insert(support.smeared.begin(), support.smeared.end());
  EXPECT_EQ(known.size(), support.points.size() + support.smeared.size());
  for (std::uint32_t i = 0; i < floor.size(); ++i)
    if (known.count(i) == 0) {
      EXPECT_LT(floor.position(i).head<2>().norm(), 1.0);
    }
  ASSERT_FALSE(support.smeared.empty());
  const auto heightOf = [&](std::uint32_t i) {
    return support.plane.distance(floor.position(i).cast<float>());
  };
  for (const std::uint32_t i : support.smeared) {
    EXPECT_GE(heightOf(i), support.offset) << "higher than what is on the plane";
    EXPECT_LT(heightOf(i), max_ripple);
  }
  for (const std::uint32_t i : support.points)
    EXPECT_LT(heightOf(i), support.offset);
}

/** \brief A bin whose nearest wall shows its rim only, and a thing in it as high as the
 * walls, of which one sees the lid and the front. */
struct Bin {
  enum Part : std::size_t { rim, too_high, far_away, lid, others };

  explicit Bin(bool has_right_wall = true)
  {
    using Eigen::Vector3d;
    const Vector3d x = Vector3d::UnitX(), y = Vector3d::UnitY(), z = Vector3d::UnitZ();
    add(pcl::test::floorPatch(0, -3, 13, 81, 4));
    add(pcl::test::floorPatch(0, -3, 21, 81, 4));
    add(pcl::test::floorPatch(0, -20, 13, 81, 4));
    add(pcl::test::floorPatch(15, 12, 13, 20, 20));
    add(pcl::test::patch({15, 12, 3}, x, z, 20, 20));
    add(pcl::test::floorPatch(0, 0, 0, 121, 101));
    add(pcl::test::patch({0, 0, 2}, y, z, 101, 21));
    if (has_right_wall)
      add(pcl::test::patch({60, 50, 2}, -y, z, 101, 21));
  }

  void
  add(const pcl::test::Surface& part)
  {
    surface.append(part);
    ends.push_back(surface.size());
  }

  std::vector<std::uint32_t>
  pointsOf(Part part) const
  {
    std::vector<std::uint32_t> points;
    for (std::size_t i = part == rim ? 0 : ends[part - 1]; i < ends[part]; ++i)
      points.push_back(static_cast<std::uint32_t>(i));
    return points;
  }

  pcl::test::Surface surface;
  std::vector<std::size_t> ends;
};

std::vector<std::uint32_t>
rimPointsOf(const std::vector<Support>& supports)
{
  std::vector<std::uint32_t> points;
  for (const Support& support : supports)
    points.insert(points.end(), support.rim.begin(), support.rim.end());
  return points;
}

TEST(SupportPlanes, WallsOfOneHeightHaveARim)
{
  const Bin bin;
  EXPECT_EQ(bin.pointsOf(Bin::rim), rimPointsOf(supportsOf(bin.surface)));
  EXPECT_TRUE(rimPointsOf(supportsOf(Bin(false).surface)).empty()) << "one wall";
}

TEST(SupportPlanes, ARimIsOfNoObject)
{
  Bin bin;
  bin.add(pcl::test::floorPatch(60.5, 20, 13, 22, 22)); // behind a wall, but no strip
  pcl::detail::InstanceInput input = pcl::test::inputOf(bin.surface);
  input.view_point = {30.0f, -20.0f, 1000.0f};
  pcl::InstanceLimits limits;
  limits.min_points = 100;
  const PointGrid grid(input.points, pcl::detail::gridCell(medianSpacing(input)));
  const Labels labels = pcl::detail::findObjects(input, grid, limits);
  for (const std::uint32_t i : bin.pointsOf(Bin::rim))
    EXPECT_EQ(-1, labels[i]);
  for (const Bin::Part part : {Bin::too_high, Bin::lid})
    for (const std::uint32_t i : bin.pointsOf(part))
      EXPECT_LE(0, labels[i]) << part;
  for (std::size_t i = *(bin.ends.end() - 2); i < bin.surface.size(); ++i)
    EXPECT_LE(0, labels[i]) << "wide";
}

TEST(SupportPlanes, HaveNothingOfWhatIsHighAndSteep)
{
  const auto floor = floorWithBump(3.0);
  const std::vector<Support> supports = supportsOf(floor);
  ASSERT_EQ(1u, supports.size());
  EXPECT_LT(supports[0].points.size() + supports[0].smeared.size(), floor.size() - 100);
}

/** \brief Four walls and a lid, 10 wide, that stand on a bump. */
pcl::test::Surface
boxOnABump()
{
  using Eigen::Vector3d;
  const Vector3d x = Vector3d::UnitX(), y = Vector3d::UnitY(), z = Vector3d::UnitZ();
  pcl::test::Surface box = pcl::test::floorPatch(-5, -5, 10, 21, 21);
  box.append(pcl::test::patch({-5, -5, 1}, x, z, 21, 18));
  box.append(pcl::test::patch({5, 5, 1}, -x, z, 21, 18));
  box.append(pcl::test::patch({5, -5, 1}, y, z, 21, 18));
  box.append(pcl::test::patch({-5, 5, 1}, -y, z, 21, 18));
  return box;
}

TEST(SupportPlanes, WhatIsSmearedIsOfNoObject)
{
  const auto scene = pcl::test::together(floorWithBump(1.2, 8.0), boxOnABump());
  pcl::detail::InstanceInput input = pcl::test::inputOf(scene);
  input.view_point = {0.0f, 0.0f, 1000.0f};
  pcl::InstanceLimits limits;
  limits.min_points = 100;
  const PointGrid grid(input.points, pcl::detail::gridCell(medianSpacing(input)));
  const Labels labels = pcl::detail::findObjects(input, grid, limits);
  const std::size_t of_floor = scene.size() - boxOnABump().size();
  EXPECT_EQ(0, labels[of_floor]) << "the lid";
  const std::vector<Support> supports = supportsOf(scene);
  ASSERT_EQ(1u, supports.size());
  ASSERT_FALSE(supports[0].smeared.empty());
  for (const std::uint32_t i : supports[0].smeared)
    EXPECT_EQ(-1, labels[i]) << scene.position(i).transpose();
}

} // namespace
