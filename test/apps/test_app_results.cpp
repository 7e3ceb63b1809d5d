// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Fields and JSON that the apps write.

#include "app_test.h"
#include "io/pcd.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>

namespace {

using namespace pcl::app;
using namespace pcl_shape_test;
using Json = nlohmann::ordered_json;

class Results : public AppTest {
protected:
  Json
  json() const
  {
    return Json::parse(readFile(path("json")));
  }
};

TEST_F(Results, InadOfAPlaneIsZero)
{
  const std::string plane = file("in.pcd", asciiCloud("x y z", "F F F", planeRows(20)));
  for (const Words& neighborhood :
       {Words{"-radius", "0.02"}, Words{"--radius=0.02"}, Words{"-k", "12"}}) {
    Words arguments{plane, path("out.pcd"), "-json", path("json"), "-threads", "2"};
    arguments.insert(arguments.end(), neighborhood.begin(), neighborhood.end());
    expectSuccess(runApp("pcl_inad_estimation", arguments));
    const CloudFile cloud = readCloud(path("out.pcd"));
    for (const char* field : {"mu", "sigma"})
      for (const float value : floatsOf(cloud, field))
        EXPECT_NEAR(value, 0.0f, 1e-4f);
    EXPECT_EQ(json()["app"], "pcl_inad_estimation");
    EXPECT_EQ(json()["points"], 400);
    EXPECT_EQ(json()["finite_points"], 400);
    EXPECT_EQ(json()["counts"]["with_inad"], 400);
    EXPECT_EQ(json()["parameters"]["threads"], 2);
    EXPECT_TRUE(json()["times_ms"]["inad"].is_number());
  }
}

TEST_F(Results, TheNormalsOfTheFileAreUsedOnDemand)
{
  auto rows = withColumn(planeRows(20), "0 0 1");
  rows[210] = rows[210].substr(0, rows[210].size() - 5) + "1 0 0";
  const std::string cloud = file(
      "in.pcd", asciiCloud("x y z normal_x normal_y normal_z", "F F F F F F", rows));
  expectSuccess(runApp("pcl_inad_estimation",
                       {cloud, path("out.pcd"), "-radius", "0.02", "-use_normals"}));
  const std::vector<float> mu = floatsOf(readCloud(path("out.pcd")), "mu");
  EXPECT_NEAR(mu[210], std::acos(0.0), 1e-5) << "its neighbors stand on its normal";
  EXPECT_EQ(mu[0], 0.0f);
}

TEST_F(Results, LonelyPointsAreUnknown)
{
  const std::string cloud =
      file("in.pcd", asciiCloud("x y z", "F F F", {"0 0 1", "1e30 0 0", "1e6 1 1"}));
  expectSuccessOrWarnings(runApp("pcl_shape_back_projection",
                                 {cloud, path("surface.pcd"), "-json", path("json")}));
  EXPECT_EQ(json()["counts"]["unknown"], 3);
  expectSuccessOrWarnings(runApp("pcl_shape_edge_detection",
                                 {cloud, path("edge.pcd"), "-json", path("json")}));
  EXPECT_EQ(json()["counts"]["unknown"], 3);
  const CloudFile surface = readCloud(path("surface.pcd"));
  const CloudFile edge = readCloud(path("edge.pcd"));
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_TRUE(std::isnan(floatsOf(surface, "likelihood")[i]));
    EXPECT_EQ(labelsOf(surface, "surface")[i], 0u);
    EXPECT_TRUE(std::isnan(floatsOf(edge, "edge_likelihood")[i]));
    EXPECT_EQ(labelsOf(edge, "edge")[i], 0u);
  }
}

