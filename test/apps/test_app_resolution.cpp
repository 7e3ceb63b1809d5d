// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// -resolution of the apps.

#include "app_test.h"

#include <nlohmann/json.hpp>

#include <filesystem>

// The option -resolution of all apps that work in the default mode.
namespace {

using namespace pcl_shape_test;
using Json = nlohmann::json;

class ResolutionOption : public AppTest {
protected:
  ResolutionOption() : scene(path("scene.pcd"))
  {
    expectSuccess(runApp(
        "pcl_shape_scene",
        {scene, "-seed", "6", "-objects", "3", "-width", "960", "-height", "720"}));
  }

  Json
  run(const std::string& app, Words words)
  {
    words.insert(words.end(), {"-json", path("json")});
    expectSuccess(runApp(app, words));
    return Json::parse(readFile(path("json")));
  }

  double
  f1(const std::string& predicted, const std::string& task)
  {
    return run("pcl_shape_evaluate",
               {predicted, scene, "-task", task})["classes"][task]["f1"];
  }

  /** \brief The library says why, then the app which file. */
  static void
  expectFailure(const Outcome& outcome, const Words& words)
  {
    EXPECT_EQ(outcome.status, 1);
    for (const std::string& word : words)
      EXPECT_NE(outcome.err.find(word), std::string::npos) << outcome.err;
  }

  const std::string scene;
};

TEST_F(ResolutionOption, LargerRadiiAreCurved)
{
  const Words own{scene, path("own.pcd")};
  const Words coarse{scene, path("coarse.pcd"), "-resolution", "0.0025"};
  const Json of_own = run("pcl_shape_back_projection", own);
  const Json of_coarse = run("pcl_shape_back_projection", coarse);
  EXPECT_EQ(of_own["parameters"]["resolution"], 0.0);
  EXPECT_EQ(of_coarse["parameters"]["resolution"], 0.0025);
  EXPECT_GT(of_coarse["largest_curved_radius"],
            1.3 * of_own["largest_curved_radius"].get<double>());
  EXPECT_EQ(of_coarse["counts"]["unknown"], 0);
  EXPECT_GE(f1(path("coarse.pcd"), "curved"), 0.95);
}

TEST_F(ResolutionOption, TheSummarySaysWhatIsCurved)
{
  const Outcome outcome = runApp("pcl_shape_back_projection", {scene, path("out.pcd")});
  expectSuccess(outcome);
  EXPECT_NE(outcome.out.find(", curved up to a radius of 0.7"), std::string::npos)
      << outcome.out;
  const Json paper =
      run("pcl_shape_back_projection", {scene, path("out.pcd"), "-mode", "paper"});
  EXPECT_FALSE(paper.contains("largest_curved_radius"));
}

TEST_F(ResolutionOption, OfEdgesLabelsInstancesAndGrasps)
{
  const std::string out = path("out.pcd");
  const Words option{"-resolution", "0.003"};
  const auto with = [&](Words words) {
    words.insert(words.end(), option.begin(), option.end());
    return words;
  };
  EXPECT_EQ(
      run("pcl_shape_edge_detection", with({scene, out}))["parameters"]["resolution"],
      0.003);
  EXPECT_GE(f1(out, "edge"), 0.7);
  const Json labels = run("pcl_shape_label", with({scene, out}));
  EXPECT_EQ(labels["parameters"]["resolution"], 0.003);
  EXPECT_GT(labels["counts"]["curved"], 0);
  const Json instances =
      run("pcl_shape_instances", with({scene, out, "-class", "object"}));
  EXPECT_EQ(instances["parameters"]["resolution"], 0.003);
  EXPECT_GE(instances["counts"]["instances"], 2);
  const Json grasps = run("pcl_shape_grasp", with({scene}));
  EXPECT_EQ(grasps["parameters"]["resolution"], 0.003);
  EXPECT_GE(grasps["counts"]["grasps"], 1);
}

TEST_F(ResolutionOption, BadOnesAreRefused)
{
  const std::string out = path("out.pcd");
  for (const char* const app : {"pcl_shape_back_projection",
                                "pcl_shape_edge_detection",
                                "pcl_shape_label",
                                "pcl_shape_instances"}) {
    expectRefused(runApp(app, {scene, out, "-resolution", "0"}),
                  2,
                  {"-resolution '0'", "positive"});
    expectFailure(runApp(app, {scene, out, "-resolution", "50"}),
                  {"resolution is 50 m", "less than the cloud's extent", "scene.pcd"});
    EXPECT_FALSE(exists(out));
  }
  expectFailure(runApp("pcl_shape_grasp", {scene, "-resolution", "1e-12"}),
                {"resolution is 1e-12 m", "or more, what a float holds", "scene.pcd"});
}

TEST_F(ResolutionOption, NeedsTheDefaultMode)
{
  const std::string out = path("out.pcd");
  const Words words{scene, out, "-resolution", "0.003"};
  const auto with = [&](const Words& other) {
    Words all = words;
    all.insert(all.end(), other.begin(), other.end());
    return runApp("pcl_shape_edge_detection", all);
  };
  expectRefused(with({"-mode", "paper"}), 2, {"-resolution '0.003'", "default method"});
  expectRefused(with({"-radius", "0.02"}), 2, {"-radius '0.02'", "paper's method"});
  expectRefused(with({"-scale", "fixed"}), 2, {"-scale 'fixed'", "paper's method"});
}

TEST_F(ResolutionOption, ADirectoryOfLabelsKeepsToOne)
{
  const std::string input = path("in"), output = path("labels");
  std::filesystem::create_directory(input);
  std::filesystem::copy_file(scene, input + "/a.pcd");
  const Outcome first =
      runApp("pcl_shape_label", {input, output, "-resolution", "0.003"});
  EXPECT_EQ(first.status, 0) << first.err;
  const Json manifest = Json::parse(readFile(output + "/manifest.json"));
  EXPECT_EQ(manifest["parameters"]["resolution"], 0.003);
  expectRefused(runApp("pcl_shape_label", {input, output, "-resolution", "0.004"}),
                1,
                {"parameters", "0.004", "-overwrite"});
}

} // namespace
