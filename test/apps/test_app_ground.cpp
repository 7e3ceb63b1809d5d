// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// pcl_shape_ground, and streets of pcl_shape_scene.

#include "app_test.h"
#include "io/cloud_file.h"
#include "io/pcd.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>

using namespace pcl::app;
using namespace pcl_shape_test;
using Json = nlohmann::json;

namespace {

const char* const app = "pcl_shape_ground";

class AppGround : public AppTest {
protected:
  std::string
  street(const std::string& seed = "401", const std::string& beams = "16") const
  {
    std::string street = path("street.pcd");
    expectSuccess(runApp("pcl_shape_scene",
                         {street, "-sensor", "lidar", "-seed", seed, "-beams", beams}));
    return street;
  }

  double
  f1(const std::string& predicted, const std::string& truth) const
  {
    expectSuccess(
        runApp("pcl_shape_evaluate",
               {predicted, truth, "-task", "ground", "-json", path("score")}));
    return Json::parse(readFile(path("score")))["classes"]["ground"]["f1"];
  }
};

TEST_F(AppGround, FindsTheGroundOfAStreet)
{
  for (const std::string beams : {"16", "64"}) {
    const std::string in = street("401", beams);
    expectSuccess(runApp(app, {in, path("out.pcd")}));
    // Its own truth was replaced by what was found.
    EXPECT_GE(f1(path("out.pcd"), in), 0.97) << beams;
  }
}

TEST_F(AppGround, WritesWhatItFinds)
{
  const std::string in = street();
  expectSuccess(runApp(app, {in, path("out.pcd"), "-json", path("json")}));
  const CloudFile cloud = readCloud(path("out.pcd"));
  const auto ground = labelsOf(cloud, "ground");
  const auto likelihood = floatsOf(cloud, "ground_likelihood");
  EXPECT_NE(findField(cloud, "ring"), nullptr) << "fields of the input are kept";
  for (std::size_t i = 0; i < ground.size(); ++i)
    ASSERT_EQ(ground[i], likelihood[i] >= 0.5f);
  const Json json = Json::parse(readFile(path("json")));
  EXPECT_EQ(json["counts"]["ground"], std::count(ground.begin(), ground.end(), 1u));
  EXPECT_EQ(json["parameters"]["up"], "0,0,1");
  EXPECT_EQ(json["parameters"]["max_step"], 0.2f);
}

TEST_F(AppGround, ThreadsDoNotMatter)
{
  const std::string in = street();
  expectSuccess(runApp(app, {in, path("one.pcd"), "-threads", "1"}));
  expectSuccess(runApp(app, {in, path("two.pcd"), "-threads", "2"}));
  EXPECT_EQ(readFile(path("one.pcd")), readFile(path("two.pcd")));
}

TEST_F(AppGround, AThresholdOfNothingTakesAll)
{
  const std::string in = street();
  expectSuccess(runApp(app, {in, path("out.pcd"), "-threshold", "0"}));
  const auto ground = labelsOf(readCloud(path("out.pcd")), "ground");
  EXPECT_EQ(std::count(ground.begin(), ground.end(), 0u), 0);
}

TEST_F(AppGround, WithoutGroundItWarns)
{
  // An upright plane: x = 1.
  std::vector<std::string> rows;
  for (int y = 0; y < 40; ++y)
    for (int z = 0; z < 40; ++z)
      rows.push_back("1 " + std::to_string(0.01 * y) + ' ' + std::to_string(0.01 * z));
  const std::string in = file("wall.pcd", asciiCloud("x y z", "F F F", rows));
  const Outcome outcome = runApp(app, {in, path("out.pcd")});
  EXPECT_EQ(outcome.status, 0);
  EXPECT_NE(outcome.err.find("no ground was found"), std::string::npos) << outcome.err;
  const auto ground = labelsOf(readCloud(path("out.pcd")), "ground");
  EXPECT_EQ(std::count(ground.begin(), ground.end(), 0u), 1600);
}

TEST_F(AppGround, OfATiltedScanItWarns)
{
  // A road seen by a sensor that leans by 45 degrees, and a few points that are level.
  const auto row = [](double x, double y, double z) {
    return std::to_string(x) + ' ' + std::to_string(y) + ' ' + std::to_string(z);
  };
  std::vector<std::string> rows;
  for (int i = 0; i < 100; ++i)
    for (int k = 0; k < 100; ++k)
      rows.push_back(row(0.1 * i, 0.1 * k, 5.0 + 0.1 * i));
  for (int i = 0; i < 81; ++i)
    rows.push_back(row(-0.5 - 0.3 * (i % 9), 0.3 * (i / 9), -2.0));
  const std::string in = file("tilted.pcd", asciiCloud("x y z", "F F F", rows));
  const std::string out = path("out.pcd");
  const Outcome level = runApp(app, {in, out});
  EXPECT_NE(level.err.find("very little ground was found; is -up 0,0,1 right?"),
            std::string::npos)
      << level.err;
  const Outcome right = runApp(app, {in, out, "-up", "-0.7071,0,0.7071"});
  EXPECT_EQ(right.err, "");
}

TEST_F(AppGround, UpIsAnOption)
{
  const std::string in =
      file("plane.pcd", asciiCloud("x y z", "F F F", planeRows(100)));
  expectSuccess(runApp(app, {in, path("up.pcd")}));
  EXPECT_EQ(runApp(app, {in, path("side.pcd"), "-up", "0,-1,0"}).status, 0);
  const auto up = labelsOf(readCloud(path("up.pcd")), "ground");
  const auto side = labelsOf(readCloud(path("side.pcd")), "ground");
  EXPECT_EQ(std::count(up.begin(), up.end(), 1u), 10000);
  EXPECT_EQ(std::count(side.begin(), side.end(), 1u), 0);
}

TEST_F(AppGround, BadOptionsAreRefused)
{
  const std::string in = file("plane.pcd", asciiCloud("x y z", "F F F", planeRows(10)));
  const std::string out = path("out.pcd");
  for (const std::string up : {"0,0,0", "1,2", "1,2,3,4", "a,b,c", "0,0,nan", "0,0,1,"})
    expectRefused(runApp(app, {in, out, "-up", up}), 2, {"-up", up, "expected"});
  for (const std::string slope : {"0", "90", "x"})
    expectRefused(
        runApp(app, {in, out, "-max_slope", slope}), 2, {"max_slope", "expected"});
  expectRefused(runApp(app, {in, out, "-max_step", "0"}), 2, {"max_step", "expected"});
  expectRefused(
      runApp(app, {in, out, "-threshold", "2"}), 2, {"threshold", "expected"});
  for (const std::string height : {"0", "-1", "x"})
    expectRefused(runApp(app, {in, out, "-sensor_height", height}),
                  2,
                  {"sensor_height", "expected"});
  expectRefused(runApp(app, {in, out, "-radius", "1"}), 2, {"radius"});
  EXPECT_EQ(files(), Words{"plane.pcd"});
}

TEST_F(AppGround, BadCloudsAreRefused)
{
  const std::string nan =
      file("nan.pcd", asciiCloud("x y z", "F F F", {"nan nan nan", "nan 0 0"}));
  expectRefused(runApp(app, {nan, path("out.pcd")}), 1, {"nan.pcd", "finite"});
  EXPECT_EQ(files(), Words{"nan.pcd"});
}

TEST_F(AppGround, AirborneScansDoNotBreakIt)
{
  if (std::string(PCL_SHAPE_TEST_DATA).empty())
    GTEST_SKIP() << "PCL_SHAPE_TEST_DATA is not set";
  const std::string in =
      std::string(PCL_SHAPE_TEST_DATA) + "/unlabelled/samp11-utm.pcd";
  expectSuccessOrWarnings(runApp(app, {in, path("out.pcd")}));
  for (const float likelihood :
       floatsOf(readCloud(path("out.pcd")), "ground_likelihood"))
    ASSERT_TRUE(likelihood >= 0.0f && likelihood <= 1.0f);
}

TEST_F(AppGround, TheCeilingOfAGarageIsNoGround)
{
  const std::string in = path("garage.pcd");
  expectSuccess(runApp("pcl_shape_scene",
                       {in,
                        "-sensor",
                        "lidar",
                        "-place",
                        "garage",
                        "-beams",
                        "16",
                        "-seed",
                        "411",
                        "-fillers"}));
  expectSuccess(runApp(app, {in, path("out.pcd")}));
  EXPECT_GE(f1(path("out.pcd"), in), 0.97);
}

TEST_F(AppGround, TheHeightOfTheSensorIsAnOption)
{
  const std::string in =
      file("plane.pcd", asciiCloud("x y z", "F F F", planeRows(100)));
  const auto found = [&](const Words& height) {
    Words arguments{in, path("out.pcd")};
    arguments.insert(arguments.end(), height.begin(), height.end());
    EXPECT_EQ(runApp(app, arguments).status, 0);
    const auto ground = labelsOf(readCloud(path("out.pcd")), "ground");
    return std::count(ground.begin(), ground.end(), 1u);
  };
  EXPECT_EQ(found({}), 10000) << "what is 1 m up is not known to be above a sensor";
  EXPECT_EQ(found({"-sensor_height", "1"}), 0) << "it is above the sensor";
}

TEST_F(AppGround, AGivenGarageHasGround)
{
  if (std::string(PCL_SHAPE_TEST_DATA).empty())
    GTEST_SKIP() << "PCL_SHAPE_TEST_DATA is not set";
  const std::string in =
      std::string(PCL_SHAPE_TEST_DATA) + "/faults/garage_16_beams.pcd";
  expectSuccess(runApp(app, {in, path("out.pcd")}));
  EXPECT_GE(f1(path("out.pcd"), in), 0.99);
}

TEST_F(AppGround, StreetsAreReproducible)
{
  const std::string first = readFile(street("402"));
  EXPECT_EQ(first, readFile(street("402")));
  EXPECT_NE(first, readFile(street("403")));
}

TEST_F(AppGround, StreetsHaveTheirTruth)
{
  expectSuccess(runApp("pcl_shape_scene",
                       {path("s.pcd"),
                        "-sensor",
                        "lidar",
                        "-beams",
                        "16",
                        "-noise",
                        "none",
                        "-normals",
                        "-json",
                        path("json")}));
  const CloudFile cloud = readCloud(path("s.pcd"));
  const auto ground = labelsOf(cloud, "ground"), ring = labelsOf(cloud, "ring");
  const auto instance = labelsOf(cloud, "instance"),
             surface = labelsOf(cloud, "surface");
  const auto normal_z = floatsOf(cloud, "normal_z");
  for (std::size_t i = 0; i < ground.size(); ++i) {
    ASSERT_EQ(instance[i] == 0, ground[i] != 0);
    ASSERT_LT(ring[i], 16u);
    ASSERT_TRUE(surface[i] == 1 || surface[i] == 2);
    ASSERT_EQ(ground[i] == 1, instance[i] == 0 && normal_z[i] > 0.5f);
  }
  const Json json = Json::parse(readFile(path("json")));
  EXPECT_EQ(json["counts"]["ground"], std::count(ground.begin(), ground.end(), 1u));
  EXPECT_EQ(json["counts"]["curb"], std::count(ground.begin(), ground.end(), 255u));
  EXPECT_EQ(json["parameters"]["beams"], 16);
}

TEST_F(AppGround, OptionsOfOtherSensorsAreRefused)
{
  const std::string scene = "pcl_shape_scene", out = path("out.pcd");
  for (const Words& camera : {Words{"-width", "320"},
                              Words{"-height", "240"},
                              Words{"-objects", "3"},
                              Words{"-sampling", "0.01"},
                              Words{"-organized"}}) {
    Words arguments{out, "-sensor", "lidar"};
    arguments.insert(arguments.end(), camera.begin(), camera.end());
    expectRefused(runApp(scene, arguments), 2, {camera.front(), "lidar", "expected"});
  }
  expectRefused(runApp(scene, {out, "-beams", "16"}), 2, {"-beams", "-sensor lidar"});
  expectRefused(
      runApp(scene, {out, "-sensor", "lidar", "-beams", "33"}), 2, {"beams", "64, 16"});
  expectRefused(runApp(scene, {out, "-place", "hall"}), 2, {"-place", "-sensor lidar"});
  expectRefused(runApp(scene, {out, "-fillers"}), 2, {"-fillers", "-sensor lidar"});
  expectRefused(
      runApp(scene, {out, "-sensor", "lidar", "-place", "moon"}), 2, {"place", "town"});
  expectRefused(
      runApp(scene, {out, "-sensor", "lidar", "-pattern", "rosette70", "-beams", "16"}),
      2,
      {"-beams", "-pattern turn"});
  expectRefused(runApp(scene, {out, "-sensor", "radar"}), 2, {"sensor", "camera"});
  for (const std::string noise : {"kinect", "-1", "0.2"})
    expectRefused(runApp(scene, {out, "-sensor", "lidar", "-noise", noise}),
                  2,
                  {"-noise", noise, "expected"});
  EXPECT_TRUE(files().empty());
}

} // namespace