TEST_F(Results, TheEdgeOfAFoldIsFound)
{
  constexpr int side = 30;
  const std::string fold = file("in.pcd", asciiCloud("x y z", "F F F", foldRows(side)));
  const Outcome outcome = runApp("pcl_shape_edge_detection",
                                 {fold,
                                  path("out.pcd"),
                                  "-mode",
                                  "paper",
                                  "-normal_radius",
                                  "0.012",
                                  "-radius",
                                  "0.012",
                                  "-json",
                                  path("json")});
  expectSuccess(outcome);
  const CloudFile cloud = readCloud(path("out.pcd"));
  const auto edge = labelsOf(cloud, "edge");
  const auto x = floatsOf(cloud, "x");
  const auto z = floatsOf(cloud, "z");
  for (std::size_t i = 0; i < edge.size(); ++i) {
    const float distance = std::max(-x[i], z[i] - 1.0f);
    if (distance < 0.004f) {
      EXPECT_EQ(edge[i], 1u) << "on the fold, point " << i;
    }
    if (distance > 0.026f) {
      EXPECT_EQ(edge[i], 0u) << "away from it, point " << i;
    }
  }
  const auto found = std::count(edge.begin(), edge.end(), 1u);
  EXPECT_EQ(json()["counts"]["edge"], found);
  EXPECT_NE(outcome.out.find(std::to_string(found) + " edge"), std::string::npos);
}

TEST_F(Results, SeveralClassesHaveALikelihoodEach)
{
  const std::string plane = file("p.pcd", asciiCloud("x y z", "F F F", planeRows(20)));
  const std::string fold = file("f.pcd", asciiCloud("x y z", "F F F", foldRows(20)));
  const std::string model = path("m.json");
  for (const auto& [cloud, name] : {std::pair(plane, "flat"), std::pair(fold, "bent")})
    expectSuccess(
        runApp("pcl_shape_histogram",
               {cloud, model, "-radius", "0.02", "-name", name, "-bins", "20"}));
  expectSuccess(runApp("pcl_shape_back_projection",
                       {fold,
                        path("out.pcd"),
                        "-mode",
                        "paper",
                        "-model",
                        model,
                        "-json",
                        path("json")}));
  const CloudFile cloud = readCloud(path("out.pcd"));
  const auto first = floatsOf(cloud, "likelihood");
  const auto flat = floatsOf(cloud, "likelihood_flat");
  const auto bent = floatsOf(cloud, "likelihood_bent");
  const auto surface = labelsOf(cloud, "surface");
  EXPECT_EQ(first, flat);
  for (std::size_t i = 0; i < flat.size(); ++i) {
    EXPECT_NEAR(flat[i] + bent[i], 1.0f, 1e-6f);
    EXPECT_EQ(surface[i], flat[i] >= bent[i] ? 1u : 2u);
  }
  EXPECT_EQ(json()["counts"]["flat"], std::count(surface.begin(), surface.end(), 1u));
  EXPECT_EQ(json()["parameters"]["radius"], 0.02);
}

TEST_F(Results, AGeneratedSceneGoesAllTheWay)
{
  const std::string scene = path("scene.pcd");
  expectSuccess(runApp("pcl_shape_scene",
                       {scene,
                        "-width",
                        "320",
                        "-height",
                        "240",
                        "-seed",
                        "3",
                        "-noise",
                        "none",
                        "-organized"}));
  expectSuccess(runApp("pcl_shape_back_projection",
                       {scene, path("surface.pcd"), "-mode", "paper"}));
  expectSuccess(
      runApp("pcl_shape_evaluate",
             {path("surface.pcd"), scene, "-task", "planar", "-json", path("json")}));
  EXPECT_GT(json()["classes"]["planar"]["f1"], 0.9);
  const CloudFile cloud = readCloud(path("surface.pcd"));
  EXPECT_EQ(cloud.blob.width, 320u);
  EXPECT_EQ(cloud.blob.height, 240u);
}

TEST_F(Results, ScenesFollowTheirSeed)
{
  const auto scene = [&](const std::string& name, const std::string& seed) {
    expectSuccess(runApp("pcl_shape_scene",
                         {path(name),
                          "-width",
                          "80",
                          "-height",
                          "60",
                          "-seed",
                          seed,
                          "-format",
                          "binary"}));
    return readFile(path(name));
  };
  const std::string first = scene("a", "1");
  EXPECT_EQ(first, scene("b", "1"));
  EXPECT_NE(first, scene("c", "2"));
}

} // namespace
