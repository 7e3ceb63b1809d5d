// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Output files: refused paths, fields and formats that are kept.

#include "app_test.h"
#include "io/pcd.h"

#include <cmath>
#include <unistd.h>

#include <sys/stat.h>

namespace {

using namespace pcl::app;
using namespace pcl_shape_test;

const std::string inad = "pcl_inad_estimation";

class Outputs : public AppTest {
protected:
  std::string
  plane() const
  {
    return file("in.pcd", asciiCloud("x y z", "F F F", planeRows(20)));
  }
};

TEST_F(Outputs, BadOnesAreRefusedBeforeTheCloudIsRead)
{
  for (const std::string& output :
       {path("missing/out.pcd"), path(""), std::string("/proc/out.pcd")})
    expectRefused(runApp(inad, {path("missing.pcd"), output, "-radius", "0.02"}),
                  1,
                  {output, "cannot be written", "expected"});
  EXPECT_TRUE(files().empty());
}

TEST_F(Outputs, UnwritableDirectory)
{
  if (geteuid() == 0)
    GTEST_SKIP() << "root may write everywhere";
  const std::string cloud = plane();
  ASSERT_EQ(mkdir(path("locked").c_str(), 0500), 0);
  const std::string output = path("locked/out.pcd");
  expectRefused(runApp(inad, {cloud, output, "-radius", "0.02"}),
                1,
                {output, "Permission denied", "expected"});
}

TEST_F(Outputs, UnwritableFileStays)
{
  if (geteuid() == 0)
    GTEST_SKIP() << "root may write everything";
  const std::string output = file("out.pcd", "as it was");
  ASSERT_EQ(chmod(output.c_str(), 0400), 0);
  expectRefused(runApp(inad, {plane(), output, "-radius", "0.02"}),
                1,
                {output, "Permission denied", "expected"});
  EXPECT_EQ(readFile(output), "as it was");
}

TEST_F(Outputs, BadJsonPathLeavesNoOutput)
{
  const std::string cloud = plane();
  const std::string output = path("out.pcd");
  expectRefused(
      runApp(inad, {cloud, output, "-radius", "0.02", "-json", path("missing/f")}),
      1,
      {path("missing/f"), "cannot be written"});
  expectRefused(runApp(inad, {cloud, output, "-radius", "0.02", "-json", output}),
                2,
                {"-json", output, "expected"});
  EXPECT_EQ(files(), Words{"in.pcd"});
}

TEST_F(Outputs, MissingNormalsAreRefused)
{
  expectRefused(
      runApp(inad, {plane(), path("out.pcd"), "-radius", "0.02", "-use_normals"}),
      1,
      {"in.pcd", "normal_x", "x y z"});
  EXPECT_EQ(files(), Words{"in.pcd"});
}

TEST_F(Outputs, MorePointsThanThereAreIsRefused)
{
  const Words words{"in.pcd", "-k", "'401'", "1 to", "400"};
  const Words arguments{plane(), path("out.pcd"), "-k", "401"};
  expectRefused(runApp("pcl_inad_estimation", arguments), 1, words);
  for (const char* app : {"pcl_shape_back_projection", "pcl_shape_edge_detection"}) {
    Words of_paper = arguments;
    of_paper.insert(of_paper.end(), {"-mode", "paper"});
    expectRefused(runApp(app, of_paper), 1, words);
  }
  EXPECT_EQ(files(), Words{"in.pcd"});
}

TEST_F(Outputs, TheInputMayBeTheOutput)
{
  const std::string cloud = plane();
  expectSuccess(runApp(inad, {cloud, cloud, "-radius", "0.02"}));
  EXPECT_EQ(readCloud(cloud).blob.fields.size(), 5u);
  EXPECT_EQ(files(), Words{"in.pcd"});
}

/** An organized cloud with gaps, a color, labels, several values in a field, a
 * viewpoint. */
std::string
richCloud()
{
  std::string text =
      "# comment\nVERSION .7\nFIELDS x y z rgb ring surface hist _\n"
      "SIZE 4 4 4 4 2 8 4 1\nTYPE F F F U U F F U\nCOUNT 1 1 1 1 1 1 3 1\n"
      "WIDTH 20\nHEIGHT 20\nVIEWPOINT 0.5 0 -1.25 0 1 0 0\nPOINTS 400\n"
      "DATA ascii\n";
  int i = 0;
  for (const std::string& row : planeRows(20)) {
    const std::string number = std::to_string(i);
    text += (i % 7 == 0 ? "nan nan nan" : row) + " 42949672" +
            std::to_string(i % 90 + 5) + ' ' + number + " 0.5 1 2 " + number + " 9\n";
    ++i;
  }
  return text;
}

void
expectSameFields(const CloudFile& before, const CloudFile& after, const Words& names)
{
  for (const std::string& name : names) {
    const auto* const a = findField(before, name);
    const auto* const b = findField(after, name);
    ASSERT_TRUE(a && b) << name;
    const std::size_t bytes = valueSize(a->datatype) * a->count;
    for (std::size_t i = 0; i < before.size(); ++i)
      EXPECT_TRUE(std::equal(
          before.blob.data.data() + i * before.blob.point_step + a->offset,
          before.blob.data.data() + i * before.blob.point_step + a->offset + bytes,
          after.blob.data.data() + i * after.blob.point_step + b->offset))
          << name << " of point " << i;
  }
}

class InputFormats : public Outputs, public ::testing::WithParamInterface<PCDFormat> {};

TEST_P(InputFormats, EverythingIsKept)
{
  const CloudFile before = readCloud(file("text.pcd", richCloud()));
  const std::string input = file("in.pcd", encodeCloud(before, GetParam()));
  const std::string output = path("out.pcd");
  expectSuccess(runApp(
      "pcl_shape_back_projection",
      {input, output, "-format", nameOf(GetParam()), "-normals", "-threads", "1"}));
  const CloudFile after = readCloud(output);
  EXPECT_NE(readFile(output).find(std::string("DATA ") + nameOf(GetParam()) + '\n'),
            std::string::npos);
  EXPECT_EQ(after.blob.width, 20u);
  EXPECT_EQ(after.blob.height, 20u);
  EXPECT_EQ(after.viewpoint, before.viewpoint);
  expectSameFields(before, after, {"x", "y", "z", "rgb", "ring", "hist"});

  Words names;
  for (const auto& field : after.blob.fields)
    names.push_back(field.name);
  EXPECT_EQ(names,
            (Words{"x",
                   "y",
                   "z",
                   "rgb",
                   "ring",
                   "surface",
                   "hist",
                   "normal_x",
                   "normal_y",
                   "normal_z",
                   "curvature",
                   "likelihood"}));
  EXPECT_EQ(findField(after, "surface")->datatype, pcl::PCLPointField::UINT32);
  const auto surface = labelsOf(after, "surface");
  const auto likelihood = floatsOf(after, "likelihood");
  const auto normals = normalsOf(after);
  for (std::size_t i = 0; i < surface.size(); ++i) {
    const bool missing = i % 7 == 0;
    EXPECT_EQ(surface[i], missing ? 0u : 1u);
    EXPECT_EQ(std::isnan(likelihood[i]), missing);
    EXPECT_EQ(std::isnan((*normals)[i].normal_x), missing);
  }
  EXPECT_NEAR((*normals)[200].normal_z, -1.0f, 1e-4f)
      << "towards the viewpoint, at z = -1.25";
}

INSTANTIATE_TEST_SUITE_P(Outputs,
                         InputFormats,
                         ::testing::Values(PCDFormat::ascii,
                                           PCDFormat::binary,
                                           PCDFormat::binary_compressed),
                         [](const auto& info) { return nameOf(info.param); });

TEST_F(Outputs, AreCompressedUnlessToldOtherwise)
{
  const std::string output = path("out.pcd");
  expectSuccess(runApp(inad, {plane(), output, "-radius", "0.02"}));
  EXPECT_NE(readFile(output).find("DATA binary_compressed\n"), std::string::npos);
}

TEST_F(Outputs, AModelIsNotOverwritten)
{
  const std::string cloud = plane(), model = path("m.json"), out = path("out.pcd");
  for (const char* name : {"one", "other"})
    expectSuccess(
        runApp("pcl_shape_histogram",
               {cloud, model, "-radius", "2", "-scale", "density", "-name", name}));
  const std::string before = readFile(model);
  const Words using_it{"-model", model};
  for (const char* app : {"pcl_shape_back_projection", "pcl_shape_label"}) {
    const auto refuse = [&](Words arguments, const std::string& what) {
      arguments.insert(arguments.end(), using_it.begin(), using_it.end());
      expectRefused(runApp(app, arguments), 2, {what, model, "expected"});
    };
    refuse({cloud, out, "-json", model}, "-json");
    refuse({cloud, model}, "output");
  }
  EXPECT_EQ(before, readFile(model));
  EXPECT_FALSE(exists(out));
}

TEST_F(Outputs, ASummaryOverwritesNoSampleAndNoModel)
{
  const std::string cloud = plane(), model = path("m.json");
  const std::string before = readFile(cloud);
  for (const std::string& json : {cloud, model})
    expectRefused(
        runApp("pcl_shape_histogram", {cloud, model, "-radius", "0.02", "-json", json}),
        2,
        {"-json", json, "expected"});
  EXPECT_EQ(before, readFile(cloud));
  EXPECT_EQ(files(), (Words{"in.pcd"}));
}

} // namespace
