// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Lines, grasps, instances, normals and keys over a cloud.

// Lines, instances, grasps, normals and keys over the points.

#include "viewer_test.h"

namespace {

using namespace pcl_shape_test;

class ViewerOverlays : public ViewerTest {
protected:
  std::string
  plainSquare() const
  {
    return square("instance normal_x normal_y normal_z",
                  "U F F F",
                  {"0 0 0 -1", "1 0 0 -1", "0 0 0 -1"});
  }
};

/** The pixels of neither color of the background. */
std::size_t
countOthers(const Picture& picture, const Part& part = {})
{
  return picture.size(part) - picture.count(white, part) -
         picture.count(light_grey, part);
}

TEST_F(ViewerOverlays, LinesAreTubes)
{
  const std::string lines =
      file("lines.json",
           R"({"format": "pcl_shape lines", "version": 1, "lines": [
          {"spacing": 0.004, "points": [[-0.1, 0.05, 0.99], [0, 0.05, 0.99], [0.1, 0.05, 0.99]]}]})");
  const Picture picture = pictureOf({plainSquare(), "-lines", lines});
  // 8 mm of 208 mm in the lower half, as long as the square.
  const Part lower{0.2, 0.55, 0.8, 0.95}, upper{0.2, 0.1, 0.8, 0.5};
  EXPECT_GT(countOthers(picture, lower), 5000u);
  EXPECT_EQ(countOthers(picture, upper), 0u);
}

TEST_F(ViewerOverlays, GraspsAreGreenIfTheySealElseRed)
{
  const std::string grasps = file("grasps.json",
                                  R"({"cup_radius": 0.02, "grasps": [
     {"position": [-0.05, 0, 1], "approach": [0, 0, 1], "score": 0.9, "seals": true},
     {"position": [0.05, 0, 1], "approach": [0, 0, 1], "score": 0.5, "seals": false}]})");
  const Picture picture = pictureOf({plainSquare(), "-grasps", grasps});
  const Part left{0.0, 0.0, 0.5, 1.0}, right{0.5, 0.0, 1.0, 1.0};
  // Seen along the axis: a disc of 40 of some 208 mm that make the height of 720
  // pixels.
  EXPECT_GT(picture.count(green, left), 8000u);
  EXPECT_GT(picture.count(crimson, right), 8000u);
  EXPECT_EQ(picture.count(green, right), 0u);
  EXPECT_EQ(picture.count(crimson, left), 0u);
}

TEST_F(ViewerOverlays, InstancesHaveBoxesAndNames)
{
  const std::string instances = file(
      "instances.json",
      R"({"instances": [{"id": 1, "class": "curved", "points": 520, "centroid": [0, 0, 1],
          "planar": 0.1, "curved": 0.9,
          "primitive": {"type": "cylinder", "residual": 0.001}}]})");
  const Words words{plainSquare(), "-field", "plain"};
  const Picture without = pictureOf(words);
  EXPECT_EQ(countOthers(without, {0.2, 0.1, 0.7, 0.9}), 0u);
  Words more = words;
  more.insert(more.end(), {"-instances", instances});
  const Picture picture = pictureOf(more);
  const Part name{0.3, 0.45, 0.7, 0.55}, box{0.3, 0.0, 0.7, 0.4};
  EXPECT_GT(countOthers(picture, name), 500u);
  EXPECT_GT(countOthers(picture, box), 500u) << "lines along 300 pixels";
}

TEST_F(ViewerOverlays, NormalsAreArrows)
{
  const std::string cloud = plainSquare();
  const Words camera{"-field", "plain", "-camera", "0.4,0,0.6,0,0,1,0,-1,0,30"};
  Words words{cloud};
  words.insert(words.end(), camera.begin(), camera.end());
  const Picture without = pictureOf(words);
  words.emplace_back("-normals");
  const Picture picture = pictureOf(words);
  EXPECT_GT(countOthers(picture), countOthers(without) + 5000u);
}

TEST_F(ViewerOverlays, AreInEveryView)
{
  const std::string grasps = file("grasps.json",
                                  R"({"cup_radius": 0.03, "grasps": [
     {"position": [0, 0, 1], "approach": [0, 0, 1], "score": 1, "seals": true}]})");
  const Picture picture =
      pictureOf({plainSquare(), "-field", "plain,z", "-grasps", grasps});
  EXPECT_GT(picture.count(green, {0.0, 0.0, 0.5, 1.0}), 5000u);
  EXPECT_GT(picture.count(green, {0.5, 0.0, 1.0, 1.0}), 5000u);
}

TEST_F(ViewerOverlays, KeysAreListedIfAskedFor)
{
  const std::string cloud = plainSquare();
  const Pixel paper{255, 255, 221};
  EXPECT_EQ(pictureOf({cloud}).count(paper), 0u);
  EXPECT_GT(pictureOf({cloud, "-keys"}).count(paper), 10000u);
}

TEST_F(ViewerOverlays, AWindowStaysUntilItIsClosed)
{
  const Outcome outcome = runProgram(
      PCL_SHAPE_XVFB_RUN,
      {"-a", "timeout", "5", pathOf("pcl_shape_viewer"), plainSquare(), "-keys"});
  constexpr int ended_by_timeout = 124;
  EXPECT_EQ(outcome.status, ended_by_timeout) << outcome.out << outcome.err;
}

} // namespace
