// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Apps on scans of real scenes.

#include "app_test.h"

#include <nlohmann/json.hpp>

namespace {

using namespace pcl_shape_test;
using Json = nlohmann::ordered_json;

struct SurfaceFloor {
  std::string scene;
  double planar_f1;
  double curved_f1;
};

void
PrintTo(const SurfaceFloor& floor, std::ostream* stream)
{
  *stream << floor.scene;
}

class RealScenes : public AppTest, public ::testing::WithParamInterface<SurfaceFloor> {
protected:
  void
  SetUp() override
  {
    if (std::string(PCL_SHAPE_TEST_DATA).empty())
      GTEST_SKIP() << "PCL_SHAPE_TEST_DATA is not set";
  }

  static std::string
  truth(const std::string& scene)
  {
    return std::string(PCL_SHAPE_TEST_DATA) + "/osd/" + scene + "_gt.pcd";
  }

  double
  f1(const std::string& prediction,
     const std::string& scene,
     const std::string& task,
     const std::string& convention) const
  {
    expectSuccess(runApp("pcl_shape_evaluate",
                         {prediction,
                          truth(scene),
                          "-task",
                          task,
                          "-convention",
                          convention,
                          "-json",
                          path("json")}));
    return Json::parse(readFile(path("json")))["classes"][task]["f1"];
  }
};

TEST_P(RealScenes, SurfacesInPaperMode)
{
  const auto& [scene, planar_f1, curved_f1] = GetParam();
  const std::string prediction = path("surface.pcd");
  expectSuccess(runApp("pcl_shape_back_projection",
                       {truth(scene), path("raw.pcd"), "-mode", "paper"}));
  expectSuccess(runApp("pcl_shape_back_projection",
                       {path("raw.pcd"), prediction, "-mode", "paper"}));
  EXPECT_EQ(readFile(path("raw.pcd")), readFile(prediction))
      << "the labels are not used";
  EXPECT_GE(f1(prediction, scene, "planar", "paper"), planar_f1);
  EXPECT_GE(f1(prediction, scene, "curved", "paper"), curved_f1);
}

INSTANTIATE_TEST_SUITE_P(OSD,
                         RealScenes,
                         ::testing::Values(SurfaceFloor{"learn4", 0.96, 0.60},
                                           SurfaceFloor{"learn20", 0.96, 0.58},
                                           SurfaceFloor{"learn33", 0.96, 0.77},
                                           SurfaceFloor{"learn44", 0.96, 0.82}),
                         [](const auto& info) { return info.param.scene; });

using RealEdges = RealScenes;

TEST_F(RealEdges, InPaperModeOverSevenScenes)
{
  double sum = 0.0;
  const Words scenes{
      "learn4", "learn20", "learn22", "learn27", "learn30", "learn33", "learn44"};
  for (const std::string& scene : scenes) {
    const std::string prediction = path("edge.pcd");
    expectSuccessOrWarnings(runApp("pcl_shape_edge_detection",
                                   {truth(scene), prediction, "-mode", "paper"}));
    sum += f1(prediction, scene, "edge", "strict");
  }
  EXPECT_GE(sum / static_cast<double>(scenes.size()), 0.82);
}

} // namespace
