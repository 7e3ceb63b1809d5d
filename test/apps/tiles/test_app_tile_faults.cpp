// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// pcl_shape_tiles goes on after a kill, notices damage, and refuses what cannot be.

#include "app_test.h"
#include "io/pcd.h"
#include "tile_clouds.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <unistd.h>

#include <sys/stat.h>

namespace {

using namespace pcl_shape_test;
namespace fs = std::filesystem;

class TileFaults : public AppTest {
protected:
  TileFaults()
  {
    constexpr std::size_t points = 8000;
    fs::create_directories(path("in"));
    cloud = withTrouble(roomCloud(points));
    write(input, cloud);
  }

  static void
  write(const std::string& file, const TilePointCloud& points, bool is_double = false)
  {
    std::vector<std::size_t> order(points.size());
    for (std::size_t i = 0; i < order.size(); ++i)
      order[i] = i;
    writeFile(file, tileCloudFile(points, order, is_double));
  }

  Words
  command(const std::string& out, const Words& more = {}) const
  {
    Words words{input, "-output_dir", path(out), "-normals", "-inad", "0.2"};
    words.insert(words.end(), {"-tile", "2.6", "-threads", "1"});
    words.insert(words.end(), more.begin(), more.end());
    return words;
  }

  Outcome
  tiles(const std::string& out, const Words& more = {}) const
  {
    return runApp("pcl_shape_tiles", command(out, more));
  }

  std::string
  output(const std::string& out) const
  {
    return readFile(path(out) + "/room.pcd");
  }

  std::string
  manifest(const std::string& out) const
  {
    return path(out) + "/tiles/manifest.jsonl";
  }

  std::size_t
  countLines(const std::string& out) const
  {
    if (!exists(manifest(out)))
      return 0;
    const std::string text = readFile(manifest(out));
    return static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n'));
  }

  /** \brief Run until the manifest has so many lines, then SIGKILL. With -keep_tiles a
   * run that has ended by then leaves what one that was killed leaves, too. */
  void
  killAt(std::size_t lines, const std::string& out, const Words& more = {}) const
  {
    RunningApp app("pcl_shape_tiles", command(out, more));
    app.waitUntil([&] { return countLines(out) >= lines; });
    app.kill();
  }

