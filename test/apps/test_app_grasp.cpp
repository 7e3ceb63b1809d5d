// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// pcl_shape_grasp: its output, its options and what it refuses.

// pcl_shape_grasp

#include "app_test.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cmath>

using namespace pcl_shape_test;
using Json = nlohmann::json;

namespace {

const char* const app = "pcl_shape_grasp";

class AppGrasp : public AppTest {
protected:
  /** \brief A plane z = 1 m of 20 cm, points 5 mm apart; `label` is 1 where x < 0.1 m.
   */
  std::string
  plane() const
  {
    std::vector<std::string> rows = planeRows(40);
    for (std::string& row : rows)
      row += std::stod(row) < 0.1 ? " 1" : " 2";
    return file("in.pcd", asciiCloud("x y z label", "F F F U", rows));
  }

  Json
  graspsOf(Words words) const
  {
    words.insert(words.end(), {"-json", path("json"), "-cup_radius", "0.02"});
    expectSuccess(runApp(app, words));
    return Json::parse(readFile(path("json")));
  }
};

TEST_F(AppGrasp, WritesGraspsWithWhatTheyAreJudgedBy)
{
  const Json report = graspsOf({plane()});
  EXPECT_EQ(report["app"], app);
  EXPECT_EQ(report["parameters"]["cup_radius"], 0.02);
  EXPECT_EQ(report["parameters"]["max_grasps"], 10);
  EXPECT_EQ(report["parameters"]["viewpoint"], "0,0,0");
  EXPECT_FALSE(report["parameters"].contains("field"));
  EXPECT_FALSE(report["parameters"].contains("box"));
  EXPECT_EQ(report["counts"]["target_points"], 1600);
  EXPECT_EQ(report["counts"]["grasps"], report["grasps"].size());
  ASSERT_FALSE(report["grasps"].empty());
  double previous = 1.0;
  std::uint64_t sealing = 0;
  for (const Json& grasp : report["grasps"]) {
    EXPECT_NEAR(grasp["position"][2], 1.0, 1e-4);
    EXPECT_NEAR(grasp["approach"][2], 1.0, 1e-4) << "away from the viewpoint";
    EXPECT_LE(grasp["score"], previous);
    EXPECT_EQ(grasp["seals"], grasp["problems"].empty());
    EXPECT_EQ(grasp["surface"], "planar");
    EXPECT_LE(grasp["convergence"]["iterations"], 100);
    for (const char* name : {"likelihood",
                             "covered",
                             "border_distance",
                             "edge_distance",
                             "obstacle_distance",
                             "margin",
                             "sag",
                             "residual",
                             "residual_allowed"})
      EXPECT_TRUE(grasp[name].is_number()) << name;
    previous = grasp["score"];
    sealing += grasp["seals"].get<bool>() ? 1 : 0;
  }
  EXPECT_EQ(report["grasps"][0]["seals"], true);
  EXPECT_EQ(report["counts"]["sealing"], sealing);
}

TEST_F(AppGrasp, KeepsToTheSelectedPoints)
{
  const std::string cloud = plane();
  for (const auto& [value, sign] : {std::pair{"1", 1.0}, std::pair{"2", -1.0}}) {
    const Json report = graspsOf({cloud, "-field", "label", "-value", value});
    EXPECT_EQ(report["counts"]["target_points"], 800);
    EXPECT_EQ(report["parameters"]["field"], "label");
    EXPECT_EQ(report["parameters"]["value"], std::stoi(value));
    ASSERT_EQ(report["grasps"][0]["seals"], true);
    for (const Json& grasp : report["grasps"])
      EXPECT_LT(sign * grasp["position"][0].get<double>(), sign * 0.1);
  }
  const Json boxed = graspsOf({cloud, "-box", "-1,0.1,0,1,1,2"});
  EXPECT_EQ(boxed["parameters"]["box"], "-1,0.1,0,1,1,2");
  ASSERT_EQ(boxed["grasps"][0]["seals"], true);
  EXPECT_GT(boxed["grasps"][0]["position"][1], 0.12);
}

TEST_F(AppGrasp, TakesAViewpointAndAsManyGraspsAsAskedFor)
{
  const Json report =
      graspsOf({plane(), "-viewpoint", "0.1,0.1,2", "-max_grasps", "1"});
  EXPECT_EQ(report["parameters"]["viewpoint"], "0.1,0.1,2");
  EXPECT_EQ(report["parameters"]["max_grasps"], 1);
  ASSERT_EQ(report["grasps"].size(), 1U);
  EXPECT_NEAR(report["grasps"][0]["approach"][2], -1.0, 1e-4);
  EXPECT_TRUE(graspsOf({plane(), "-surface", "curved"})["grasps"].empty());
}

TEST_F(AppGrasp, DoesNotDependOnThreads)
{
  const std::string cloud = plane();
  EXPECT_EQ(graspsOf({cloud, "-threads", "1"})["grasps"],
            graspsOf({cloud, "-threads", "3"})["grasps"]);
}

TEST_F(AppGrasp, RefusesABadCommandLine)
{
  const std::string cloud = plane();
  const std::vector<std::pair<Words, Words>> bad = {
      {{"-cup_radius", "0"}, {"-cup_radius", "positive"}},
      {{"-cup_radius", "nan"}, {"-cup_radius", "positive"}},
      {{"-compliance", "1.5"}, {"-compliance", "0 to 1"}},
      {{"-max_grasps", "0"}, {"-max_grasps"}},
      {{"-surface", "round"}, {"-surface", "planar", "curved"}},
      {{"-field", "label"}, {"-field", "-value", "both"}},
      {{"-value", "1"}, {"-field", "-value", "both"}},
      {{"-field", "label", "-value", "-1"}, {"-value"}},
      {{"-box", "0,0,0,1,1"}, {"-box", "six numbers"}},
      {{"-box", "0,0,0,1,1,x"}, {"-box", "six numbers"}},
      {{"-box", "0,0,0,1,1,1,1"}, {"-box", "six numbers"}},
      {{"-box", "0,0,0,1,0,1"}, {"-box", "below"}},
      {{"-box", "0,0,0,1,1,1,x"}, {"-box", "six numbers"}},
      {{"-viewpoint", "1,2"}, {"-viewpoint", "three numbers"}},
      {{"-viewpoint", "1,2,3,"}, {"-viewpoint", "three numbers"}},
      {{"-json", cloud}, {"-json", cloud, "another file"}},
      {{"-cup", "1"}, {"-cup"}}};
  for (const auto& [options, words] : bad) {
    Words all{cloud};
    all.insert(all.end(), options.begin(), options.end());
    expectRefused(runApp(app, all), 2, words);
  }
  expectRefused(runApp(app, {}), 2, {"in.pcd"});
  EXPECT_EQ(files(), std::vector<std::string>{"in.pcd"});
}

TEST_F(AppGrasp, RefusesBadInputAndLeavesNoFile)
{
  const std::string cloud = plane(), json = path("json");
  const std::vector<std::pair<Words, Words>> bad = {
      {{path("missing.pcd")}, {"missing.pcd"}},
      {{file("bad.pcd", "no cloud")}, {"bad.pcd"}},
      {{cloud, "-field", "instance", "-value", "1"}, {cloud, "instance"}},
      {{cloud, "-field", "label", "-value", "3"},
       {cloud, "label", "3", "no finite point"}},
      {{cloud, "-box", "5,5,5,6,6,6"}, {cloud, "-box", "no finite point"}}};
  for (const auto& [words, parts] : bad) {
    Words all = words;
    all.insert(all.end(), {"-json", json});
    expectRefused(runApp(app, all), 1, parts);
    EXPECT_FALSE(exists(json));
  }
  const Outcome small = runApp(app, {cloud, "-cup_radius", "0.0000001", "-json", json});
  EXPECT_EQ(small.status, 1);
  for (const std::string& part :
       {cloud, std::string("cup radius is 1e-07 m"), std::string("too sparse")})
    EXPECT_NE(small.err.find(part), std::string::npos) << part;
  EXPECT_FALSE(exists(json));
}

} // namespace
