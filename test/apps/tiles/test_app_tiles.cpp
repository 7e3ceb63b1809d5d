// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// pcl_shape_tiles gives the bits of the whole cloud, however it is divided.

#include "app_test.h"
#include "io/pcd.h"
#include "tile_clouds.h"
#include "tiles/selection.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <limits>
#include <tuple>
#include <utility>

namespace {

using namespace pcl_shape_test;
using Bits = std::vector<std::uint32_t>;

class Tiles : public AppTest {
protected:
  /** \brief A file in a folder of its own, so that the output has its name. */
  std::string
  input(const std::string& name, const std::string& contents) const
  {
    std::filesystem::create_directories(path("in"));
    writeFile(path("in/" + name), contents);
    return path("in/" + name);
  }

  std::string
  whole(const TilePointCloud& points, const std::string& name = "cloud.pcd") const
  {
    std::vector<std::size_t> order(points.size());
    for (std::size_t i = 0; i < order.size(); ++i)
      order[i] = i;
    return input(name, tileCloudFile(points, order));
  }

  /** \brief The fields that the whole cloud gets. */
  std::string
  detected(const std::string& cloud, const Words& options) const
  {
    Words words{cloud, path("whole.pcd"), "-format", "binary"};
    words.insert(words.end(), options.begin(), options.end());
    expectSuccessOrWarnings(runApp("pcl_shape_detect", words));
    return readFile(path("whole.pcd"));
  }

  Outcome
  tiles(Words words, const Words& options) const
  {
    std::filesystem::remove_all(path("out"));
    return again(std::move(words), options);
  }

  Outcome
  again(Words words, const Words& options) const
  {
    words.insert(words.end(), {"-output_dir", path("out")});
    words.insert(words.end(), options.begin(), options.end());
    return runApp("pcl_shape_tiles", words);
  }

  std::uint64_t
  count(const std::string& name) const
  {
    return nlohmann::json::parse(readFile(path("json")))["counts"][name];
  }

  double
  parameter(const std::string& name) const
  {
    return nlohmann::json::parse(readFile(path("json")))["parameters"][name];
  }
};

/** \brief The bits of a field of four bytes. */
Bits
bitsOf(const pcl::app::CloudFile& cloud, const std::string& name)
{
  const auto* const field = pcl::app::findField(cloud, name);
  if (!field)
    throw std::runtime_error("no field " + name);
  Bits bits(cloud.size());
  for (std::size_t i = 0; i < bits.size(); ++i)
    std::memcpy(&bits[i], cloud.at(i, *field), sizeof bits[i]);
  return bits;
}

/** \brief How many of the clouds' bytes differ. */
std::size_t
differences(const std::string& a, const std::string& b)
{
  if (a.size() != b.size())
    return std::max(a.size(), b.size());
  std::size_t count = 0;
  for (std::size_t i = 0; i < a.size(); ++i)
    count += a[i] == b[i] ? 0 : 1;
  return count;
}

class EqualTiles : public Tiles, public ::testing::WithParamInterface<const char*> {
protected:
  static TilePointCloud
  cloud()
  {
    constexpr std::size_t points = 12000; // a halo holds some thousand
    const std::string name = GetParam();
    return withTrouble(name == "room"     ? roomCloud(points)
                       : name == "street" ? streetCloud(points)
                                          : sheetCloud(points));
  }

