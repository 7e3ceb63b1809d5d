// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// What the viewer refuses, with its messages.

// What the viewer refuses. Nothing is drawn: these need no display.

#include "viewer_test.h"

namespace {

using namespace pcl_shape_test;

const char* const app = "pcl_shape_viewer";

class ViewerRefuses : public ViewerTest {
protected:
  void
  SetUp() override
  {}

  /** Expect exit 1 with these words for this content of the file of an option. */
  void
  expectBadFile(const std::string& option,
                const std::string& content,
                const Words& words) const
  {
    const std::string bad = file("bad.json", content);
    Words all{bad, "allowed"};
    all.insert(all.end(), words.begin(), words.end());
    expectRefused(
        runApp(app, {cloud(), option, bad, "-screenshot", path("p.png")}), 1, all);
    EXPECT_EQ(files(), (std::vector<std::string>{"bad.json", "square.pcd"}));
  }

  std::string
  cloud() const
  {
    return square("surface", "U", {"1", "2"});
  }
};

TEST_F(ViewerRefuses, ToDrawWithoutADisplay)
{
  const Outcome outcome = runApp(app, {cloud(), "-screenshot", path("p.png")});
#ifdef PCL_SHAPE_HAS_VISUALIZATION
  expectRefused(outcome, 1, {"DISPLAY", "xvfb-run"});
  expectRefused(runApp(app, {cloud()}), 1, {"DISPLAY", "xvfb-run"});
#else
  expectRefused(outcome, 1, {"built without PCL's visualization", "libpcl-dev"});
#endif
  EXPECT_EQ(files(), std::vector<std::string>{"square.pcd"});
}

TEST_F(ViewerRefuses, AFieldThatIsMissing)
{
  expectRefused(runApp(app, {cloud(), "-field", "surfaces"}),
                1,
                {"square.pcd", "'surfaces'", "allowed", "x y z surface"});
  expectRefused(runApp(app, {cloud(), "-normals"}), 1, {"normal_x", "allowed"});
  expectRefused(runApp(app, {cloud(), "-shade"}), 1, {"normal_x", "allowed"});
}

TEST_F(ViewerRefuses, LabelsThatAreNot)
{
  expectRefused(runApp(app, {square("surface", "F", {"1", "1.5"})}),
                1,
                {"surface", "1.5", "whole number"});
}

TEST_F(ViewerRefuses, OptionsThatItCannotRead)
{
  const std::string in = cloud();
  expectRefused(runApp(app, {in, "-field", ","}), 2, {"-field", "allowed"});
  for (const char* const size : {"640", "640x", "x480", "10x480", "1e9x2", "axb"})
    expectRefused(runApp(app, {in, "-size", size}), 2, {"-size", size, "allowed"});
  for (const char* const camera :
       {"1,2,3", "0,0,0,0,0,0,0,1,0", "0,0,0,0,0,1,0,0,2", "0,0,0,0,0,1,0,1,0,180"})
    expectRefused(
        runApp(app, {in, "-camera", camera}), 2, {"-camera", camera, "allowed"});
  for (const char* const names : {"flat", "1=", "x=flat"})
    expectRefused(runApp(app, {in, "-names", names}), 2, {"-names", names, "allowed"});
  expectRefused(runApp(app, {in, "-point_size", "0"}), 2, {"-point_size", "allowed"});
  expectRefused(runApp(app, {in, "-screenshoot", "a"}), 2, {"-screenshoot"});
  expectRefused(runApp(app, {}), 2, {"in.pcd"});
}

TEST_F(ViewerRefuses, LinesThatAreNone)
{
  expectBadFile("-lines", "not JSON", {"JSON"});
  expectBadFile("-lines", R"({"format": "pcl_shape model"})", {"format"});
  expectBadFile("-lines",
                R"({"format": "pcl_shape lines", "version": 2})",
                {"'version' is '2'", "1"});
  expectBadFile("-lines",
                R"({"format": "pcl_shape lines", "version": 1,
                    "lines": [{"spacing": 1, "points": [[0, 0, 1]]}]})",
                {"lines[0].points", "two points"});
  expectBadFile("-lines",
                R"({"format": "pcl_shape lines", "version": 1,
                    "lines": [{"spacing": 1, "points": [[0, 0, 1], [0, 1]]}]})",
                {"lines[0].points[1]", "three finite numbers"});
  expectBadFile("-lines",
                R"({"format": "pcl_shape lines", "version": 1,
                    "lines": [{"spacing": 0, "points": [[0, 0, 1], [0, 1, 1]]}]})",
                {"lines[0].spacing", "positive"});
}

TEST_F(ViewerRefuses, InstancesThatAreNone)
{
  expectBadFile("-instances", "[]", {"JSON object"});
  expectBadFile("-instances", R"({"instances": 3})", {"'instances' is '3'", "array"});
  expectBadFile("-instances",
                R"({"instances": [{"id": -1, "class": "a", "centroid": [0, 0, 1]}]})",
                {"instances[0].id", "whole number"});
}

TEST_F(ViewerRefuses, GraspsThatAreNone)
{
  expectBadFile(
      "-grasps",
      R"({"grasps": [{"position": [0, 0, 1], "approach": [0, 0, 2], "seals": true}]})",
      {"grasps[0].approach", "length 1"});
  expectBadFile(
      "-grasps",
      R"({"grasps": [{"position": [0, 0, 1], "approach": [0, 0, 1], "seals": 1}]})",
      {"grasps[0].seals", "true or false"});
  expectBadFile("-grasps", R"({"cup_radius": -1, "grasps": []})", {"cup_radius"});
}

TEST_F(ViewerRefuses, FilesThatItCannotReadOrWrite)
{
  const std::string in = cloud();
  expectRefused(runApp(app, {path("none.pcd")}), 1, {"none.pcd"});
  expectRefused(runApp(app, {in, "-lines", path("none.json")}), 1, {"none.json"});
  expectRefused(runApp(app, {in, "-screenshot", path("no/p.png")}), 1, {"no/p.png"});
  expectRefused(runApp(app, {in, "-screenshot", in}), 2, {"-screenshot", "another"});
  expectRefused(runApp(app, {in, "-screenshot", path("p"), "-json", path("p")}),
                2,
                {"-json", "another"});
  EXPECT_EQ(files(), std::vector<std::string>{"square.pcd"});
}

} // namespace
