// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// The default mode of surfaces and edges, and models of several classes.

#include "app_test.h"
#include "io/cloud_file.h"
#include "io/pcd.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>

using namespace pcl::app;
using namespace pcl_shape_test;
using Json = nlohmann::json;

namespace {

class DefaultMode : public AppTest {
protected:
  /** \brief A scene of surfaces sampled at random, exact. */
  std::string
  sampledScene(const std::string& seed = "5") const
  {
    std::string scene = path("scene" + seed + ".pcd");
    expectSuccess(
        runApp("pcl_shape_scene",
               {scene, "-seed", seed, "-objects", "3", "-sampling", "0.003"}));
    return scene;
  }

  double
  f1(const std::string& predicted, const std::string& truth, const std::string& task)
  {
    expectSuccess(runApp("pcl_shape_evaluate",
                         {predicted, truth, "-task", task, "-json", path("score")}));
    return Json::parse(readFile(path("score")))["classes"][task]["f1"];
  }
};

TEST_F(DefaultMode, IsBetterThanThePapersOnExactSurfaces)
{
  const std::string scene = sampledScene();
  expectSuccess(runApp("pcl_shape_edge_detection",
                       {scene, path("default.pcd"), "-json", path("json")}));
  expectSuccess(
      runApp("pcl_shape_edge_detection", {scene, path("paper.pcd"), "-mode", "paper"}));
  const double by_default = f1(path("default.pcd"), scene, "edge");
  EXPECT_GE(by_default, 0.75);
  EXPECT_GE(by_default, 0.15 + f1(path("paper.pcd"), scene, "edge"));
  EXPECT_EQ(Json::parse(readFile(path("json")))["parameters"]["scale"], "density");
}

TEST_F(DefaultMode, TypesAreWrittenAndCounted)
{
  const std::string scene = sampledScene();
  expectSuccess(runApp("pcl_shape_edge_detection",
                       {scene, path("out.pcd"), "-types", "-json", path("json")}));
  const CloudFile cloud = readCloud(path("out.pcd"));
  const auto types = labelsOf(cloud, "edge_type");
  const auto edge = labelsOf(cloud, "edge");
  const Json counts = Json::parse(readFile(path("json")))["types"];
  EXPECT_EQ(counts["corner"], std::count(types.begin(), types.end(), 2u));
  EXPECT_EQ(counts["open_boundary"], std::count(types.begin(), types.end(), 3u));
  EXPECT_GT(counts["corner"], 0);
  EXPECT_GT(counts["open_boundary"], 0) << "the table ends";
  for (std::size_t i = 0; i < types.size(); ++i)
    ASSERT_EQ(edge[i] == 1, types[i] == 1 || types[i] == 2) << i;
}

TEST_F(DefaultMode, TypesNeedIt)
{
  expectRefused(runApp("pcl_shape_edge_detection",
                       {sampledScene(), path("out.pcd"), "-types", "-radius", "0.01"}),
                2,
                {"-radius '0.01'", "paper's method", "-mode paper"});
  expectRefused(runApp("pcl_shape_edge_detection",
                       {sampledScene(), path("out.pcd"), "-types", "-mode", "paper"}),
                2,
                {"-types", "default method"});
}

TEST_F(DefaultMode, AThresholdNeedsOneClass)
{
  const std::string scene = sampledScene(), out = path("out.pcd");
  expectRefused(runApp("pcl_shape_back_projection", {scene, out, "-threshold", "0.9"}),
                2,
                {"-threshold", "likeliest", "-mode paper"});
  expectSuccess(runApp("pcl_shape_back_projection",
                       {scene, out, "-mode", "paper", "-threshold", "0.9"}));
}

TEST_F(DefaultMode, SampledScenesCountTheirObjects)
{
  expectSuccess(runApp(
      "pcl_shape_scene",
      {path("s.pcd"), "-objects", "3", "-sampling", "0.01", "-json", path("json")}));
  EXPECT_EQ(Json::parse(readFile(path("json")))["counts"]["objects"], 3);
}

TEST_F(DefaultMode, ModelsOfSeveralClassesComeFromLabeledClouds)
{
  const std::string model = path("m.json");
  const std::string scene = sampledScene("6");
  expectSuccess(runApp("pcl_shape_histogram",
                       {sampledScene("7"),
                        sampledScene("8"),
                        model,
                        "-scale",
                        "density",
                        "-normal_radius",
                        "4",
                        "-radius",
                        "5",
                        "-bins",
                        "30",
                        "-smoothing",
                        "1",
                        "-floor",
                        "0.001",
                        "-field",
                        "surface",
                        "-classes",
                        "planar=1:3,curved=2",
                        "-json",
                        path("json")}));
  EXPECT_EQ(Json::parse(readFile(path("json")))["samples"], 2);
  const Json written = Json::parse(readFile(model));
  EXPECT_EQ(written["parameters"]["scale"], "density");
  EXPECT_EQ(written["classes"][0]["prior"], 3.0);
  EXPECT_EQ(written["classes"][1]["name"], "curved");
  expectSuccess(
      runApp("pcl_shape_back_projection", {scene, path("out.pcd"), "-model", model}));
  EXPECT_GE(f1(path("out.pcd"), scene, "planar"), 0.95);
  expectRefused(
      runApp("pcl_shape_edge_detection", {scene, path("edges.pcd"), "-model", model}),
      1,
      {model, "planar", "expected edge"});
}

TEST_F(DefaultMode, AHistogramIsDrawn)
{
  if (runProgram("/bin/sh", {"-c", "python3 -c 'import matplotlib' 2>/dev/null"})
          .status != 0)
    GTEST_SKIP() << "python3-matplotlib is not installed";
  const std::string plane = file("in.pcd", asciiCloud("x y z", "F F F", planeRows(20)));
  const std::string fold = file("fold.pcd", asciiCloud("x y z", "F F F", foldRows(20)));
  const auto draw = [](const Words& words) {
    Words arguments{PCL_SHAPE_SCRIPTS "/draw/draw_histogram.py"};
    arguments.insert(arguments.end(), words.begin(), words.end());
    return runProgram("/usr/bin/env", arguments).status;
  };
  for (const std::string& cloud : {plane, fold}) {
    expectSuccess(
        runApp("pcl_shape_histogram", {cloud, cloud + ".json", "-radius", "0.02"}));
    EXPECT_EQ(draw({cloud + ".json", cloud + ".png"}), 0);
  }
  const std::string png = readFile(plane + ".png");
  EXPECT_EQ(png.substr(1, 3), "PNG");
  EXPECT_EQ(png.substr(12, 4), "IHDR");
  EXPECT_NE(png, readFile(fold + ".png")) << "other counts, other colors";
  EXPECT_NE(draw({plane + ".json", path("missing/m.png")}), 0);
  EXPECT_NE(draw({plane + ".json", path("m.png"), "curved"}), 0);
}

TEST_F(DefaultMode, BadClassesAreRefused)
{
  const std::string scene = sampledScene();
  const auto refuse = [&](const Words& options, const Words& words) {
    Words all{scene, path("m.json"), "-radius", "0.01"};
    all.insert(all.end(), options.begin(), options.end());
    expectRefused(runApp("pcl_shape_histogram", all), 2, words);
  };
  refuse({"-classes", "a=1"}, {"-classes", "without -field"});
  for (const char* bad : {"a", "a=x", "=1", "a=1:0", "a=1:", "a=-1", "a=1.5"})
    refuse({"-field", "surface", "-classes", bad}, {"-classes", bad, "NAME=VALUE"});
  refuse({"-smoothing", "1"}, {"-smoothing", "-scale density"});
  refuse({"-radius_noise", "1"}, {"-radius_noise", "-scale density"});
  refuse({"-scale", "inches"}, {"-scale", "inches", "density"});
}

TEST_F(DefaultMode, AClassWithoutAPointIsRefused)
{
  expectRefused(runApp("pcl_shape_histogram",
                       {sampledScene(),
                        path("m.json"),
                        "-radius",
                        "0.01",
                        "-field",
                        "surface",
                        "-classes",
                        "planar=1,none=77"}),
                1,
                {"'none'", "77", "'surface'", "expected"});
  EXPECT_FALSE(exists(path("m.json")));
}

TEST_F(DefaultMode, TheScaleOfRadiiDoesNotKnowTheUnit)
{
  const std::string plane = file("in.pcd", asciiCloud("x y z", "F F F", planeRows(20)));
  expectSuccess(runApp("pcl_inad_estimation",
                       {plane, path("out.pcd"), "-radius", "2", "-scale", "density"}));
  const auto mu = floatsOf(readCloud(path("out.pcd")), "mu");
  EXPECT_TRUE(std::all_of(mu.begin(), mu.end(), [](float m) { return m < 1e-3f; }));
}

} // namespace
