// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Clouds in tiles: halos, results, runs that go on, and what is refused.

#include "memory_source.h"
#include "tiling/manifest.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <limits>
#include <optional>
#include <set>

namespace {

using namespace pcl::tiling;
using namespace pcl_shape_test;
using Bytes = std::vector<std::uint8_t>;

class TiledClouds : public ::testing::Test {
protected:
  TiledClouds() : directory(temporary.path() + "/tiles"), points(unevenPoints(3000, 1))
  {
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    points[7] = {nan, 0.0, 0.0};
    points[8] = points[9];
    divide();
  }

  TiledCloud::Sources
  sources(const std::string& state = "1") const
  {
    const auto middle = points.begin() + 1000;
    return {std::make_shared<MemorySource>(
                "a", std::vector<Position>(points.begin(), middle), state),
            std::make_shared<MemorySource>(
                "b", std::vector<Position>(middle, points.end()))};
  }

  void
  divide(const std::string& state = "1", const TileSettings& settings = {200, 0.0, "x"})
  {
    cloud.reset();
    cloud.emplace(directory, sources(state), settings, *team);
    cloud->partition();
  }

  /** \brief Count the points of each tile, the halo included. \return of which tiles it
   * was done now */
  std::set<std::size_t>
  countPoints(double halo = 1.0)
  {
    std::set<std::size_t> done;
    cloud->run("counts", halo, [&](std::size_t tile, const TilePoints& of_tile) {
      done.insert(tile);
      const auto count = static_cast<std::uint32_t>(of_tile.points.size());
      Bytes bytes(sizeof count);
      std::memcpy(bytes.data(), &count, sizeof count);
      return bytes;
    });
    return done;
  }

  static bool
  isFinite(const Position& p)
  {
    return std::isfinite(p[0]);
  }

  std::string
  refusal(const std::function<void()>& call)
  {
    try {
      call();
    }
    catch (const TilingError& error) {
      return error.what();
    }
    return {};
  }

