// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Colors and legends of every kind of field.

// Points in the colors of their fields.

#include "viewer_test.h"

#include <nlohmann/json.hpp>

namespace {

using namespace pcl_shape_test;
using Json = nlohmann::json;

constexpr Part left{0.16, 0.1, 0.48, 0.9};
constexpr Part right{0.52, 0.1, 0.84, 0.6};
constexpr Part legend{0.86, 0.5, 1.0, 1.0};

using ViewerFields = ViewerTest;

TEST_F(ViewerFields, PlanarIsBlueAndCurvedIsOrangeWithALegend)
{
  const Picture picture = pictureOf({square("surface", "U", {"1", "2"})});
  EXPECT_EQ(picture.width(), 960);
  EXPECT_EQ(picture.height(), 720);
  EXPECT_GT(picture.share(blue, left), 0.9);
  EXPECT_GT(picture.share(orange, right), 0.9);
  EXPECT_EQ(picture.count(orange, left), 0u);
  EXPECT_EQ(picture.count(blue, right), 0u);
  EXPECT_GT(picture.count(blue, legend), 50u);
  EXPECT_GT(picture.count(orange, legend), 50u);
  EXPECT_GT(picture.share(white), 0.1);
}

TEST_F(ViewerFields, LabelsAreCountedAndNamed)
{
  const std::string cloud =
      square("label surface", "U U", {"1 1", "2 0", "2 2", "7 3"});
  pictureOf({cloud,
             "-field",
             "label,surface",
             "-names",
             "1=flat,2=corrugated",
             "-json",
             path("json")});
  const Json views = Json::parse(readFile(path("json")))["views"];
  EXPECT_EQ(views["label"], (Json{{"flat", 400}, {"corrugated", 800}, {"7", 400}}));
}

TEST_F(ViewerFields, TrainingLabelsAreNamed)
{
  pictureOf({square("label confidence", "U F", {"0 0", "1 .9", "2 .9", "3 .9"}),
             "-json",
             path("json")});
  const Json view = Json::parse(readFile(path("json")))["views"]["label"];
  EXPECT_EQ(view,
            (Json{{"void", 400}, {"planar", 400}, {"curved", 400}, {"edge", 400}}));
}

TEST_F(ViewerFields, AnglesAreViridisInDegreesAndUnknownIsGrey)
{
  const std::string cloud = square("mu", "F", {"0", "0", "nan", "1.5", "1.5"});
  const Picture picture = pictureOf({cloud, "-json", path("json")});
  const Pixel violet{68, 1, 84}, yellow{253, 231, 37}; // the ends of Viridis
  EXPECT_GT(picture.share(violet, {0.16, 0.1, 0.4, 0.9}), 0.9);
  EXPECT_GT(picture.share(grey, {0.45, 0.1, 0.55, 0.9}), 0.9);
  EXPECT_GT(picture.share(yellow, {0.6, 0.1, 0.84, 0.5}), 0.9);
  const Json view = Json::parse(readFile(path("json")))["views"]["mu"];
  EXPECT_NEAR(view["least"], 0.0, 1e-9);
  EXPECT_NEAR(view["most"], 85.9437, 1e-3);
  EXPECT_EQ(view["unknown"], 320);
  const Part bar{0.86, 0.55, 1.0, 1.0};
  EXPECT_GT(picture.count({33, 145, 140}, bar), 10u) << "the middle of the scale bar";
}

TEST_F(ViewerFields, LabelsWithoutANameHaveColorsOfTheirOwn)
{
  const Picture picture =
      pictureOf({square("face", "U", {"0", "1"}), "-field", "face"});
  const Pixel green{77, 175, 74}; // of the first
  EXPECT_GT(picture.share(green, right), 0.9);
  EXPECT_EQ(picture.count(green, left), 0u);
  EXPECT_EQ(picture.count(white, {0.3, 0.3, 0.4, 0.7}), 0u);
}

TEST_F(ViewerFields, OnePointFarAwayHidesNothing)
{
  for (const char* const far : {"1e6", "1e30"}) {
    Words rows;
    for (int i = 0; i < 1600; ++i)
      rows.push_back(std::to_string(0.01 * (i % 40)) + ' ' +
                     std::to_string(0.01 * (i / 40)) + " 1 1");
    rows.push_back(std::string(far) + " 0 1 2");
    const Picture picture =
        pictureOf({file("far.pcd", asciiCloud("x y z surface", "F F F U", rows))});
    EXPECT_GT(picture.share(blue, left), 0.9) << far;
    EXPECT_GT(picture.share(blue, right), 0.9) << far;
  }
}

TEST_F(ViewerFields, ColorsStayAsTheyAre)
{
  const Picture picture = pictureOf({square("rgb", "U", {"3303920", "16711680"})});
  EXPECT_GT(picture.share({50, 105, 240}, left), 0.9); // 0x3269F0
  EXPECT_GT(picture.share({255, 0, 0}, right), 0.9);
}

TEST_F(ViewerFields, SeveralFieldsAreSideBySide)
{
  const std::string cloud = square("surface edge", "U U", {"1 1", "1 0"});
  const Picture picture =
      pictureOf({cloud, "-field", "surface,edge,plain", "-size", "900x300"});
  EXPECT_EQ(picture.width(), 900);
  EXPECT_EQ(picture.height(), 300);
  const Part first{0.0, 0.0, 0.33, 1.0}, second{0.34, 0.0, 0.66, 1.0},
      third{0.67, 0.0, 1.0, 1.0};
  EXPECT_GT(picture.share(blue, first), 0.5);
  EXPECT_EQ(picture.count(crimson, first), 0u);
  EXPECT_GT(picture.share(crimson, second), 0.25);
  EXPECT_GT(picture.share(light_grey, second), 0.25);
  EXPECT_EQ(picture.count(blue, second), 0u);
  EXPECT_GT(picture.share(light_grey, third), 0.5);
}

TEST_F(ViewerFields, PointsWithoutCoordinatesAreLeftOut)
{
  const std::string rows = "-0.1 0 1 1|nan nan nan 2|0.1 0 1 2|0 0.1 1 1";
  std::vector<std::string> lines;
  for (std::size_t from = 0, to; from < rows.size(); from = to + 1) {
    to = std::min(rows.find('|', from), rows.size());
    lines.push_back(rows.substr(from, to - from));
  }
  const std::string cloud =
      file("nan.pcd", asciiCloud("x y z surface", "F F F U", lines));
  const Picture picture =
      pictureOf({cloud, "-point_size", "20", "-json", path("json")});
  EXPECT_GT(picture.count(blue), 300u);
  const Json view = Json::parse(readFile(path("json")))["views"]["surface"];
  EXPECT_EQ(view, (Json{{"planar", 2}, {"curved", 1}}));
}

TEST_F(ViewerFields, ShadeIsDarkWhereTheSurfaceTurnsAway)
{
  const std::string cloud = square("surface normal_x normal_y normal_z",
                                   "U F F F",
                                   {"1 -0.3 -0.46 -0.84", "1 0.94 0 -0.3357"});
  const Picture picture = pictureOf({cloud, "-shade"});
  EXPECT_GT(picture.share(blue, left), 0.9);
  EXPECT_GT(picture.share({21, 36, 61}, right), 0.9) << "0.3 of blue";
}

TEST_F(ViewerFields, TheCameraIsTheOneGiven)
{
  const std::string cloud = square("surface", "U", {"1", "2"});
  const Picture far_away =
      pictureOf({cloud, "-camera", "0,0,-9,0,0,1,0,-1,0,30", "-point_size", "1"});
  EXPECT_LT(far_away.share(blue, {0.0, 0.0, 0.8, 1.0}), 0.01);
  const Picture from_behind =
      pictureOf({cloud, "-camera", "0,0,2,0,0,1,0,-1,0,12", "-point_size", "20"});
  EXPECT_GT(from_behind.share(orange, left), 0.9) << "right and left change places";
}

TEST_F(ViewerFields, ARealScene)
{
  const std::string data = PCL_SHAPE_TEST_DATA;
  if (data.empty())
    GTEST_SKIP() << "PCL_SHAPE_TEST_DATA is not set";
  const Picture picture =
      pictureOf({data + "/osd/learn33_gt.pcd", "-field", "surface"});
  EXPECT_GT(picture.share(blue), 0.2);
  EXPECT_GT(picture.share(orange), 0.01);
}

} // namespace
