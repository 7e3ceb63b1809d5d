// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Pages of -html, without a browser: test/browser opens them in one.

#include "viewer_test.h"

#include <nlohmann/json.hpp>

#include <algorithm>

namespace {

using namespace pcl_shape_test;
using Json = nlohmann::json;

const char* const app = "pcl_shape_viewer";

class ViewerPages : public ViewerTest {
protected:
  /** Pages need no display. */
  void
  SetUp() override
  {
#ifndef PCL_SHAPE_HAS_PAGES
    GTEST_SKIP() << "built without pages (npm)";
#endif
  }

  std::string
  pageOf(Words arguments) const
  {
    arguments.insert(arguments.end(), {"-html", path("page.html")});
    expectSuccess(runApp(app, arguments));
    return readFile(path("page.html"));
  }

  static Json
  headerOf(const std::string& page)
  {
    const std::string begin = R"(<script type="application/json" id="cloud">)";
    const std::size_t from = page.find(begin) + begin.size();
    return Json::parse(page.substr(from, page.find("</script>", from) - from));
  }

  static Words
  namesOf(const Json& header)
  {
    Words names;
    for (const Json& field : header["fields"])
      names.push_back(field["name"]);
    return names;
  }

  /** 100 points with a field that tells them apart. */
  static Words
  rows()
  {
    Words rows;
    for (int i = 0; i < 100; ++i)
      rows.push_back(std::to_string(0.01 * (i % 10)) + ' ' +
                     std::to_string(0.01 * (i / 10)) + " 1 " + std::to_string(i % 3));
    return rows;
  }
};

TEST_F(ViewerPages, ShowTimesInNanosecondsAsNumbers)
{
  const std::string cloud =
      "FIELDS x y z t\nSIZE 4 4 4 8\nTYPE F F F U\nPOINTS 2\nDATA "
      "ascii\n0 0 1 1700000000000000000\n0 1 1 1700000000000000100\n";
  const Json header = headerOf(pageOf({file("times.pcd", cloud)}));
  for (const Json& field : header["fields"])
    if (field["name"] == "t") {
      EXPECT_EQ(field["kind"], "numbers");
      return;
    }
  FAIL() << "the page has no field t";
}

TEST_F(ViewerPages, HaveAllFieldsAndWhatIsKnownOfThem)
{
  const Json header = headerOf(
      pageOf({square("mu surface edge", "F U U", {"0 1 0", "nan 2 1", "1.5 2 0"})}));
  EXPECT_EQ(namesOf(header), (Words{"surface", "z", "mu", "edge", "plain"}));
  const Json& fields = header["fields"];
  EXPECT_EQ(fields[0]["legend"][0],
            (Json{{"name", "planar"}, {"color", "#4678cd"}, {"points", 560}}));
  EXPECT_EQ(fields[2]["kind"], "numbers");
  EXPECT_EQ(fields[2]["title"], "mu, degrees");
  EXPECT_EQ(fields[2]["unknown"], 520);
  EXPECT_EQ(fields[3]["nothing"], 0);
  EXPECT_FALSE(fields[0].contains("nothing"));
  EXPECT_EQ(header["points"], 1600);
  EXPECT_EQ(header["note"], "1,600 points");
  EXPECT_EQ(header["title"], "square.pcd");
}

TEST_F(ViewerPages, HaveOnlyTheFieldsThatAreAskedFor)
{
  const std::string cloud = square("surface edge", "U U", {"1 0", "2 1"});
  EXPECT_EQ(namesOf(headerOf(pageOf({cloud, "-field", "edge,plain"}))),
            (Words{"edge", "plain"}));
}

TEST_F(ViewerPages, AreTheSameForAnyOrderOfThePoints)
{
  Words mixed = rows();
  const std::string in_order =
      pageOf({file("cloud.pcd", asciiCloud("x y z surface", "F F F U", mixed)),
              "-max_points",
              "40"});
  std::rotate(mixed.begin(), mixed.begin() + 37, mixed.end());
  std::reverse(mixed.begin(), mixed.begin() + 50);
  const std::string in_another =
      pageOf({file("cloud.pcd", asciiCloud("x y z surface", "F F F U", mixed)),
              "-max_points",
              "40"});
  EXPECT_TRUE(in_order == in_another);
}

TEST_F(ViewerPages, SayThatTheyShowAChoice)
{
  const std::string cloud =
      file("cloud.pcd", asciiCloud("x y z surface", "F F F U", rows()));
  const Json header =
      headerOf(pageOf({cloud, "-max_points", "40", "-json", path("json")}));
  EXPECT_EQ(header["points"], 40);
  EXPECT_EQ(header["note"], "40 of 100 points, chosen evenly; counts are of all");
  const Json report = Json::parse(readFile(path("json")));
  EXPECT_EQ(report["points_shown"], 40);
  EXPECT_EQ(report["views"]["surface"]["planar"], 33) << "of all points";
}

TEST_F(ViewerPages, LeaveOutPointsWithoutCoordinates)
{
  Words some = rows();
  some[3] = "nan nan nan 1";
  const Json header = headerOf(
      pageOf({file("cloud.pcd", asciiCloud("x y z surface", "F F F U", some))}));
  EXPECT_EQ(header["points"], 99);
}

TEST_F(ViewerPages, KnowTheDistanceBetweenPlacesWherePointsAreRepeated)
{
  Words twice = rows();
  const Words once = rows();
  twice.insert(twice.end(), once.begin(), once.end());
  const Json header = headerOf(
      pageOf({file("cloud.pcd", asciiCloud("x y z surface", "F F F U", twice))}));
  EXPECT_NEAR(header["spacing"], 0.01, 1e-6);
}

TEST_F(ViewerPages, ShowASinglePoint)
{
  const Json header =
      headerOf(pageOf({file("cloud.pcd", asciiCloud("x y z", "F F F", {"1 2 3"}))}));
  EXPECT_EQ(header["note"], "1 point");
  EXPECT_EQ(header["spacing"], 1.0);
  EXPECT_EQ(header["offset"], (Json{1.0, 2.0, 3.0}));
}

TEST_F(ViewerPages, LoadNothing)
{
  const std::string page = pageOf({square("surface", "U", {"1", "2"})});
  for (const char* const word :
       {" src=\"", "<link rel=\"stylesheet", "@import", "fetch(\"http"})
    EXPECT_EQ(page.find(word), std::string::npos) << word;
}

TEST_F(ViewerPages, ReplaceAFileOnlyIfTheyAreWritten)
{
  const std::string page = file("page.html", "old");
  const std::string cloud = square("surface", "F", {"1", "1.5"});
  expectRefused(runApp(app, {cloud, "-html", page}), 1, {"surface", "1.5"});
  EXPECT_EQ(readFile(page), "old");
  expectRefused(
      runApp(app, {square("surface", "U", {"1"}), "-html", path("no/p.html")}),
      1,
      {"no/p.html"});
}

using ViewerPageOptions = AppTest;

TEST_F(ViewerPageOptions, AreRefusedWhereTheyMakeNoSense)
{
  const std::string cloud =
      file("cloud.pcd", asciiCloud("x y z", "F F F", {"0 0 1", "0 1 1"}));
  const std::string page = path("p.html");
  expectRefused(runApp(app, {cloud, "-html", page, "-screenshot", path("p.png")}),
                2,
                {"-html", "-screenshot"});
  expectRefused(runApp(app, {cloud, "-max_points", "9"}), 2, {"-max_points", "-html"});
  expectRefused(runApp(app, {cloud, "-html", page, "-keys"}), 2, {"-keys", "-html"});
  expectRefused(runApp(app, {cloud, "-html", page, "-max_points", "0"}),
                2,
                {"-max_points", "expected"});
#ifdef PCL_SHAPE_HAS_PAGES
  expectRefused(runApp(app, {cloud, "-html", cloud}), 2, {"-html", "another"});
#else
  expectRefused(runApp(app, {cloud, "-html", page}), 1, {"built without pages", "npm"});
#endif
  EXPECT_EQ(files(), std::vector<std::string>{"cloud.pcd"});
}

} // namespace
