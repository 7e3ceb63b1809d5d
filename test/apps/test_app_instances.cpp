// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// pcl_shape_instances: its output, its options and what it refuses.

// pcl_shape_instances, and pcl_shape_scene -shapes

#include "app_test.h"
#include "io/cloud_file.h"
#include "io/pcd.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>

using namespace pcl_shape_test;
using Json = nlohmann::json;

namespace {

const char* const app = "pcl_shape_instances";

class AppInstances : public AppTest {
protected:
  std::string
  scene(const std::string& shapes, const std::string& objects = "3") const
  {
    std::string scene = path("scene.pcd");
    expectSuccess(
        runApp("pcl_shape_scene",
               {scene, "-seed", "41", "-objects", objects, "-shapes", shapes}));
    return scene;
  }

  Json
  reportOf(const std::string& cloud, Words options) const
  {
    options.insert(options.begin(), {cloud, path("out.pcd"), "-json", path("json")});
    expectSuccess(runApp(app, options));
    return Json::parse(readFile(path("json")));
  }

  std::vector<std::uint32_t>
  labelsIn(const std::string& name) const
  {
    return pcl::app::labelsOf(pcl::app::readCloud(path(name)), "instance");
  }
};

double
norm(const Json& vector)
{
  return std::hypot(
      vector[0].get<double>(), vector[1].get<double>(), vector[2].get<double>());
}

TEST_F(AppInstances, TheFieldAndTheReportAgree)
{
  const std::string cloud = scene("cylinder");
  const Json report = reportOf(cloud, {"-primitive", "cylinder"});
  const auto labels = labelsIn("out.pcd");
  ASSERT_GE(report["instances"].size(), 3U);
  EXPECT_EQ(report["counts"]["instances"], report["instances"].size());
  EXPECT_EQ(*std::max_element(labels.begin(), labels.end()),
            report["instances"].size());
  EXPECT_EQ(report["parameters"]["class"], "curved");
  std::size_t id = 0;
  for (const Json& instance : report["instances"]) {
    EXPECT_EQ(instance["id"], ++id);
    EXPECT_EQ(instance["class"], "curved");
    EXPECT_EQ(instance["points"], std::count(labels.begin(), labels.end(), id));
    EXPECT_EQ(instance["centroid"].size(), 3U);
    EXPECT_GT(instance["curved"], 0.9);
    EXPECT_NEAR(
        instance["curved"].get<double>() + instance["planar"].get<double>(), 1.0, 1e-6);
    const Json& primitive = instance["primitive"];
    EXPECT_EQ(primitive["type"], "cylinder");
    EXPECT_NEAR(norm(primitive["axis"]), 1.0, 1e-5);
  }
  const Json& largest = report["instances"][0]["primitive"];
  EXPECT_GT(largest["radius"], 0.02);
  EXPECT_LT(largest["radius"], 0.08);
  EXPECT_LT(largest["residual"], 0.005);
}

TEST_F(AppInstances, FieldsOfTheInputAreKeptAndTheTruthIsEvaluated)
{
  const std::string cloud = scene("box");
  reportOf(cloud, {"-class", "object"});
  const auto out = pcl::app::readCloud(path("out.pcd"));
  const auto in = pcl::app::readCloud(cloud);
  ASSERT_EQ(in.size(), out.size());
  for (const char* field : {"surface", "edge"})
    EXPECT_EQ(pcl::app::labelsOf(in, field), pcl::app::labelsOf(out, field));
  expectSuccess(
      runApp("pcl_shape_evaluate",
             {path("out.pcd"), cloud, "-task", "instance", "-json", path("e")}));
  const Json evaluation = Json::parse(readFile(path("e")));
  EXPECT_EQ(evaluation["instances"]["true_positives"], 3);
  EXPECT_EQ(evaluation["instances"]["false_positives"], 0);
}

TEST_F(AppInstances, WithoutAPrimitiveThereIsNone)
{
  for (const Json& instance : reportOf(scene("cylinder"), {})["instances"])
    EXPECT_FALSE(instance.contains("primitive"));
}

TEST_F(AppInstances, MinPointsLeavesSmallOnesOut)
{
  const std::string cloud = scene("box,cylinder", "6");
  const auto usual = reportOf(cloud, {"-class", "planar"})["instances"];
  const auto large =
      reportOf(cloud, {"-class", "planar", "-min_points", "1500"})["instances"];
  ASSERT_FALSE(large.empty());
  EXPECT_LT(large.size(), usual.size());
  for (const Json& instance : large)
    EXPECT_GE(instance["points"], 1500);
}

TEST_F(AppInstances, ADirectoryIsProcessed)
{
  scene("cylinder");
  const Outcome outcome = runApp(
      app,
      {"-input_dir", path("."), "-output_dir", path("out"), "-json", path("json")});
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  const Json report = Json::parse(readFile(path("json")));
  EXPECT_GE(report["files"][0]["instances"].size(), 3U);
  EXPECT_TRUE(exists(path("out/scene.pcd")));
}

TEST_F(AppInstances, ACloudWithoutAnyIsNoError)
{
  const std::string plane = file("in.pcd", asciiCloud("x y z", "F F F", planeRows(40)));
  EXPECT_EQ(reportOf(plane, {})["instances"], Json::array());
  const auto labels = labelsIn("out.pcd");
  EXPECT_EQ(std::count(labels.begin(), labels.end(), 0U), 1600);
}

TEST_F(AppInstances, BadOptionsAreRefused)
{
  const std::string cloud = file("in.pcd", asciiCloud("x y z", "F F F", planeRows(20)));
  const std::string out = path("out.pcd");
  const auto refused = [&](Words options, const Words& words) {
    options.insert(options.begin(), {cloud, out});
    expectRefused(runApp(app, options), 2, words);
  };
  refused({"-class", "round"}, {"-class", "'round'", "planar, curved, object"});
  refused({"-high", "1.5"}, {"-high", "1.5", "0 to 1"});
  refused({"-high", "0.4", "-low", "0.6"}, {"-low", "0.6", "-high"});
  refused({"-min_points", "0"}, {"-min_points", "0"});
  refused({"-primitive", "cone"}, {"-primitive", "cone", "cylinder"});
  refused({"-radius", "0.1"}, {"-radius"});
  EXPECT_EQ(files(), std::vector<std::string>{"in.pcd"});
}

TEST_F(AppInstances, BadInputIsRefused)
{
  const std::string bad = file("bad.pcd", "no cloud");
  const std::string cloud = file("in.pcd", asciiCloud("x y z", "F F F", planeRows(20)));
  expectRefused(runApp(app, {bad, path("out.pcd"), "-json", path("json")}), 1, {bad});
  expectRefused(runApp(app, {cloud, path("out.pcd"), "-model", bad}), 1, {"bad.pcd"});
  const std::string plane = path("plane.json");
  expectSuccess(runApp("pcl_shape_histogram", {cloud, plane, "-radius", "0.02"}));
  expectRefused(runApp(app, {cloud, path("out.pcd"), "-model", plane}),
                1,
                {"plane.json", "two classes", "density"});
  EXPECT_EQ(files(), (std::vector<std::string>{"bad.pcd", "in.pcd", "plane.json"}));
}

TEST_F(AppInstances, ShapesOfASceneAreThoseAskedFor)
{
  const std::string cloud = scene("sphere", "2");
  const auto in = pcl::app::readCloud(cloud);
  const auto surface = pcl::app::labelsOf(in, "surface");
  const auto instance = pcl::app::labelsOf(in, "instance");
  for (std::size_t i = 0; i < surface.size(); ++i)
    EXPECT_FALSE(instance[i] > 0 && surface[i] == 1) << "a ball is nowhere planar";
  expectRefused(runApp("pcl_shape_scene", {path("s.pcd"), "-shapes", "box,ball"}),
                2,
                {"-shapes", "'box,ball'", "cylinder"});
  expectRefused(
      runApp("pcl_shape_scene", {path("s.pcd"), "-shapes", ""}), 2, {"-shapes"});
}

TEST_F(AppInstances, FacesAreWrittenWhenAskedFor)
{
  const std::string cloud = path("scene.pcd");
  expectSuccess(
      runApp("pcl_shape_scene", {cloud, "-faces", "-width", "64", "-height", "48"}));
  const auto faces = pcl::app::labelsOf(pcl::app::readCloud(cloud), "face");
  EXPECT_GT(*std::max_element(faces.begin(), faces.end()), 0U);
}

} // namespace