  TemporaryDirectory temporary;
  const std::string directory;
  std::vector<Position> points;
  std::unique_ptr<Team> team = makeTeam();
  std::optional<TiledCloud> cloud;
};

TEST_F(TiledClouds, HaveEachPointOnceInOrder)
{
  std::vector<std::vector<Position>> expected(cloud->size());
  for (const Position& p : points)
    if (isFinite(p))
      expected[cloud->tileOf(p)].push_back(p);
  EXPECT_GT(cloud->size(), 15U);
  EXPECT_EQ(cloud->countNotFinite(), 1U);
  EXPECT_EQ(cloud->countFinite(), 2999U);
  for (std::size_t tile = 0; tile < cloud->size(); ++tile) {
    EXPECT_EQ(cloud->load(tile, 0.0).points, expected[tile]);
    EXPECT_EQ(cloud->pointsOf(tile), expected[tile].size());
  }
}

TEST_F(TiledClouds, HaveAllPointsAround)
{
  constexpr double halo = 2.5;
  for (std::size_t tile = 0; tile < cloud->size(); ++tile) {
    TilePoints of_tile = cloud->load(tile, halo);
    Position low = of_tile.points[0], high = low;
    for (std::size_t i = 0; i < of_tile.own; ++i)
      for (std::size_t axis = 0; axis < 3; ++axis) {
        low[axis] = std::min(low[axis], of_tile.points[i][axis]);
        high[axis] = std::max(high[axis], of_tile.points[i][axis]);
      }
    const auto around = [&](double distance) {
      std::vector<Position> found;
      for (const Position& p : points)
        if (p[0] >= low[0] - distance && p[0] <= high[0] + distance &&
            p[1] >= low[1] - distance && p[1] <= high[1] + distance &&
            p[2] >= low[2] - distance && p[2] <= high[2] + distance)
          found.push_back(p);
      std::sort(found.begin(), found.end());
      return found;
    };
    constexpr double rounding = 2e-5; // of float, of coordinates up to 50
    const std::vector<Position> least = around(halo), most = around(halo + rounding);
    std::sort(of_tile.points.begin(), of_tile.points.end());
    const auto& loaded = of_tile.points;
    EXPECT_TRUE(
        std::includes(loaded.begin(), loaded.end(), least.begin(), least.end()));
    EXPECT_TRUE(std::includes(most.begin(), most.end(), loaded.begin(), loaded.end()));
  }
}

TEST_F(TiledClouds, HaveTheNeighborsOfFloats)
{
  // As floats, which are half a millimeter apart there, the points are 1 m apart.
  const TiledCloud::Sources two{std::make_shared<MemorySource>(
      "two", std::vector<Position>{{4999.9998, 0.0, 0.0}, {5001.0002, 0.0, 0.0}})};
  TiledCloud of_two(temporary.path() + "/two", two, {1, 0.0, "x"}, *team);
  of_two.partition();
  ASSERT_EQ(of_two.size(), 2U);
  EXPECT_EQ(of_two.load(0, 1.0).points.size(), 2U);
  EXPECT_EQ(of_two.load(0, 0.99).points.size(), 1U);
}

TEST_F(TiledClouds, GoOnWithWhatIsMissing)
{
  EXPECT_EQ(countPoints().size(), cloud->size());
  const Bytes before = cloud->resultOf("counts", 3);
  EXPECT_TRUE(countPoints().empty());
  std::filesystem::remove(cloud->pathOf("counts", 3));
  divide();
  EXPECT_EQ(countPoints(), std::set<std::size_t>{3});
  EXPECT_EQ(cloud->resultOf("counts", 3), before);
}

TEST_F(TiledClouds, RepairTiles)
{
  countPoints();
  const std::vector<Position> before = cloud->load(4, 0.0).points;
  std::filesystem::remove(cloud->pathOf("tiles", 4));
  std::filesystem::resize_file(cloud->pathOf("tiles", 5), 100);
  divide();
  EXPECT_EQ(cloud->load(4, 0.0).points, before);
  EXPECT_GT(cloud->load(5, 0.0).own, 0U);
}

TEST_F(TiledClouds, NoticeResultsThatWereChanged)
{
  countPoints();
  const std::string path = cloud->pathOf("counts", 2);
  const Bytes before = cloud->resultOf("counts", 2);
  std::ofstream(path, std::ios::binary) << "abcd"; // as many bytes
  EXPECT_NE(refusal([&] { cloud->resultOf("counts", 2); }).find("damaged"),
            std::string::npos);
  divide();
  EXPECT_EQ(countPoints(), std::set<std::size_t>{2});
  EXPECT_EQ(cloud->resultOf("counts", 2), before);
}

TEST_F(TiledClouds, GoOnAfterAnError)
{
  const auto fail = [&] {
    cloud->run("some", 0.0, [](std::size_t tile, const TilePoints&) -> Bytes {
      if (tile == 1)
        throw TilingError("no luck");
      return {1, 2};
    });
  };
  const std::string error = refusal(fail);
  EXPECT_NE(error.find("some of tile 1: no luck; 1 of "), std::string::npos) << error;
  divide();
  std::set<std::size_t> done;
  cloud->run("some", 0.0, [&](std::size_t tile, const TilePoints&) {
    done.insert(tile);
    return Bytes{1, 2};
  });
  EXPECT_EQ(done, std::set<std::size_t>{1});
}

TEST_F(TiledClouds, ComputeFromResultsAlone)
{
  countPoints();
  std::size_t done = 0;
  const auto doubled = [&](std::size_t tile) {
    ++done;
    Bytes bytes = cloud->resultOf("counts", tile);
    const Bytes copy = bytes;
    bytes.insert(bytes.end(), copy.begin(), copy.end());
    return bytes;
  };
  cloud->runOnResults("doubled", doubled);
  EXPECT_EQ(done, cloud->size());
  EXPECT_EQ(cloud->resultOf("doubled", 3).size(), 8U);
  divide();
  cloud->runOnResults("doubled", doubled);
  EXPECT_EQ(done, cloud->size()); // not again
}

TEST_F(TiledClouds, ComputeAllTilesAtOnce)
{
  std::size_t runs = 0;
  const auto numbered = [&](const TiledCloud::Write& write) {
    ++runs;
    for (std::size_t tile = 0; tile < cloud->size(); ++tile)
      write(tile, {static_cast<std::uint8_t>(tile)});
  };
  cloud->runAtOnce("numbers", numbered);
  EXPECT_EQ(cloud->resultOf("numbers", 5), Bytes{5});
  divide();
  cloud->runAtOnce("numbers", numbered);
  EXPECT_EQ(runs, 1U);
  std::filesystem::remove(cloud->pathOf("numbers", 2)); // one of them is missing
  cloud->runAtOnce("numbers", numbered);
  EXPECT_EQ(runs, 2U);
  EXPECT_EQ(cloud->resultOf("numbers", 2), Bytes{2});
  cloud.reset();
  team = makeTeam(2); // another process writes
  divide();
  cloud->runAtOnce("others", numbered);
  EXPECT_EQ(cloud->resultOf("others", 7), Bytes{7});
  cloud->remove();
  EXPECT_FALSE(std::filesystem::exists(directory));
}

TEST_F(TiledClouds, SayWhatAllAtOnceLacks)
{
  const auto fails = [](const TiledCloud::Write&) {
    throw std::runtime_error("no paper");
  };
  EXPECT_EQ(refusal([&] { cloud->runAtOnce("numbers", fails); }), "numbers: no paper");
  const auto writes_one = [](const TiledCloud::Write& write) { write(0, {}); };
  EXPECT_EQ(refusal([&] { cloud->runAtOnce("numbers", writes_one); }),
            "numbers of some tiles were not written");
}

TEST_F(TiledClouds, ComputeSections)
{
  // Each section tells which points it has of tiles: they are those of load().
  std::vector<std::vector<Position>> tiles(cloud->size());
  const auto tell = [&](std::size_t section, const TiledCloud::Sink& sink) {
    for (const TiledCloud::Rows& rows : cloud->rowsOf(section)) {
      EXPECT_EQ(tiles[rows.tile].size(), rows.first);
      const std::vector<Position> all = cloud->load(rows.tile, 0.0).points;
      for (std::uint64_t i = rows.first; i < rows.first + rows.count; ++i) {
        tiles[rows.tile].push_back(all[i]);
        sink(&all[i], sizeof all[i]);
      }
    }
  };
  ASSERT_EQ(cloud->sections().size(), 6U);
  EXPECT_EQ(cloud->sections()[4].source, 1U);
  EXPECT_EQ(cloud->sections()[4].number, 1U);
  cloud->runOnSections("told", tell);
  for (std::size_t tile = 0; tile < cloud->size(); ++tile)
    EXPECT_EQ(tiles[tile], cloud->load(tile, 0.0).points);
  std::vector<Position> found;
  for (std::size_t section = 0; section < cloud->sections().size(); ++section) {
    Bytes bytes;
    cloud->copyTo("told", section, [&](const void* data, std::size_t size) {
      const auto* const from = static_cast<const std::uint8_t*>(data);
      bytes.insert(bytes.end(), from, from + size);
    });
    EXPECT_EQ(bytes, cloud->resultOf("told", section));
    found.resize(found.size() + bytes.size() / sizeof(Position));
    std::memcpy(found.data() + found.size() - bytes.size() / sizeof(Position),
                bytes.data(),
                bytes.size());
  }
  std::vector<Position> finite;
  std::copy_if(points.begin(), points.end(), std::back_inserter(finite), isFinite);
  std::sort(finite.begin(), finite.end());
  std::sort(found.begin(), found.end());
  EXPECT_EQ(found, finite);
}

TEST_F(TiledClouds, GoOnWithSectionsThatAreMissing)
{
  std::set<std::size_t> done;
  const auto number = [&](std::size_t section, const TiledCloud::Sink& sink) {
    done.insert(section);
    sink(&section, sizeof section);
  };
  cloud->runOnSections("numbers", number);
  EXPECT_EQ(done.size(), 6U);
  std::filesystem::remove(cloud->pathOf("numbers", 2));
  std::ofstream(cloud->pathOf("numbers", 4)) << "12345678"; // as many bytes
  const auto ignore = [](const void*, std::size_t) {};
  EXPECT_NE(refusal([&] { cloud->copyTo("numbers", 4, ignore); }).find("was damaged"),
            std::string::npos);
  divide();
  done.clear();
  cloud->runOnSections("numbers", number);
  EXPECT_EQ(done, (std::set<std::size_t>{2, 4}));
  cloud->removeResult("numbers");
  EXPECT_FALSE(std::filesystem::exists(directory + "/numbers"));
}

TEST_F(TiledClouds, AreTheSameFromSeveralProcesses)
{
  std::vector<Bytes> expected;
  for (std::size_t tile = 0; tile < cloud->size(); ++tile)
    expected.push_back(cloud->resultOf("tiles", tile));
  cloud->remove();
  cloud.reset();
  team = makeTeam(3);
  divide();
  ASSERT_EQ(cloud->size(), expected.size());
  for (std::size_t tile = 0; tile < cloud->size(); ++tile)
    EXPECT_EQ(cloud->resultOf("tiles", tile), expected[tile]);
}

TEST_F(TiledClouds, CheckResultsOfAllTiles)
{
  countPoints();
  cloud->check("counts");
  const std::string path = cloud->pathOf("counts", 3);
  std::ofstream(path, std::ios::binary) << "abcd"; // as many bytes
  EXPECT_NE(refusal([&] { cloud->check("counts"); }).find("was damaged"),
            std::string::npos);
  EXPECT_FALSE(std::filesystem::exists(path));
}

TEST_F(TiledClouds, KeepTheirOwnNames)
{
  const auto none = [](std::size_t, const TilePoints&) { return Bytes{}; };
  for (const char* const name : {"tiles", "survey", "sections", "rows"})
    EXPECT_NE(refusal([&] { cloud->run(name, 0.0, none); }).find("another name"),
              std::string::npos)
        << name;
}

TEST_F(TiledClouds, DecideOnce)
{
  EXPECT_EQ(cloud->decide("color", [] { return std::string("red"); }), "red");
  divide();
  EXPECT_EQ(cloud->decide("color", [] { return std::string("blue"); }), "red");
}

TEST_F(TiledClouds, RefuseOtherSourcesAndSettings)
{
  EXPECT_NE(refusal([&] { divide("2"); }).find("other sources"), std::string::npos);
  EXPECT_NE(refusal([&] {
              divide("1", {300, 0.0, "x"});
            }).find("other max_points"),
            std::string::npos);
  EXPECT_NE(refusal([&] {
              divide("1", {200, 2.0, "x"});
            }).find("other max_edge"),
            std::string::npos);
  EXPECT_NE(refusal([&] {
              divide("1", {200, 0.0, "y"});
            }).find("other parameters"),
            std::string::npos);
  divide();
}

TEST_F(TiledClouds, RefuseRecordsOfAnotherVersion)
{
  cloud.reset();
  const std::string path = directory + "/manifest.jsonl";
  const std::vector<Manifest::Record> records = Manifest(path, false).records();
  for (const Manifest::Record& unknown :
       {Manifest::Record{{"event", "result"}, {"name", "counts"}},
        Manifest::Record{{"event", "decision"}, {"name", "tiles"}, {"value", "{"}},
        Manifest::Record{{"event", "decision"}, {"name", "tiles"}, {"value", "{}"}}}) {
    std::filesystem::remove(path);
    Manifest changed(path, true);
    for (const Manifest::Record& record : records)
      changed.add(record);
    changed.add(unknown);
    EXPECT_NE(refusal([&] { divide(); }).find("unknown record"), std::string::npos)
        << unknown;
  }
}

TEST_F(TiledClouds, AreUsedByOneRun)
{
  const std::string error = refusal([&] {
    TiledCloud(directory, sources(), {200, 0.0, "x"}, *team);
  });
  EXPECT_NE(error.find("another run"), std::string::npos) << error;
}

TEST_F(TiledClouds, CountWhatIsTooLargeForFloat)
{
  points[20] = {1e300, 0.0, 0.0};
  points[21] = {0.0, -std::numeric_limits<double>::max(), 0.0};
  cloud.reset();
  std::filesystem::remove_all(directory);
  divide();
  EXPECT_EQ(cloud->countNotFinite(), 3U);
  EXPECT_FALSE(cloud->holds(points[20]));
  EXPECT_TRUE(cloud->holds(points[22]));
  std::size_t count = 0;
  for (std::size_t tile = 0; tile < cloud->size(); ++tile)
    count += cloud->load(tile, 0.0).own;
  EXPECT_EQ(count, points.size() - 3);
}

TEST_F(TiledClouds, RefuseWhatCannotBe)
{
  EXPECT_FALSE(
      refusal([&] { TiledCloud("/proc/tiles", sources(), {}, *team); }).empty());
  const std::string other = temporary.path() + "/other";
  EXPECT_FALSE(refusal([&] { TiledCloud(other, {}, {}, *team); }).empty());
  EXPECT_FALSE(refusal([&] {
                 TiledCloud(other, sources(), {0, 0.0, ""}, *team);
               }).empty());
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  const TiledCloud::Sources none{std::make_shared<MemorySource>(
      "none", std::vector<Position>(3, {nan, nan, nan}))};
  EXPECT_NE(refusal([&] {
              TiledCloud(other, none, {}, *team).partition();
            }).find("none of 3 points"),
            std::string::npos);
}

TEST_F(TiledClouds, LeaveOtherFilesAlone)
{
  const std::string other = temporary.path() + "/other";
  std::filesystem::create_directory(other);
  std::ofstream(other + "/000001.bin.2.tmp") << "mine";
  const auto begin = [&](const std::string& where) {
    return refusal([&] { TiledCloud(where, sources(), {200, 0.0, "x"}, *team); });
  };
  EXPECT_NE(begin(other).find("holds other files"), std::string::npos);
  EXPECT_TRUE(std::filesystem::exists(other + "/000001.bin.2.tmp"));
  // What was put into a directory of tiles stays there, too.
  for (const char* const name : {"/a.tmp", "/tiles/b.tmp", "/tiles/000001.bin.2.tmp"})
    std::ofstream(directory + name) << "text";
  divide();
  EXPECT_FALSE(std::filesystem::exists(directory + "/tiles/000001.bin.2.tmp"));
  EXPECT_NE(refusal([&] { cloud->remove(); }).find("cannot be removed"),
            std::string::npos);
  EXPECT_TRUE(std::filesystem::exists(directory + "/a.tmp"));
  EXPECT_TRUE(std::filesystem::exists(directory + "/tiles/b.tmp"));
}

TEST_F(TiledClouds, CanBeRemoved)
{
  cloud->remove();
  EXPECT_FALSE(std::filesystem::exists(directory));
}

} // namespace