  const std::string input = path("in/room.pcd");
  TilePointCloud cloud;
};

TEST_F(TileFaults, RunsThatAreKilledGoOn)
{
  expectSuccess(tiles("whole", {"-keep_tiles"}));
  const std::size_t all = countLines("whole");
  ASSERT_GT(all, 60U);
  for (const std::string processes : {"1", "2"})
    for (const std::size_t share : {2U, 5U}) { // early: else it may end before
      const std::string out = "killed" + processes + std::to_string(share);
      killAt(all * share / 10, out, {"-processes", processes, "-keep_tiles"});
      const std::size_t before = countLines(out);
      expectSuccess(tiles(out, {"-processes", processes, "-keep_tiles"}));
      EXPECT_EQ(countLines(out), all) << before << " before"; // nothing is done twice
      EXPECT_TRUE(output(out) == output("whole")) << share;
    }
}

TEST_F(TileFaults, KilledAgainAndAgain)
{
  expectSuccess(tiles("whole", {"-keep_tiles"}));
  const std::size_t all = countLines("whole");
  for (std::size_t lines = 3; lines < all; lines += all / 4)
    killAt(lines, "out", {"-processes", "2", "-keep_tiles"});
  expectSuccess(tiles("out"));
  EXPECT_TRUE(output("out") == output("whole"));
}

TEST_F(TileFaults, AnotherFormatAfterAKillInTheJoin)
{
  expectSuccess(tiles("whole", {"-keep_tiles"}));
  killAt(countLines("whole"), "out", {"-format", "ascii", "-keep_tiles"});
  fs::remove(path("out/room.pcd"));
  expectSuccess(tiles("out", {"-keep_tiles"}));
  EXPECT_TRUE(output("out") == output("whole"));
  EXPECT_FALSE(exists(path("out/tiles/joined_ascii")));
}

TEST_F(TileFaults, OtherParametersAndInputsAreRefused)
{
  killAt(40, "out", {"-keep_tiles"});
  expectRefused(tiles("out", {"-edges"}), 1, {"out/tiles", "parameters"});
  expectRefused(tiles("out", {"-memory", "1G"}), 1, {"out/tiles", "max_points"});
  cloud[5][0] += 0.01;
  write(input, cloud);
  expectRefused(tiles("out"), 1, {"out/tiles", "sources", "expected the same"});
  fs::remove(input);
  expectRefused(tiles("out"), 1, {"room.pcd", "No such file"});
}

TEST_F(TileFaults, DamageIsRepaired)
{
  expectSuccess(tiles("out", {"-keep_tiles"}));
  const std::string expected = output("out");
  const auto repaired = [&] {
    fs::remove(path("out/room.pcd"));
    expectSuccess(tiles("out", {"-keep_tiles"}));
    return output("out") == expected;
  };
  fs::resize_file(path("out/tiles/fields/000003.bin"), 100);
  fs::remove(path("out/tiles/fields/000007.bin"));
  EXPECT_TRUE(repaired());
  fs::resize_file(path("out/tiles/tiles/000002.bin"), 1000);
  fs::remove(path("out/tiles/tiles/000005.bin"));
  fs::remove(path("out/tiles/fields/000005.bin"));
  EXPECT_TRUE(repaired());
  std::fstream(path("out/tiles/fields/000001.bin"),
               std::ios::in | std::ios::out | std::ios::binary)
      .write("damaged", 7);
  fs::remove(path("out/room.pcd"));
  expectRefused(tiles("out", {"-keep_tiles"}), 1, {"000001.bin", "damaged"});
  EXPECT_FALSE(exists(path("out/room.pcd")));
  EXPECT_TRUE(repaired());
}

TEST_F(TileFaults, AChangedManifestIsRefused)
{
  killAt(40, "out", {"-keep_tiles"});
  std::string text = readFile(manifest("out"));
  const std::size_t place = text.find("\"bytes\":") + 8;
  text[place] = text[place] == '9' ? '8' : '9';
  writeFile(manifest("out"), text);
  expectRefused(tiles("out"), 1, {"manifest.jsonl", "was changed"});
}

TEST_F(TileFaults, TwoRunsExcludeEachOther)
{
  RunningApp app("pcl_shape_tiles", command("out"));
  app.waitUntil([&] { return countLines("out") > 3; });
  app.stop();
  expectRefused(tiles("out"), 1, {"another run"});
}

TEST_F(TileFaults, AFullDiskIsAnErrorAndTheRerunGoesOn)
{
  expectSuccess(tiles("whole"));
  std::string words;
  for (const std::string& word : command("out"))
    words += " '" + word + "'";
  // Blocks of 512 bytes: enough for tiles, but not for the output.
  const Outcome limited = runProgram(
      "/bin/sh",
      {"-c", "ulimit -f 500; exec '" + pathOf("pcl_shape_tiles") + "'" + words});
  EXPECT_NE(limited.status, 0);
  EXPECT_NE(limited.err.find("size of files"), std::string::npos) << limited.err;
  EXPECT_FALSE(exists(path("out/room.pcd")));
  expectSuccess(tiles("out"));
  EXPECT_TRUE(output("out") == output("whole"));
}

TEST_F(TileFaults, AReadOnlyDirectoryIsRefused)
{
  if (::geteuid() == 0)
    GTEST_SKIP() << "root may write everywhere";
  constexpr mode_t read_only = 0500, writable = 0700;
  ASSERT_EQ(::mkdir(path("out").c_str(), read_only), 0);
  expectRefused(tiles("out"), 1, {"out/room.pcd", "Permission denied", "expected"});
  expectRefused(tiles("out/deeper"), 1, {"out/deeper", "Permission denied"});
  // Outputs may be there to be written, but there is no place for tiles.
  ASSERT_EQ(::chmod(path("out").c_str(), writable), 0);
  ASSERT_EQ(::mkdir(path("out/tiles").c_str(), read_only), 0);
  expectRefused(tiles("out"), 1, {"out/tiles", "Permission denied"});
  ASSERT_EQ(::chmod(path("out/tiles").c_str(), writable), 0);
  expectSuccess(tiles("out"));
}

TEST_F(TileFaults, RunsOfInstancesThatAreKilledGoOn)
{
  constexpr std::size_t points = 3000; // surfaces take long
  write(input, withTrouble(roomCloud(points)));
  const auto find = [&](const std::string& out, const std::string& processes) {
    return Words{input,
                 "-output_dir",
                 path(out),
                 "-instances",
                 "planar",
                 "-tile",
                 "3.1",
                 "-threads",
                 "1",
                 "-processes",
                 processes,
                 "-keep_tiles"};
  };
  expectSuccess(runApp("pcl_shape_tiles", find("whole", "1")));
  const std::size_t all = countLines("whole");
  {
    // In the steps that follow surfaces, of which one process does some for all tiles.
    RunningApp app("pcl_shape_tiles", find("out", "2"));
    app.waitUntil([&] { return countLines("out") >= all * 7 / 10; });
    app.kill();
  }
  expectSuccess(runApp("pcl_shape_tiles", find("out", "2")));
  EXPECT_EQ(countLines("out"), all);
  EXPECT_TRUE(output("out") == output("whole"));
  // A file of a step is made anew, with those that are written with it.
  fs::remove(path("out/tiles/pieces/000002.bin"));
  fs::remove(path("out/tiles/fields/000001.bin"));
  fs::remove(path("out/room.pcd"));
  expectSuccess(runApp("pcl_shape_tiles", find("out", "1")));
  EXPECT_TRUE(output("out") == output("whole"));
}

TEST_F(TileFaults, WhatCannotBeIsRefused)
{
  file("file", "text");
  expectRefused(tiles("file"), 1, {"file", "cannot be made"});
  expectRefused(runApp("pcl_shape_tiles", {input}), 2, {"-output_dir"});
  expectRefused(runApp("pcl_shape_tiles", {input, "-output_dir", path("in")}),
                2,
                {"is an input"});
  expectRefused(runApp("pcl_shape_tiles", {input, input, "-output_dir", path("out")}),
                2,
                {"two inputs"});
  expectRefused(tiles("out", {"-memory", "3"}), 2, {"-memory", "'3'", "300M"});
  for (const Words& wanted : {Words{"-surfaces"}, Words{"-instances", "planar"}}) {
    Words words{input, "-output_dir", path("out"), "-memory", "799M"};
    words.insert(words.end(), wanted.begin(), wanted.end());
    expectRefused(
        runApp("pcl_shape_tiles", words), 2, {"-memory", "'799M'", "at least 800M"});
  }
  expectRefused(tiles("out", {"-processes", "0"}), 2, {"-processes"});
  expectRefused(tiles("out", {"-inad", "-1"}), 2, {"-inad"});
  expectRefused(tiles("out", {"-instances", "object"}), 2, {"-instances", "planar"});
  expectRefused(tiles("out", {"-json", path("out/room.pcd")}), 2, {"-json"});
  write(input, TilePointCloud(cloud.begin(), cloud.begin() + 9));
  expectRefused(tiles("out"), 1, {"9 different places", "at least 13"});
}

TEST_F(TileFaults, FilesOfTheUserStay)
{
  const std::string scan = path("survey/tiles/scan.pcd"),
                    note = path("survey/tiles/note.tmp");
  fs::create_directories(path("survey/tiles"));
  fs::copy_file(input, scan);
  writeFile(note, "a note");
  expectRefused(runApp("pcl_shape_tiles", {scan, "-output_dir", path("survey")}),
                2,
                {"scan.pcd", "where tiles go"});
  expectRefused(runApp("pcl_shape_tiles", {input, "-output_dir", path("survey")}),
                1,
                {"survey/tiles", "holds other files"});
  EXPECT_TRUE(readFile(scan) == readFile(input));
  EXPECT_EQ(readFile(note), "a note");
  EXPECT_FALSE(exists(path("survey/tiles/lock")));
}

TEST_F(TileFaults, VeryUnevenCloudsAreRefused)
{
  TilePointCloud uneven;
  for (std::size_t i = 0; i < cloud.size(); ++i)
    uneven.push_back({cloud[i][0] * (i % 10 == 0 ? 30.0 : 0.3),
                      cloud[i][1] * (i % 10 == 0 ? 30.0 : 0.3),
                      cloud[i][2]});
  write(input, uneven);
  const Outcome outcome = runApp(
      "pcl_shape_tiles", {input, "-output_dir", path("out"), "-edges", "-tile", "20"});
  expectRefused(outcome, 1, {"uneven density", "expected at most 2 %"});
}

TEST_F(TileFaults, LargeCoordinatesGiveTheSameFields)
{
  // Floats of other coordinates are rounded otherwise, so that noise is measured at
  // some other points: of a small cloud that changes more.
  constexpr std::size_t points = 60000;
  cloud = withTrouble(roomCloud(points));
  const auto find = [&](const std::string& out) {
    return runApp("pcl_shape_tiles",
                  {input, "-output_dir", path(out), "-edges", "-types", "-tile", "6"});
  };
  write(input, cloud, true);
  expectSuccess(find("near"));
  TilePointCloud far = cloud;
  for (TilePoint& p : far) {
    p[0] += 4e5;
    p[1] += 5.6e6;
  }
  write(input, far, true);
  const Outcome outcome = find("far");
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_NE(outcome.err.find("is subtracted"), std::string::npos) << outcome.err;
  const auto near_cloud = pcl::app::decodePcd("near", output("near"));
  const auto far_cloud = pcl::app::decodePcd("far", output("far"));
  for (const char* const name : {"edge", "edge_type"}) {
    const auto of_near = pcl::app::labelsOf(near_cloud, name);
    const auto of_far = pcl::app::labelsOf(far_cloud, name);
    std::size_t same = 0;
    for (std::size_t i = 0; i < of_near.size(); ++i)
      same += of_near[i] == of_far[i] ? 1 : 0;
    EXPECT_GE(static_cast<double>(same), 0.999 * static_cast<double>(of_near.size()))
        << name;
  }
  // And the file of the whole cloud, with its offset.
  const Outcome detected =
      runApp("pcl_shape_detect",
             {input, path("whole.pcd"), "-edges", "-types", "-format", "binary"});
  EXPECT_EQ(detected.status, 0) << detected.err;
  EXPECT_TRUE(output("far") == readFile(path("whole.pcd")));
}

TEST_F(TileFaults, OtherFormatsComeBack)
{
  const auto of = [&](const std::string& cloud_file, const Words& more) {
    Words words{cloud_file, "-output_dir", path("out"), "-edges", "-tile", "6"};
    words.insert(words.end(), more.begin(), more.end());
    return runApp("pcl_shape_tiles", words);
  };
  expectSuccessOrWarnings(
      runApp("pcl_shape_detect", {input, path("in/a.ply"), "-types"}));
  expectSuccess(runApp("pcl_shape_detect",
                       {input, path("in/b.pcd"), "-types", "-format", "ascii"}));
  expectSuccess(runApp("pcl_shape_detect",
                       {input, path("in/c.ply"), "-types", "-format", "ascii"}));
  expectSuccessOrWarnings(
      runApp("pcl_shape_detect", {input, path("in/d.pcd"), "-types"}));
  const std::map<std::string, std::string> formats{
      {"a.ply", "ascii"}, {"b.pcd", "binary"}, {"c.ply", "binary"}, {"d.pcd", "ascii"}};
  for (const auto& [name, format] : formats) {
    const std::string from = path("in/") + name, whole = path("w_") + name;
    expectSuccessOrWarnings(
        runApp("pcl_shape_detect", {from, whole, "-edges", "-format", format}));
    expectSuccessOrWarnings(of(from, {"-format", format}));
    EXPECT_TRUE(readFile(path("out/") + name) == readFile(whole))
        << name << ' ' << format;
  }
}

#ifdef PCL_SHAPE_MPIEXEC

Outcome
runRanks(const std::string& ranks, const Words& command)
{
  Words words{"--allow-run-as-root", "--oversubscribe", "-n", ranks};
  words.push_back(pathOf("pcl_shape_tiles"));
  words.insert(words.end(), command.begin(), command.end());
  return runProgram(PCL_SHAPE_MPIEXEC, words);
}

TEST_F(TileFaults, RanksOfMpiGiveTheSame)
{
  expectSuccess(tiles("whole"));
  for (const std::string ranks : {"1", "2", "4"}) {
    const std::string out = "ranks" + ranks;
    const Outcome outcome = runRanks(ranks, command(out));
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_TRUE(output(out) == output("whole")) << ranks << " ranks";
  }
}

TEST_F(TileFaults, RanksOfMpiRepairDamage)
{
  expectSuccess(tiles("whole"));
  EXPECT_EQ(runRanks("3", command("out", {"-keep_tiles"})).status, 0);
  fs::remove(path("out/room.pcd"));
  fs::remove(path("out/tiles/fields/000003.bin"));
  const Outcome outcome = runRanks("3", command("out"));
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_TRUE(output("out") == output("whole"));
}

TEST_F(TileFaults, ARankOfMpiThatFailsSaysWhy)
{
  write(input, TilePointCloud(cloud.begin(), cloud.begin() + 9));
  for (const std::string ranks : {"1", "2"}) {
    const Outcome outcome = runRanks(ranks, command("few" + ranks));
    EXPECT_EQ(outcome.status, 1) << outcome.err;
    EXPECT_NE(outcome.err.find("at least 13"), std::string::npos) << outcome.err;
    EXPECT_EQ(outcome.err.find("MPI_Finalize"), std::string::npos) << outcome.err;
  }
}

#endif

} // namespace
