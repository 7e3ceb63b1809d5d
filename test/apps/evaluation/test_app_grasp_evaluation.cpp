// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Grasps on plates and cylinders: on the object, square to it, without a hole.

#include "app_test.h"
#include "evaluation/grasps.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <filesystem>

using namespace pcl::app;
using namespace pcl_shape_test;

namespace {

constexpr float radius = 0.01f, height = 0.05f;
constexpr std::uint32_t table = 1, plate = 20, parts = 10;
constexpr std::uint64_t min_points = 300;

/** \brief A table and a plate above it, seen from above. */
struct Scene {
  pcl::PointCloud<pcl::PointXYZ> cloud;
  std::vector<std::uint32_t> labels;

  /** \param[in] is which of the points 1 mm apart there are \param[in] z their height
   */
  template <typename Is, typename Height>
  void
  add(std::uint32_t label, float half, const Is& is, const Height& z)
  {
    constexpr float step = 0.001f;
    const int steps = static_cast<int>(std::lround(half / step));
    for (int row = -steps; row <= steps; ++row)
      for (int column = -steps; column <= steps; ++column) {
        const float x = step * static_cast<float>(column),
                    y = step * static_cast<float>(row);
        if (!is(x, y))
          continue;
        cloud.emplace_back(x, y, z(x, y));
        labels.push_back(label);
      }
  }
};

/** \brief A square plate. \param[in] hole at x = 20 mm, radius of it */
Scene
plateScene(float half, float hole = 0.0f)
{
  Scene scene;
  const auto is_outside = [=](float x, float y) {
    return std::max(std::abs(x), std::abs(y)) > half;
  };
  scene.add(table, 0.06f, is_outside, [](float, float) { return 0.0f; });
  const auto is_in = [=](float x, float y) { return std::hypot(x - 0.02f, y) >= hole; };
  scene.add(plate, half, is_in, [](float, float) { return height; });
  return scene;
}

/** \brief Straight down unless it leans. */
ObjectGrasp
judged(const Scene& scene,
       const Vector& position,
       double lean_degrees = 0.0,
       double compliance = 0.2)
{
  const double lean = lean_degrees * M_PI / 180.0;
  const Vector approach{
      static_cast<float>(std::sin(lean)), 0.0f, static_cast<float>(-std::cos(lean))};
  Grasp grasp{position, approach, true};
  grasp.object = plate / parts;
  const auto all = evaluateGrasps(
      scene.cloud, scene.labels, {{grasp}, radius, compliance, parts}, min_points);
  EXPECT_EQ(1u, all.size());
  return all.empty() ? ObjectGrasp() : all.front();
}

TEST(GraspEvaluation, AGraspInTheMiddleOfAPlateIsRight)
{
  const ObjectGrasp of = judged(plateScene(0.03f), {0.0f, 0.0f, height});
  EXPECT_EQ(plate / parts, of.object);
  EXPECT_EQ(61u * 61u, of.points);
  EXPECT_TRUE(of.has_face && of.is_on_object && of.is_whole && of.isRight());
  EXPECT_NEAR(0.0, of.angle, 0.1);
}

TEST(GraspEvaluation, AHoleUnderTheCupIsSeen)
{
  const Scene scene = plateScene(0.04f, 0.003f);
  EXPECT_TRUE(judged(scene, {0.0f, 0.0f, height}).isRight());
  for (const float x : {0.012f, 0.016f, 0.02f}) {
    const ObjectGrasp of = judged(scene, {x, 0.0f, height});
    EXPECT_FALSE(of.is_whole || of.isRight()) << x;
    EXPECT_LT(of.angle, 1.0) << x;
  }
}

TEST(GraspEvaluation, ACupBeyondTheBorderIsNotOnTheObject)
{
  const Scene scene = plateScene(0.03f);
  EXPECT_TRUE(judged(scene, {0.019f, 0.0f, height}).isRight());
  const ObjectGrasp across = judged(scene, {0.026f, 0.0f, height});
  EXPECT_TRUE(across.is_on_object);
  EXPECT_FALSE(across.is_whole || across.isRight());
  const ObjectGrasp on_the_table = judged(scene, {0.045f, 0.0f, 0.0f});
  EXPECT_FALSE(on_the_table.is_on_object || on_the_table.isRight());
  EXPECT_TRUE(std::isnan(on_the_table.angle));
}

TEST(GraspEvaluation, AnApproachMustBeSquareToTheSurface)
{
  const Scene scene = plateScene(0.03f);
  EXPECT_TRUE(judged(scene, {0.0f, 0.0f, height}, 4.0).isRight());
  const ObjectGrasp of = judged(scene, {0.0f, 0.0f, height}, 6.0);
  EXPECT_NEAR(6.0, of.angle, 0.1);
  EXPECT_FALSE(of.isRight());
}

TEST(GraspEvaluation, AFaceHoldsADiscOfTwiceTheCupsArea)
{
  // Of a radius of 14 mm, and of no more than the two spacings that a hole may have.
  EXPECT_TRUE(judged(plateScene(0.015f), {0.0f, 0.0f, height}).has_face);
  EXPECT_FALSE(judged(plateScene(0.011f), {0.0f, 0.0f, height}).has_face);
  const auto isFaceOfCylinder = [](float of_radius, double compliance = 0.2) {
    Scene scene;
    const auto is_on = [=](float x, float) { return std::abs(x) < 0.95f * of_radius; };
    scene.add(plate, 0.03f, is_on, [=](float x, float) {
      return height + std::sqrt(of_radius * of_radius - x * x);
    });
    return judged(scene, {0.0f, 0.0f, height + of_radius}, 0.0, compliance).has_face;
  };
  EXPECT_TRUE(isFaceOfCylinder(0.035f)) << "1.4 mm in 10";
  EXPECT_FALSE(isFaceOfCylinder(0.035f, 0.1)) << "of a stiffer cup";
  EXPECT_FALSE(isFaceOfCylinder(0.02f)) << "2.5 mm in 10";
  EXPECT_TRUE(isFaceOfCylinder(0.02f, 0.3)) << "of a softer cup";
}

TEST(GraspEvaluation, OnlyTheFirstGraspOfAnObjectCounts)
{
  const Scene scene = plateScene(0.03f);
  const Vector down{0.0f, 0.0f, -1.0f};
  Grasp first{{0.0f, 0.0f, height}, down, false};
  first.object = plate / parts;
  first.problems = {"edge"};
  Grasp second = first;
  second.seals = true;
  Grasp other = second;
  other.object = 7;
  const auto evaluate = [&](const std::vector<Grasp>& grasps, std::uint64_t least) {
    return evaluateGrasps(
        scene.cloud, scene.labels, {grasps, radius, 0.2, parts}, least);
  };
  const auto all = evaluate({other, first, second}, min_points);
  ASSERT_EQ(1u, all.size());
  EXPECT_FALSE(all.front().isRight());
  EXPECT_TRUE(evaluate({first}, 61 * 61 + 1).empty());
  const auto none = evaluate({}, min_points);
  ASSERT_EQ(1u, none.size());
  EXPECT_TRUE(none.front().has_face);
  EXPECT_FALSE(none.front().first || none.front().isRight());
}

class GraspTask : public AppTest {
protected:
  /** \brief A plane z = 1 m of 20 cm, points 5 mm apart; label 11 where x < 0.1 m. */
  std::string
  plane() const
  {
    std::vector<std::string> rows = planeRows(40);
    for (std::string& row : rows)
      row += std::stod(row) < 0.1 ? " 11" : " 20";
    return file("in.pcd", asciiCloud("x y z label", "F F F U", rows));
  }
};

/** \brief Without the member that is left out. */
std::string
reportOf(const std::string& grasp, const std::string& left_out = "")
{
  nlohmann::json json = {
      {"parameters",
       {{"each", "label"}, {"parts", 10}, {"cup_radius", 0.02}, {"compliance", 0.2}}},
      {"grasps", nlohmann::json::array()}};
  json["parameters"].erase(left_out);
  if (!grasp.empty())
    json["grasps"].push_back(nlohmann::json::parse(grasp));
  return json.dump();
}

TEST_F(GraspTask, JudgesWhatTheOtherAppWrote)
{
  const std::string cloud = plane(), grasps = path("grasps.json");
  expectSuccess(runApp("pcl_shape_grasp",
                       {cloud,
                        "-each",
                        "label",
                        "-parts",
                        "10",
                        "-cup_radius",
                        "0.02",
                        "-max_grasps",
                        "2",
                        "-json",
                        grasps}));
  const auto written = nlohmann::json::parse(readFile(grasps));
  EXPECT_EQ(2, written["counts"]["objects"]);
  EXPECT_EQ(1600, written["counts"]["target_points"]);
  EXPECT_EQ("label", written["parameters"]["each"]);
  EXPECT_EQ(10, written["parameters"]["parts"]);
  EXPECT_EQ(1, written["grasps"][0]["object"]);
  const auto outcome = runApp(
      "pcl_shape_evaluate", {grasps, cloud, "-task", "grasps", "-json", path("json")});
  expectSuccess(outcome);
  EXPECT_NE(std::string::npos,
            outcome.out.find("objects 2, with a face for the cup 2, of these with a "
                             "right first grasp 2"));
  const auto report = nlohmann::json::parse(readFile(path("json")));
  EXPECT_EQ(2, report["counts"]["right"]);
  EXPECT_EQ(10, report["parameters"]["parts"]) << "of the grasps";
  EXPECT_EQ(0.2, report["parameters"]["compliance"]);
  ASSERT_EQ(2u, report["objects"].size());
  EXPECT_EQ(800, report["objects"][1]["points"]);
  EXPECT_EQ("seals", report["objects"][1]["first_grasp"]);
  EXPECT_LT(report["objects"][1]["angle_degrees"], 0.1);
}

TEST_F(GraspTask, RefusesWhatItCannotJudge)
{
  const std::string cloud = plane();
  const auto evaluate = [&](const std::string& grasps, const Words& options) {
    Words words{grasps, cloud, "-task", "grasps", "-json", path("json")};
    words.insert(words.end(), options.begin(), options.end());
    return runApp("pcl_shape_evaluate", words);
  };
  const std::string good = file("good.json", reportOf(""));
  expectSuccess(evaluate(good, {"-parts", "10"}));
  std::filesystem::remove(path("json"));
  expectRefused(evaluate(cloud, {}), 1, {cloud, "no JSON object"});
  expectRefused(evaluate(file("none.json", "{}"), {}), 1, {"none.json", "'grasps'"});
  for (const char* member : {"each", "parts", "cup_radius", "compliance"})
    expectRefused(evaluate(file("less.json", reportOf("", member)), {}),
                  1,
                  {"less.json", "parameters." + std::string(member), "missing"});
  std::string other = reportOf("");
  other.replace(other.find("label"), 5, "instance");
  expectRefused(evaluate(file("other.json", other), {}),
                1,
                {"other.json", "'instance'", cloud, "'label'", "-each label"});
  const std::string place =
      R"("seals": true, "position": [0, 0, 1], "approach": [0, 0, 1])";
  expectRefused(evaluate(file("bad.json", reportOf("{" + place + "}")), {}),
                1,
                {"bad.json", "grasps[0].object", "missing"});
  for (const char* object : {"-1", "0"})
    expectRefused(evaluate(file("bad.json",
                                reportOf(R"({"object": )" + std::string(object) + ", " +
                                         place + "}")),
                           {}),
                  1,
                  {"bad.json", "object", "whole number"});
  expectRefused(evaluate(good, {"-parts", "1"}), 1, {good, "'10'", "-parts is '1'"});
  expectRefused(evaluate(good, {"-min_points", "1601"}), 1, {cloud, "1601 points"});
  expectRefused(evaluate(good, {"-convention", "paper"}), 2, {"-convention", "grasps"});
  expectRefused(evaluate(good, {"-out", path("o.pcd")}), 2, {"-out", "grasps"});
  EXPECT_FALSE(exists(path("json")));
  expectRefused(
      runApp("pcl_shape_grasp", {cloud, "-each", "label", "-box", "0,0,0,1,1,2"}),
      2,
      {"-each", "-box", "only one"});
  expectRefused(runApp("pcl_shape_grasp", {cloud, "-parts", "10"}),
                2,
                {"-parts '10' without -each", "expected -each"});
  expectRefused(runApp("pcl_shape_grasp", {cloud, "-each", "label", "-parts", "100"}),
                1,
                {cloud, "label", "100", "no finite point"});
}

} // namespace
