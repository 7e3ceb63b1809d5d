// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Parts, rooms and depth cameras of pcl_shape_scene.

#include "app_test.h"
#include "io/cloud_file.h"
#include "io/pcd.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>

namespace {

using namespace pcl::app;
using namespace pcl_shape_test;
using Json = nlohmann::json;

class AppWorlds : public AppTest {
protected:
  CloudFile
  make(const Words& options) const
  {
    Words arguments{path("out.pcd"), "-seed", "3", "-json", path("json")};
    arguments.insert(arguments.end(), options.begin(), options.end());
    expectSuccess(runApp("pcl_shape_scene", arguments));
    return readCloud(path("out.pcd"));
  }

  void
  expectRefusal(const Words& options, const Words& says) const
  {
    Words arguments{path("out.pcd")};
    arguments.insert(arguments.end(), options.begin(), options.end());
    expectRefused(runApp("pcl_shape_scene", arguments), 2, says);
  }
};

TEST_F(AppWorlds, PartsHaveTheirTruthInSpacings)
{
  for (const std::string sensor : {"samples", "photogrammetry"}) {
    const CloudFile cloud = make(
        {"-place", "part", "-sensor", sensor, "-size", "0.2", "-sampling", "0.005"});
    const auto edge = labelsOf(cloud, "edge");
    const auto crease = floatsOf(cloud, "crease_s");
    ASSERT_GT(edge.size(), 500u);
    EXPECT_GT(std::count(edge.begin(), edge.end(), 1u), 100);
    for (std::size_t i = 0; i < edge.size(); ++i)
      ASSERT_TRUE(edge[i] != 1u || crease[i] < 1.5f);
    EXPECT_EQ(floatsOf(cloud, "radius_s").size(), edge.size());
    EXPECT_EQ(floatsOf(cloud, "thin_s").size(), edge.size());
    const Json json = Json::parse(readFile(path("json")));
    EXPECT_EQ(json["parameters"]["sensor"], sensor);
    EXPECT_EQ(json["parameters"]["size"], 0.2);
  }
}

TEST_F(AppWorlds, NoiseAndSpreadChangeThePointsOnly)
{
  const Words part{"-place", "part", "-sampling", "0.005"};
  Words noisy = part, random = part;
  noisy.insert(noisy.end(), {"-noise", "0.001"});
  random.insert(random.end(), {"-spread", "random"});
  const CloudFile exact = make(part);
  const CloudFile with_noise = make(noisy);
  EXPECT_EQ(labelsOf(exact, "edge"), labelsOf(with_noise, "edge"));
  EXPECT_NE(floatsOf(exact, "x"), floatsOf(with_noise, "x"));
  EXPECT_NE(floatsOf(exact, "x"), floatsOf(make(random), "x"));
}

TEST_F(AppWorlds, DepthCamerasSeeTablesBinsAndParts)
{
  for (const std::string sensor : {"stereo", "tof", "structured"})
    for (const std::string place : {"table", "bin", "part"}) {
      const CloudFile cloud = make({"-sensor",
                                    sensor,
                                    "-place",
                                    place,
                                    "-width",
                                    "160",
                                    "-height",
                                    "120",
                                    "-organized",
                                    "-waviness",
                                    "0.001,0.03"});
      EXPECT_EQ(cloud.blob.width, 160u);
      const auto instance = labelsOf(cloud, "instance");
      EXPECT_EQ(*std::max_element(instance.begin(), instance.end()),
                place == "part" ? 3u : 8u);
      const Json json = Json::parse(readFile(path("json")));
      EXPECT_EQ(json["parameters"]["sensor"], sensor);
      EXPECT_EQ(json["parameters"]["waviness"], 0.001);
      EXPECT_EQ(json["parameters"]["wave_length"], 0.03);
    }
}

TEST_F(AppWorlds, StationsScanARoom)
{
  const Words options{"-sensor", "station", "-place", "room", "-step", "2"};
  const std::size_t one = labelsOf(make(options), "edge").size();
  EXPECT_EQ(one, 180u * 75u);
  Words two = options;
  two.insert(two.end(), {"-stations", "2"});
  EXPECT_EQ(labelsOf(make(two), "edge").size(), 2 * one);
  const CloudFile front =
      make({"-sensor", "station", "-place", "facade", "-step", "2"});
  EXPECT_LT(labelsOf(front, "edge").size(), one) << "rays to the sky do not return";
  EXPECT_EQ(Json::parse(readFile(path("json")))["parameters"]["place"], "facade");
}

TEST_F(AppWorlds, OptionsOfOthersAreRefused)
{
  expectRefusal({"-sensor", "stereo", "-noise", "0.01"},
                {"-noise", "stereo", "expected"});
  expectRefusal({"-waviness", "0.001,0.02"}, {"-waviness", "camera", "stereo"});
  expectRefusal({"-sensor", "tof", "-waviness", "0.001"}, {"-waviness", "two numbers"});
  expectRefusal({"-sensor", "tof", "-waviness", "1,1"}, {"-waviness", "0.01"});
  expectRefusal({"-place", "room"}, {"-place", "room", "-sensor station"});
  expectRefusal({"-sensor", "station"}, {"table", "-place room"});
  expectRefusal({"-sensor", "photogrammetry"}, {"table", "-place part"});
  expectRefusal({"-place", "bin", "-sampling", "0.002"}, {"-place", "a camera"});
  expectRefusal({"-place", "bin", "-sensor", "samples"}, {"-place", "a camera"});
  expectRefusal({"-place", "bin", "-sensor", "photogrammetry"}, {"-place part"});
  expectRefusal({"-place", "part", "-shapes", "box"}, {"-shapes", "-place table"});
  expectRefusal({"-size", "0.1"}, {"-size", "-place part"});
  expectRefusal({"-fillers"}, {"-fillers", "-sensor lidar"});
  expectRefusal({"-sampling", "0.01", "-organized"}, {"-organized", "-sampling"});
  expectRefusal({"-stations", "2"}, {"-stations", "-sensor station"});
  expectRefusal({"-place", "part", "-sampling", "0.05"}, {"-sampling", "1/10"});
  expectRefusal({"-place", "part", "-sensor", "samples", "-spread", "odd"},
                {"-spread", "even"});
  expectRefusal({"-sensor", "station", "-place", "room", "-stations", "5"},
                {"-stations", "4"});
  expectRefusal({"-sensor", "samples", "-width", "64"},
                {"-width '64' with -sensor 'samples'", "camera, stereo, tof or"});
  expectRefusal({"-sensor", "samples", "-noise", "kinect"},
                {"-noise 'kinect'", "none", "-sensor 'samples'"});
  for (const std::string option : {"-stations", "-step"})
    expectRefusal({"-sensor", "lidar", option, "1"},
                  {option, "lidar", "expected it with -sensor station"});
  for (const std::string option : {"-size", "-spread"})
    expectRefusal({"-sensor", "lidar", option, "1"},
                  {option, "expected it with -place part and -sensor samples"});
  expectRefusal({"-sensor", "lidar", "-waviness", "0.001,0.02"},
                {"-waviness", "expected it with -sensor stereo, tof or structured"});
  expectRefusal(
      {"-sensor", "station", "-place", "room", "-seed", "1483", "-stations", "3"},
      {"-stations '3'", "room of -seed 1483", "places for 2"});
}

} // namespace
