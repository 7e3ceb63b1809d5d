// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// pcl_shape_edge_detection -lines.

#include "app_test.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cmath>

using namespace pcl_shape_test;
using Json = nlohmann::json;

namespace {

const char* const app = "pcl_shape_edge_detection";

class AppLines : public AppTest {
protected:
  /** \brief Boxes and more, all over their surfaces; exact. */
  std::string
  scene() const
  {
    std::string scene = path("scene.pcd");
    expectSuccess(
        runApp("pcl_shape_scene",
               {scene, "-seed", "21", "-objects", "2", "-sampling", "0.003"}));
    return scene;
  }

  Json
  linesOf(const std::string& cloud, const std::string& threads = "0") const
  {
    expectSuccess(runApp(app,
                         {cloud,
                          path("out.pcd"),
                          "-lines",
                          path("lines.json"),
                          "-json",
                          path("json"),
                          "-threads",
                          threads}));
    return Json::parse(readFile(path("lines.json")));
  }
};

double
lengthOf(const Json& points)
{
  double length = 0.0;
  for (std::size_t i = 1; i < points.size(); ++i) {
    double squared = 0.0;
    for (std::size_t c = 0; c < 3; ++c) {
      const double d = points[i][c].get<double>() - points[i - 1][c].get<double>();
      squared += d * d;
    }
    length += std::sqrt(squared);
  }
  return length;
}

TEST_F(AppLines, HaveLengthsInMetresAndAnglesInDegrees)
{
  const std::string cloud = scene();
  const Json file = linesOf(cloud);
  EXPECT_EQ(file["format"], "pcl_shape lines");
  EXPECT_EQ(file["version"], 1);
  EXPECT_EQ(file["input"], cloud);
  double total = 0.0, previous = 1.0;
  for (const Json& line : file["lines"]) {
    const double length = line["length"];
    EXPECT_NEAR(length, lengthOf(line["points"]), 1e-5);
    EXPECT_LE(length, previous) << "the longest first";
    EXPECT_GE(length, 5 * line["spacing"].get<double>());
    EXPECT_NEAR(line["angle_degrees"], 90.0, 5.0) << "all edges of two upright boxes";
    previous = length;
    total += length;
  }
  const Json report = Json::parse(readFile(path("json")))["lines"];
  EXPECT_EQ(report["count"], file["lines"].size());
  EXPECT_NEAR(report["length"], total, 1e-9);
  EXPECT_GT(total, 1.0) << "of 2 m";
}

TEST_F(AppLines, DoNotDependOnThreads)
{
  const std::string cloud = scene();
  EXPECT_EQ(linesOf(cloud, "1"), linesOf(cloud, "3"));
}

TEST_F(AppLines, OfAPlaneAreNone)
{
  const std::string plane = file("in.pcd", asciiCloud("x y z", "F F F", planeRows(20)));
  EXPECT_EQ(linesOf(plane)["lines"], Json::array());
}

TEST_F(AppLines, NeedTheDefaultModeAndOneCloudAndAFileOfTheirOwn)
{
  const std::string cloud = file("in.pcd", asciiCloud("x y z", "F F F", planeRows(20)));
  const std::string out = path("out.pcd"), lines = path("lines.json");
  expectRefused(runApp(app, {cloud, out, "-lines", lines, "-radius", "0.01"}),
                2,
                {"-radius '0.01'", "paper's method", "-mode paper"});
  expectRefused(runApp(app, {cloud, out, "-lines", lines, "-mode", "paper"}),
                2,
                {"-lines", "-mode paper", "default method"});
  expectRefused(
      runApp(app, {"-input_dir", path("."), "-output_dir", path("d"), "-lines", lines}),
      2,
      {"-lines", "-input_dir"});
  for (const std::string& other : {cloud, out})
    expectRefused(runApp(app, {cloud, out, "-lines", other}),
                  2,
                  {"-lines", other, "another file"});
  expectRefused(runApp(app, {cloud, out, "-lines", lines, "-json", lines}),
                2,
                {"-lines", lines, "another file"});
  expectRefused(runApp(app, {cloud, out, "-lines", path("missing/l.json")}),
                1,
                {"missing/l.json"});
  EXPECT_EQ(files(), std::vector<std::string>{"in.pcd"});
}

TEST_F(AppLines, AFailureLeavesNoFile)
{
  const std::string bad = file("bad.pcd", "no cloud");
  expectRefused(
      runApp(app, {bad, path("out.pcd"), "-lines", path("lines.json")}), 1, {bad});
  EXPECT_EQ(files(), std::vector<std::string>{"bad.pcd"});
}

} // namespace
