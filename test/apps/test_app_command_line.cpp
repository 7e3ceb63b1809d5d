// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Help, version, and values of options that are refused.

#include "app_test.h"

namespace {

using namespace pcl_shape_test;

const Words apps{"pcl_shape_scene",
                 "pcl_inad_estimation",
                 "pcl_shape_histogram",
                 "pcl_shape_back_projection",
                 "pcl_shape_edge_detection",
                 "pcl_shape_evaluate",
                 "pcl_shape_viewer"};

TEST(CommandLine, HelpGoesToStandardOutput)
{
  for (const std::string& app : apps)
    for (const char* option : {"-h", "--help", "-help"}) {
      const Outcome outcome = runApp(app, {option});
      expectSuccess(outcome);
      EXPECT_NE(outcome.out.find("Usage: " + app), std::string::npos);
      EXPECT_NE(outcome.out.find("-threads N"), std::string::npos);
    }
}

TEST(CommandLine, Version)
{
  for (const std::string& app : apps) {
    const Outcome outcome = runApp(app, {"--version"});
    expectSuccess(outcome);
    EXPECT_EQ(outcome.out, app + " " + PCL_SHAPE_VERSION + "\n");
  }
}

TEST(CommandLine, UnknownOptionsAreRefused)
{
  for (const std::string& app : apps) {
    expectRefused(runApp(app, {"-thread", "1"}), 2, {app, "-thread", "-threads"});
    expectRefused(runApp(app, {"--thread", "1"}), 2, {app, "--thread", "-threads"});
    expectRefused(
        runApp(app, {"-threads", "1", "-threads", "2"}), 2, {app, "-threads"});
    expectRefused(runApp(app, {"a.pcd", "-threads"}), 2, {app, "threads", "missing"});
  }
}

TEST(CommandLine, NumbersOfFileNamesAreChecked)
{
  for (const std::string& app : apps) {
    expectRefused(runApp(app, {"-k", "5"}), 2, {app});
    expectRefused(runApp("pcl_shape_evaluate", {"a", "b", "c"}), 2, {"2", "3", "'c'"});
  }
}

struct BadValue {
  std::string app;
  Words options;
  Words words;
};

void
PrintTo(const BadValue& bad, std::ostream* stream)
{
  *stream << bad.app;
  for (const std::string& option : bad.options)
    *stream << ' ' << option;
}

TEST(CommandLine, WhatFollowsTwoDashesAreFiles)
{
  expectRefused(runApp("pcl_shape_ground", {"-max_step", "0.1", "--", "-no.pcd", "--"}),
                1,
                {"-no.pcd: No such file"});
}

class BadValues : public ::testing::TestWithParam<BadValue> {};

TEST_P(BadValues, AreRefusedWithWhatIsExpected)
{
  Words arguments{"no.pcd", "out"};
  if (GetParam().app == "pcl_shape_scene")
    arguments.pop_back();
  arguments.insert(
      arguments.end(), GetParam().options.begin(), GetParam().options.end());
  Words words = GetParam().words;
  words.emplace_back("expected");
  expectRefused(runApp(GetParam().app, arguments), 2, words);
  EXPECT_FALSE(exists("out"));
}

const std::string inad = "pcl_inad_estimation";
const std::string surfaces = "pcl_shape_back_projection";
const std::string edges = "pcl_shape_edge_detection";
const std::string histogram = "pcl_shape_histogram";
const std::string scene = "pcl_shape_scene";
const std::string evaluate = "pcl_shape_evaluate";

INSTANTIATE_TEST_SUITE_P(
    CommandLine,
    BadValues,
    ::testing::Values(
        BadValue{inad, {}, {"-radius", "-k"}},
        BadValue{
            inad, {"-radius", "0.02", "-k", "5"}, {"-radius", "-k", "'0.02'", "'5'"}},
        BadValue{inad, {"-normal_radius", "0.02"}, {"-radius", "-k"}},
        BadValue{inad, {"-k", "5", "-normal_radius", "1"}, {"-normal_radius", "-k"}},
        BadValue{inad, {"-radius", "0"}, {"-radius", "'0'", "positive"}},
        BadValue{inad, {"-radius", "-0.02"}, {"-radius", "'-0.02'", "positive"}},
        BadValue{inad, {"-radius", "nan"}, {"-radius", "'nan'", "finite"}},
        BadValue{inad, {"-radius", "inf"}, {"-radius", "'inf'", "finite"}},
        BadValue{inad, {"-radius", "1e999"}, {"-radius", "'1e999'", "finite"}},
        BadValue{inad, {"-radius", "2cm"}, {"-radius", "'2cm'", "meters"}},
        BadValue{inad, {"-radius", ""}, {"-radius", "''", "meters"}},
        BadValue{inad, {"-radius=0"}, {"-radius", "'0'"}},
        BadValue{inad, {"--radius", "0"}, {"-radius", "'0'"}},
        BadValue{inad, {"-k", "0"}, {"-k", "'0'", "from 1"}},
        BadValue{inad, {"-k", "-5"}, {"-k", "'-5'", "from 1"}},
        BadValue{inad, {"-k", "2.5"}, {"-k", "'2.5'", "whole"}},
        BadValue{inad, {"-k", "99999999999"}, {"-k", "2147483647"}},
        BadValue{
            inad, {"-radius", "1", "-outlier_rate", "-1"}, {"-outlier_rate", "'-1'"}},
        BadValue{
            inad, {"-radius", "1", "-threads", "-1"}, {"-threads", "'-1'", "from 0"}},
        BadValue{
            inad, {"-radius", "1", "-format", "las"}, {"-format", "'las'", "ascii"}},
        BadValue{inad, {"-rad", "1"}, {"-rad", "-radius"}},
        BadValue{surfaces, {"-mode", "fast"}, {"-mode", "'fast'", "paper"}},
        BadValue{surfaces, {"-bins", "0"}, {"-bins", "'0'", "4096"}},
        BadValue{surfaces, {"-bins", "4097"}, {"-bins", "'4097'", "4096"}},
        BadValue{surfaces, {"-threshold", "1.5"}, {"-threshold", "'1.5'", "0 to 1"}},
        BadValue{surfaces, {"-threshold", "nan"}, {"-threshold", "'nan'", "0 to 1"}},
        BadValue{surfaces, {"-model", "m.json", "-bins", "5"}, {"-model", "-bins"}},
        BadValue{surfaces, {"-use_normals", "-normals"}, {"-use_normals", "-normals"}},
        BadValue{surfaces, {"-input_dir", "d"}, {"-input_dir", "-output_dir"}},
        BadValue{edges, {"-normal_radius", "-1"}, {"-normal_radius", "'-1'"}},
        BadValue{edges, {"-threshold", "-0.1"}, {"-threshold", "'-0.1'"}},
        BadValue{histogram, {}, {"-radius", "-k", "out"}},
        BadValue{histogram, {"-radius", "1", "-name", "a b"}, {"-name", "'a b'"}},
        BadValue{histogram, {"-radius", "1", "-name", ""}, {"-name", "''"}},
        BadValue{histogram, {"-radius", "1", "-field", "f"}, {"-field", "-value"}},
        BadValue{histogram, {"-radius", "1", "-prior", "0"}, {"-prior", "'0'"}},
        BadValue{histogram, {"-radius", "1", "-mu_range", "91"}, {"-mu_range", "90"}},
        BadValue{scene, {"-width", "15"}, {"-width", "'15'", "16"}},
        BadValue{scene, {"-height", "4097"}, {"-height", "'4097'", "4096"}},
        BadValue{scene, {"-objects", "31"}, {"-objects", "'31'", "30"}},
        BadValue{scene, {"-seed", "-1"}, {"-seed", "'-1'"}},
        BadValue{scene, {"-noise", "loud"}, {"-noise", "'loud'", "kinect"}},
        BadValue{scene, {"-noise", "0.2"}, {"-noise", "'0.2'", "0.1"}},
        BadValue{evaluate, {"-task", "all"}, {"-task", "'all'", "edge", "ground"}},
        BadValue{evaluate, {"-convention", "x"}, {"-convention", "'x'", "strict"}}));

} // namespace
