// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Files by their endings, pipes, offsets and signals, through whole apps.

#include "app_test.h"
#include "io/any_cloud.h"
#include "io/cloud_stream.h"
#include "io/pcd.h"
#include "io/ply.h"

#include <pcl/features/coordinate_offset.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <csignal>
#include <cstring>
#include <filesystem>
#include <fstream>

#include <sys/resource.h>

namespace {

using namespace pcl::app;
using namespace pcl_shape_test;
using Json = nlohmann::json;
namespace fs = std::filesystem;

const std::string edges = "pcl_shape_edge_detection";

class Streams : public AppTest {
protected:
  /** \brief Run a command of the shell, where $APP is the edge detection. */
  Outcome
  shell(const std::string& command) const
  {
    return runProgram(
        "/bin/sh",
        {"-c", "APP='" + pathOf(edges) + "'; cd '" + path("") + "'; " + command});
  }

  std::string
  fold(const std::string& name) const
  {
    return file(name, asciiCloud("x y z", "F F F", foldRows(30)));
  }
};

/** The fold in double, moved. */
CloudFile
movedFold(double x, double y, double z)
{
  const CloudFile fold = decodePcd("fold", asciiCloud("x y z", "F F F", foldRows(30)));
  CloudFile moved;
  for (const char* const name : {"x", "y", "z"})
    addField(moved, name, pcl::PCLPointField::FLOAT64);
  moved.blob.width = fold.blob.width;
  moved.blob.height = 1;
  moved.blob.data.resize(fold.size() * moved.blob.point_step);
  const std::array<double, 3> by{x, y, z};
  const pcl::DoubleXYZ points = coordinatesOf(fold);
  for (std::size_t i = 0; i < points.size(); ++i)
    for (std::size_t c = 0; c < 3; ++c) {
      const double value = points[i][c] + by[c];
      std::memcpy(
          moved.blob.data.data() + (i * 3 + c) * sizeof(value), &value, sizeof(value));
    }
  return moved;
}

TEST(CloudStreams, AreOfTheFormatThatCloudsAreReadIn)
{
  const std::string ply = "ply\nformat ascii 1.0\n";
  const auto format = [&](const char* path, const std::string& head, unsigned floats) {
    return cloudFormatOf(path, head, floats);
  };
  EXPECT_EQ(format("a.PCD", ply, 4), CloudFormat::pcd);
  EXPECT_EQ(format("a.ply", "", 4), CloudFormat::ply);
  EXPECT_EQ(format("a.Bin", ply, 0), CloudFormat::kitti);
  EXPECT_EQ(format("a", ply, 0), CloudFormat::ply);
  EXPECT_EQ(format("a", ply, 4), CloudFormat::kitti);
  EXPECT_EQ(format("-", "VERSION 0.7", 0), CloudFormat::pcd);
}

TEST_F(Streams, FloatsOfAPointAreThoseOfAnUnknownEnding)
{
  const CloudStream stream(file("scan", std::string(40, '\0')), 5);
  EXPECT_EQ(stream.size(), 2u);
}

TEST_F(Streams, TheEndingSaysTheFormatInAnyCase)
{
  const std::string in = fold("in.PCD");
  expectSuccess(runApp(edges, {in, path("out.PLY")}));
  expectSuccess(runApp(edges, {in, path("text.ply"), "-format", "ascii"}));
  expectSuccess(runApp(edges, {in, path("out.pcd")}));
  EXPECT_EQ(readFile(path("out.PLY")).substr(0, 31),
            "ply\nformat binary_little_endian");
  EXPECT_EQ(readFile(path("text.ply")).substr(0, 16), "ply\nformat ascii");
  const CloudFile cloud = readAnyCloud(path("out.pcd"));
  for (const char* const name : {"out.PLY", "text.ply"})
    EXPECT_EQ(labelsOf(readAnyCloud(path(name)), "edge"), labelsOf(cloud, "edge"));
  expectSuccess(runApp(edges, {path("out.PLY"), path("again.pcd")}));
  EXPECT_EQ(readFile(path("again.pcd")), readFile(path("out.pcd")));
  expectRefused(runApp(edges, {in, path("out.bin")}), 2, {"KITTI", ".ply"});
  expectRefused(runApp(edges, {in, path("out.XYZ")}), 2, {"another format", ".ply"});
}

TEST_F(Streams, ADashIsStandardInputAndOutput)
{
  fold("in.pcd");
  const Outcome pipe = shell("cat in.pcd | $APP - - | cat > piped.pcd");
  EXPECT_EQ(pipe.status, 0) << pipe.err;
  EXPECT_EQ(pipe.out, "");
  EXPECT_NE(pipe.err.find("-: "), std::string::npos) << "the summary";
  expectSuccess(shell("$APP in.pcd out.pcd"));
  EXPECT_EQ(readFile(path("piped.pcd")), readFile(path("out.pcd")));
  expectSuccess(shell("mkfifo pipe; (cat in.pcd > pipe &); $APP pipe fifo.pcd"));
  EXPECT_EQ(readFile(path("fifo.pcd")), readFile(path("out.pcd")));
  expectSuccess(shell("$APP in.pcd in.ply && $APP - ply.pcd < in.ply"));
  EXPECT_EQ(readFile(path("ply.pcd")), readFile(path("out.pcd")));
  expectRefused(shell("$APP - no.pcd < /dev/null"), 1, {"empty", "expected"});
  expectRefused(shell("$APP in.pcd - -json - > out"), 2, {"-json", "'-'", "expected"});
  expectRefused(
      shell("$APP in.pcd - > /dev/full"), 1, {"standard output", "cannot be written"});
}

TEST_F(Streams, TilesCannotBeOfStandardInput)
{
  expectRefused(
      runApp("pcl_shape_tiles", {"-", "-edges", "-output_dir", path("tiles")}),
      1,
      {"standard input", "only once"});
}

TEST_F(Streams, ADirectoryMayHaveAllFormats)
{
  fs::create_directory(path("in"));
  const std::string pcd = fold("in/a.pcd");
  expectSuccess(runApp(edges, {pcd, path("in/B.PLY")}));
  const CloudFile plain = decodePcd(pcd, readFile(pcd));
  std::string scan;
  for (std::size_t i = 0; i < plain.size(); ++i)
    scan.append(reinterpret_cast<const char*>(plain.at(i, plain.blob.fields[0])), 12)
        .append(8, '\0');
  writeFile(path("in/c.pcd.bin"), scan);
  const Words arguments{
      "-input_dir", path("in"), "-output_dir", path("out"), "-floats", "5"};
  const Outcome outcome = runApp(edges, arguments);
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  for (const char* const name : {"out/a.pcd", "out/B.PLY", "out/c.pcd"})
    EXPECT_EQ(labelsOf(readAnyCloud(path(name)), "edge").size(), plain.size()) << name;
  EXPECT_NE(findField(readAnyCloud(path("out/c.pcd")), "ring"), nullptr);
  writeFile(path("in/a.bin"), scan);
  expectRefused(runApp(edges, arguments), 1, {"a.bin", "a.pcd", "same output"});
}

TEST_F(Streams, LargeDoublesLoseAnOffsetAndKeepTheirValues)
{
  const CloudFile near = movedFold(0, 0, 0), far = movedFold(500000, 5400000, 300);
  writeFile(path("near.pcd"), encodeCloud(near, PCDFormat::binary));
  writeFile(path("far.ply"), encodePly(far));
  expectSuccess(runApp(edges, {path("near.pcd"), path("near_out.pcd")}));
  const Outcome outcome =
      runApp(edges, {path("far.ply"), path("far_out.ply"), "-json", path("json")});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_NE(outcome.err.find("offset 500000,5400000,301"), std::string::npos)
      << outcome.err;
  EXPECT_EQ(Json::parse(readFile(path("json")))["parameters"]["offset"],
            Json({500000.0, 5400000.0, 301.0}));
  const CloudFile out = readAnyCloud(path("far_out.ply"));
  EXPECT_EQ(coordinatesOf(out), coordinatesOf(far));
  const auto expected = labelsOf(readAnyCloud(path("near_out.pcd")), "edge");
  EXPECT_EQ(labelsOf(out, "edge"), expected);
  EXPECT_GT(std::count(expected.begin(), expected.end(), 1u), 0);
  const Outcome given =
      runApp(edges, {path("far.ply"), path("g.pcd"), "-offset", "500000,5400000,300"});
  ASSERT_EQ(given.status, 0) << given.err;
  EXPECT_EQ(given.err.find("warning"), std::string::npos) << given.err;
  const Outcome useless =
      runApp(edges, {path("far.ply"), path("u.pcd"), "-offset", "1,2,3"});
  EXPECT_EQ(useless.status, 0) << useless.err;
  for (const char* const words :
       {"with -offset '1,2,3'", "steps of 0.5,", "the middle"})
    EXPECT_NE(useless.err.find(words), std::string::npos) << useless.err;
  EXPECT_EQ(labelsOf(readAnyCloud(path("g.pcd")), "edge"), expected);
  expectRefused(
      runApp(edges, {path("far.ply"), path("g.pcd"), "-offset", "1,2"}), 2, {"X,Y,Z"});
}

TEST_F(Streams, RepeatedPointsHaveTheAngleOfTheirPlace)
{
  const Words rows = foldRows(20);
  Words repeated = rows;
  repeated.insert(repeated.end(), rows.begin(), rows.end());
  repeated.insert(repeated.end(), rows.size(), "0 0 0"); // a driver's fillers
  file("once.pcd", asciiCloud("x y z", "F F F", rows));
  file("twice.pcd", asciiCloud("x y z", "F F F", repeated));
  for (const Words& size : {Words{"-radius", "0.02"}, Words{"-k", "12"}}) {
    const auto anglesOf = [&](const std::string& name) {
      Words words{path(name), path("out.pcd")};
      words.insert(words.end(), size.begin(), size.end());
      expectSuccessOrWarnings(runApp("pcl_inad_estimation", words));
      return floatsOf(readAnyCloud(path("out.pcd")), "mu");
    };
    const std::vector<float> once = anglesOf("once.pcd"), all = anglesOf("twice.pcd");
    ASSERT_EQ(once.size(), rows.size());
    ASSERT_EQ(all.size(), repeated.size());
    for (std::size_t i = 0; i < rows.size(); ++i) {
      EXPECT_EQ(all[i], once[i]) << size[0] << ' ' << i;
      EXPECT_EQ(all[rows.size() + i], once[i]) << size[0] << ' ' << i;
    }
    for (std::size_t i = 2 * rows.size(); i < all.size(); ++i)
      if (size[0] == "-k")
        EXPECT_TRUE(std::isfinite(all[i]) && all[i] == all.back()) << i;
      else
        EXPECT_TRUE(std::isnan(all[i])) << i;
  }
}

TEST_F(Streams, MoreNeighborsThanPlacesAreRefused)
{
  const Words rows{"0 0 0", "1 0 0", "0 1 0", "0 0 0", "1 0 0"};
  const std::string cloud = file("few.pcd", asciiCloud("x y z", "F F F", rows));
  expectRefused(runApp("pcl_inad_estimation", {cloud, path("out.pcd"), "-k", "4"}),
                1,
                {"-k '4'", "distinct points, 3 of 5", "expected"});
}

TEST_F(Streams, CoordinatesThatFloatDestroyedGiveAWarning)
{
  CloudFile cloud = movedFold(500000, 5400000, 300);
  const pcl::DoubleXYZ points = coordinatesOf(cloud);
  const char* const names[] = {"x", "y", "z"};
  for (std::size_t c = 0; c < 3; ++c) {
    std::vector<float> values;
    for (const auto& point : points)
      values.push_back(static_cast<float>(point[c]));
    setField(cloud, names[c], values);
  }
  writeFile(path("utm.pcd"), encodeCloud(cloud, PCDFormat::binary));
  const Outcome outcome = runApp(edges, {path("utm.pcd"), path("out.pcd")});
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_NE(outcome.err.find("steps of 0.5,"), std::string::npos) << outcome.err;
  EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
}

TEST_F(Streams, FillersDoNotMoveTheOffset)
{
  const CloudFile clean = movedFold(500000, 5400000, 300);
  const pcl::DoubleXYZ points = coordinatesOf(clean);
  for (const double filler : {0.0, -9999.0}) {
    CloudFile cloud = clean;
    const std::array<double, 3> place{filler, filler, filler};
    for (std::size_t i = 0; i < points.size() / 2; ++i) {
      const auto* const bytes = reinterpret_cast<const std::uint8_t*>(place.data());
      cloud.blob.data.insert(
          cloud.blob.data.end(), bytes, bytes + cloud.blob.point_step);
      ++cloud.blob.width;
    }
    ASSERT_EQ(cloud.blob.point_step, sizeof(place));
    writeFile(path("fillers.pcd"), encodeCloud(cloud, PCDFormat::binary));
    const Outcome outcome = runApp(edges, {path("fillers.pcd"), path("out.pcd")});
    EXPECT_NE(outcome.err.find("offset 500000,5400000,301"), std::string::npos)
        << outcome.err;
    EXPECT_NE(outcome.err.find("900 of 2700 points got no answer"), std::string::npos)
        << outcome.err;
    const auto found = labelsOf(readAnyCloud(path("out.pcd")), "edge");
    EXPECT_GT(std::count(found.begin(), found.end(), 1u), 0) << filler;
  }
}

TEST_F(Streams, SitesTooFarApartForOneOffsetAreSaid)
{
  CloudFile cloud = movedFold(500000, 5400000, 300);
  const CloudFile near = movedFold(0, 0, 0);
  for (int sites = 0; sites < 2; ++sites) {
    cloud.blob.data.insert(
        cloud.blob.data.end(), near.blob.data.begin(), near.blob.data.end());
    cloud.blob.width += near.blob.width;
  }
  writeFile(path("sites.pcd"), encodeCloud(cloud, PCDFormat::binary));
  const Outcome outcome = runApp(edges, {path("sites.pcd"), path("out.pcd")});
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_NE(outcome.err.find("coordinates too large for float"), std::string::npos)
      << outcome.err;
}

TEST_F(Streams, ALimitOfTheFileSizeLeavesNothing)
{
  fold("in.pcd");
  const Outcome outcome =
      shell("ulimit -c 0; ulimit -f 1; exec $APP in.pcd out.pcd -format binary");
  EXPECT_EQ(outcome.status, -SIGXFSZ) << outcome.err;
  EXPECT_NE(outcome.err.find("SIGXFSZ"), std::string::npos) << outcome.err;
  EXPECT_EQ(files(), Words{"in.pcd"});
}

long
mostKilobytes()
{
  rusage usage{};
  ::getrusage(RUSAGE_SELF, &usage);
  return usage.ru_maxrss;
}

TEST_F(Streams, SectionsHaveAllPointsInTheirOrder)
{
  constexpr std::size_t points = 300'001; // three sections, not of equal size
  std::string text = "# .PCD v0.7\nVERSION 0.7\nFIELDS x y z id\nSIZE 4 4 4 4\n"
                     "TYPE F F F U\nCOUNT 1 1 1 1\nWIDTH 300001\nHEIGHT 1\n"
                     "POINTS 300001\nDATA binary\n";
  for (std::uint32_t i = 0; i < points; ++i) {
    const std::array<float, 3> at{static_cast<float>(i), 1.0f, 2.0f};
    text.append(reinterpret_cast<const char*>(at.data()), sizeof at);
    text.append(reinterpret_cast<const char*>(&i), sizeof i);
  }
  writeFile(path("many.pcd"), text);
  const CloudStream stream(path("many.pcd"));
  ASSERT_EQ(stream.countSections(), 3U);
  std::vector<double> x;
  std::vector<std::uint32_t> ids;
  for (std::size_t section = 0; section < stream.countSections(); ++section) {
    const std::size_t before = x.size();
    stream.forEachPosition(section, [&](const auto* positions, std::size_t count) {
      for (std::size_t i = 0; i < count; ++i)
        x.push_back(positions[i][0]);
    });
    EXPECT_NEAR(static_cast<double>(x.size() - before), points / 3.0, 1.0);
    stream.forEachPart(section, [&](const CloudFile& part) {
      const std::vector<std::uint32_t> some = pcl::app::labelsOf(part, "id");
      ids.insert(ids.end(), some.begin(), some.end());
    });
  }
  ASSERT_EQ(x.size(), points);
  ASSERT_EQ(ids.size(), points);
  for (std::uint32_t i = 0; i < points; ++i)
    ASSERT_TRUE(x[i] == i && ids[i] == i) << i;
}

TEST_F(Streams, ManyShortLinesNeedLittleMemory)
{
  constexpr std::size_t lines = 6'000'000; // 36 MB
  const std::string cloud = path("short.pcd");
  {
    std::string header = asciiCloud("x y z", "F F F", {"0 0 0"});
    for (const std::string word : {"WIDTH 1\n", "POINTS 1\n"})
      header.replace(header.find(word) + word.size() - 2, 1, std::to_string(lines));
    std::ofstream out(cloud);
    out << header;
    for (std::size_t i = 1; i < lines; ++i)
      out << "0 0 0\n";
  }
  const CloudStream stream(cloud);
  std::size_t points = 0, parts = 0;
  long before = 0;
  stream.forEachPart(0, [&](const CloudFile& part) {
    points += part.size();
    constexpr std::size_t warm = 4; // after these parts all buffers are there
    if (++parts == warm)
      before = mostKilobytes();
  });
  EXPECT_EQ(points, lines);
  EXPECT_LT(mostKilobytes() - before, 12'000);
}

} // namespace