  /** \brief Edges of tiles, from many tiles to one. */
  static Words
  edges()
  {
    const std::string name = GetParam();
    return name == "room"     ? Words{"2.6", "5.1"}
           : name == "street" ? Words{"12", "31"}
                              : Words{"6.7", "13"};
  }
};

TEST_P(EqualTiles, GiveTheFileOfTheWholeCloud)
{
  const std::string file = whole(cloud());
  const Words wanted{"-edges", "-types", "-normals"};
  const std::string expected = detected(file, wanted);
  std::size_t most = 0;
  for (const std::string& edge : edges()) {
    Words options = wanted;
    options.insert(options.end(),
                   {"-tile", edge, "-processes", "2", "-json", path("json")});
    expectSuccess(tiles({file}, options));
    EXPECT_EQ(differences(readFile(path("out/cloud.pcd")), expected), 0U)
        << "tiles of " << edge << " m";
    most = std::max(most, static_cast<std::size_t>(count("tiles")));
  }
  EXPECT_GT(most, 10U);
  EXPECT_FALSE(exists(path("out/tiles")));
}

TEST_P(EqualTiles, GiveTheSameInAnyOrder)
{
  const TilePointCloud points = cloud();
  Words wanted{"-edges", "-types"}, names{"edge_likelihood", "edge", "edge_type"};
  if (std::string(GetParam()) == "room") { // surfaces take several times as long
    wanted.insert(wanted.end(), {"-surfaces", "-instances", "planar"});
    names.insert(names.end(), {"likelihood", "surface", "instance"});
  }
  const std::string expected = detected(whole(points), wanted);
  const pcl::app::CloudFile of_whole = pcl::app::decodePcd("whole", expected);
  for (const unsigned seed : {1U, 2U}) {
    const std::vector<std::size_t> order = shuffled(points.size(), seed);
    const auto part = [&](std::size_t begin, std::size_t end) {
      return tileCloudFile(
          points,
          {order.begin() + static_cast<std::ptrdiff_t>(begin * order.size() / 6),
           order.begin() + static_cast<std::ptrdiff_t>(end * order.size() / 6)});
    };
    const Words inputs{input("a.pcd", part(0, 1)),
                       input("b.pcd", part(1, 4)),
                       input("c.pcd", part(4, 6))};
    Words options = wanted;
    options.insert(options.end(), {"-tile", edges()[seed - 1], "-processes", "2"});
    expectSuccess(tiles(inputs, options));
    std::size_t off = 0, found = 0;
    for (const char* const name : {"out/a.pcd", "out/b.pcd", "out/c.pcd"}) {
      const pcl::app::CloudFile output =
          pcl::app::decodePcd(name, readFile(path(name)));
      const Bits ids = bitsOf(output, "id");
      found += ids.size();
      for (const std::string& field : names) {
        const Bits bits = bitsOf(output, field), right = bitsOf(of_whole, field);
        for (std::size_t i = 0; i < ids.size(); ++i)
          off += bits[i] == right[ids[i]] ? 0 : 1;
      }
    }
    EXPECT_EQ(found, points.size());
    EXPECT_EQ(off, 0U) << "order " << seed;
  }
}

TEST_P(EqualTiles, GiveTheFileOfTheWholeCloudAtAResolution)
{
  const std::string file = whole(cloud());
  const std::string name = GetParam();
  const std::string resolution = name == "room" ? "0.12" : "0.25";
  Words wanted{"-edges", "-types", "-resolution", resolution};
  if (name != "street") // without surfaces tiles take another way
    wanted.push_back("-surfaces");
  if (name == "room")
    wanted.insert(wanted.end(), {"-instances", "curved"});
  const std::string expected = detected(file, wanted);
  wanted.insert(wanted.end(), {"-tile", edges().back(), "-processes", "2"});
  expectSuccess(tiles({file}, wanted));
  EXPECT_EQ(differences(readFile(path("out/cloud.pcd")), expected), 0U);
}

TEST_P(EqualTiles, GiveTheInadOfTheWholeCloud)
{
  const std::string file = whole(cloud());
  const Words radius{std::string(GetParam()) == "room" ? "0.15" : "0.6"};
  expectSuccessOrWarnings(
      runApp("pcl_inad_estimation",
             {file, path("whole.pcd"), "-radius", radius[0], "-format", "binary"}));
  for (const std::string& edge : edges()) {
    expectSuccess(tiles({file}, {"-inad", radius[0], "-tile", edge}));
    EXPECT_EQ(differences(readFile(path("out/cloud.pcd")), readFile(path("whole.pcd"))),
              0U)
        << "tiles of " << edge << " m";
  }
}

TEST_F(Tiles, OfInputsInSeveralSectionsAreTheWholeCloud)
{
  constexpr std::size_t points = 280000; // three sections
  const std::string file = whole(withTrouble(sheetCloud(points)));
  const std::string radius = "0.06"; // a dozen neighbors
  expectSuccessOrWarnings(
      runApp("pcl_inad_estimation",
             {file, path("whole.pcd"), "-radius", radius, "-format", "binary"}));
  for (const std::string processes : {"1", "3"}) {
    const Words options{"-inad", radius, "-tile", "9", "-processes", processes};
    expectSuccess(tiles({file}, options));
    EXPECT_EQ(differences(readFile(path("out/cloud.pcd")), readFile(path("whole.pcd"))),
              0U)
        << processes << " processes";
  }
}

TEST_F(Tiles, HaveTheSurfacesAndInstancesOfACloudThatIsLongerThanTheyLook)
{
  constexpr std::size_t points = 120000;
  const std::string file = whole(pathCloud(points));
  const Words wanted{"-surfaces", "-normals", "-instances", "planar"};
  const std::string expected = detected(file, wanted);
  const pcl::app::CloudFile of_whole = pcl::app::decodePcd("whole", expected);
  const Bits surfaces = bitsOf(of_whole, "surface");
  for (const std::uint32_t surface : {1U, 2U})
    EXPECT_GT(std::count(surfaces.begin(), surfaces.end(), surface), 1000);
  Words options = wanted;
  options.insert(options.end(), {"-tile", "13", "-json", path("json")});
  expectSuccess(tiles({file}, options));
  EXPECT_EQ(differences(readFile(path("out/cloud.pcd")), expected), 0U);
  const Bits instances = bitsOf(of_whole, "instance");
  const std::uint32_t most = *std::max_element(instances.begin(), instances.end());
  EXPECT_GT(most, 1U);
  EXPECT_EQ(count("instances"), most);
  EXPECT_GT(count("tiles"), 4U);
}

TEST_F(Tiles, HaveTheFlatWindowsOfTheWholeCloud)
{
  const std::string file = whole(wavyTableCloud());
  const std::string expected = detected(file, {"-surfaces"});
  const Bits surfaces = bitsOf(pcl::app::decodePcd("whole", expected), "surface");
  const auto planar = std::count(surfaces.begin(), surfaces.end(), 1U);
  EXPECT_GT(planar, static_cast<std::ptrdiff_t>(99 * surfaces.size() / 100));
  expectSuccess(tiles({file}, {"-surfaces", "-tile", "0.35", "-json", path("json")}));
  EXPECT_EQ(differences(readFile(path("out/cloud.pcd")), expected), 0U);
  EXPECT_GT(count("tiles"), 7U);
}

TEST_F(Tiles, TakeTheResolutionThatStepsNeed)
{
  const Words wanted{"-edges", "-types", "-json", path("json")};
  for (const auto& [cloud, tile, spacing] :
       {std::tuple(stepsCloud(), "0.8", 0.01),
        std::tuple(widerStepsCloud(), "0.9", 0.006)}) {
    const std::string file = whole(cloud);
    const std::string expected = detected(file, wanted);
    const double resolution = parameter("resolution");
    EXPECT_GT(resolution, 1.5 * spacing);
    Words options = wanted;
    options.insert(options.end(), {"-tile", tile, "-processes", "2"});
    expectSuccessOrWarnings(tiles({file}, options));
    EXPECT_EQ(resolution, parameter("resolution"));
    EXPECT_EQ(differences(readFile(path("out/cloud.pcd")), expected), 0U);
    EXPECT_GT(count("tiles"), 3U);
    const Bits edges = bitsOf(pcl::app::decodePcd("whole", expected), "edge");
    EXPECT_GT(std::count(edges.begin(), edges.end(), 1U), 200);
    options.emplace_back("-normals");
    expectRefused(tiles({file}, options), 1, {"neighbors share noise", "-normals"});
  }
}

TEST_F(Tiles, HaveOneResolutionWhereTheWholeCloudHasSeveral)
{
  const std::string file = whole(nearAndFarCloud());
  const Words wanted{"-edges", "-types", "-json", path("json")};
  detected(file, wanted);
  EXPECT_LT(parameter("finest_resolution"), parameter("resolution"));
  Words options = wanted;
  options.emplace_back("-one_resolution");
  const std::string expected = detected(file, options);
  const double resolution = parameter("resolution");
  options.back() = "-tile";
  options.emplace_back("0.9");
  expectSuccessOrWarnings(tiles({file}, options));
  EXPECT_EQ(resolution, parameter("resolution"));
  EXPECT_EQ(differences(readFile(path("out/cloud.pcd")), expected), 0U);
  EXPECT_GT(count("tiles"), 3U);
}

TEST_F(Tiles, HaveTheEdgesOfThinPlates)
{
  const std::string file = whole(plateCloud());
  const Words wanted{"-edges", "-types", "-normals"};
  const std::string expected = detected(file, wanted);
  const Bits edges = bitsOf(pcl::app::decodePcd("whole", expected), "edge");
  EXPECT_GT(std::count(edges.begin(), edges.end(), 1U), 1000);
  Words options = wanted;
  options.insert(options.end(), {"-tile", "0.11", "-json", path("json")});
  expectSuccess(tiles({file}, options));
  EXPECT_EQ(differences(readFile(path("out/cloud.pcd")), expected), 0U);
  EXPECT_GT(count("tiles"), 4U);
}

template <typename T>
class Selections : public ::testing::Test {};
using SelectedTypes = ::testing::Types<float, double>;
TYPED_TEST_SUITE(Selections, SelectedTypes);

TYPED_TEST(Selections, FindTheValueOfEachRank)
{
  using Selection = pcl::app::Selection<TypeParam>;
  const auto eps = std::numeric_limits<TypeParam>::epsilon();
  const std::vector<TypeParam> values{
      0.5f, 0.0f, 3e-30f, 0.5f, 7.25f, 7.25f * (1 + eps), 1e30f, -0.25f, -1e30f};
  std::vector<TypeParam> sorted = values;
  std::sort(sorted.begin(), sorted.end());
  for (std::size_t rank = 0; rank < values.size(); ++rank) {
    Selection selection([&](std::uint64_t count) {
      EXPECT_EQ(count, values.size());
      return rank;
    });
    EXPECT_THROW(selection.value(), std::logic_error);
    for (int pass = 0; pass < Selection::passes; ++pass) {
      for (const TypeParam value : values)
        selection.add(value);
      EXPECT_EQ(selection.count(), values.size());
      selection.endPass();
    }
    EXPECT_EQ(selection.value(), sorted[rank]) << "rank " << rank;
  }
  Selection of_nothing([](std::uint64_t count) { return count / 2; });
  of_nothing.endPass();
  EXPECT_EQ(of_nothing.count(), 0U);
  EXPECT_THROW(of_nothing.value(), std::logic_error);
}

TEST_F(Tiles, RefuseAResolutionThatDoesNotFit)
{
  constexpr std::size_t points = 2000;
  const std::string file = whole(sheetCloud(points));
  for (const char* const option : {"-normals", "-inad"}) {
    Words options{"-resolution", "0.3", option};
    if (options.back() == "-inad")
      options.push_back("0.5");
    expectRefused(tiles({file}, options), 2, {option, "own points", "-resolution"});
  }
  // Nothing stays that would refuse the next run, which has another resolution.
  expectRefused(tiles({file}, {"-resolution", "30"}),
                1,
                {"resolution is 30 m", "less than the cloud's extent"});
  EXPECT_FALSE(exists(path("out/tiles")));
  expectRefused(again({file}, {"-resolution", "1e-9"}),
                1,
                {"resolution is 1e-09 m", "what a float holds"});
  EXPECT_FALSE(exists(path("out/tiles")));
  expectSuccess(again({file}, {"-resolution", "0.5"}));
  expectRefused(tiles({file}, {"-resolution", "-1"}), 2, {"-resolution '-1'"});
}

INSTANTIATE_TEST_SUITE_P(Clouds,
                         EqualTiles,
                         ::testing::Values("room", "street", "sheet"));

} // namespace
