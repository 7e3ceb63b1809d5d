// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Directories of clouds give what single files give, and failures are counted.

#include "app_test.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <filesystem>

namespace {

using namespace pcl_shape_test;
using Json = nlohmann::ordered_json;
namespace fs = std::filesystem;

const std::string edges = "pcl_shape_edge_detection";

class Batch : public AppTest {
protected:
  Batch() : input(path("in")), output(path("out"))
  {
    fs::create_directory(input);
    writeFile(input + "/a.pcd", asciiCloud("x y z", "F F F", planeRows(12)));
    writeFile(input + "/c.pcd", asciiCloud("x y z", "F F F", foldRows(12)));
    writeFile(input + "/notes.txt", "not a cloud");
  }

  const std::string input;
  const std::string output;
};

TEST_F(Batch, ProcessesAllClouds)
{
  const Outcome outcome = runApp(
      edges, {"-input_dir", input, "-output_dir", output, "-json", path("json")});
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_NE(outcome.err.find("2 of 2"), std::string::npos);
  EXPECT_NE(outcome.err.find("0 of 2 files failed"), std::string::npos);
  EXPECT_TRUE(exists(output + "/a.pcd"));
  EXPECT_TRUE(exists(output + "/c.pcd"));
  EXPECT_FALSE(exists(output + "/notes.txt"));
  const Json json = Json::parse(readFile(path("json")));
  ASSERT_EQ(json["files"].size(), 2u);
  EXPECT_EQ(json["files"][0]["input"], input + "/a.pcd");
  EXPECT_EQ(json["files"][1]["points"], 288);
  EXPECT_TRUE(json["failures"].empty());
}

TEST_F(Batch, GivesWhatSingleFilesGive)
{
  ASSERT_EQ(runApp(edges, {"-input_dir", input, "-output_dir", output}).status, 0);
  expectSuccess(runApp(edges, {input + "/c.pcd", path("single.pcd")}));
  EXPECT_EQ(readFile(output + "/c.pcd"), readFile(path("single.pcd")));
}

TEST_F(Batch, FailuresAreCountedAndDoNotStopTheOthers)
{
  writeFile(input + "/b.pcd", "not a cloud");
  fs::create_directory(output);
  writeFile(output + "/b.pcd", "as it was");
  const Outcome outcome = runApp(
      edges, {"-input_dir", input, "-output_dir", output, "-json", path("json")});
  EXPECT_EQ(outcome.status, 1);
  EXPECT_NE(outcome.err.find(input + "/b.pcd: header line 1"), std::string::npos);
  EXPECT_NE(outcome.err.find("1 of 3 files failed"), std::string::npos);
  EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 3 + 1 + 1);
  EXPECT_TRUE(exists(output + "/a.pcd"));
  EXPECT_TRUE(exists(output + "/c.pcd"));
  EXPECT_EQ(readFile(output + "/b.pcd"), "as it was");
  const Json json = Json::parse(readFile(path("json")));
  EXPECT_EQ(json["files"].size(), 2u);
  ASSERT_EQ(json["failures"].size(), 1u);
  EXPECT_EQ(json["failures"][0]["input"], input + "/b.pcd");
}

TEST_F(Batch, BadDirectoriesAreRefused)
{
  const std::string file = input + "/a.pcd";
  fs::create_directory(path("empty"));
  const auto refused = [&](const std::string& in, const std::string& out) {
    return runApp(edges, {"-input_dir", in, "-output_dir", out});
  };
  expectRefused(refused(path("missing"), output), 1, {path("missing"), "allowed"});
  expectRefused(refused(file, output), 1, {file, "allowed"});
  expectRefused(refused(path("empty"), output), 1, {path("empty"), ".pcd", "allowed"});
  expectRefused(refused(input, file), 1, {file, "directory", "allowed"});
  expectRefused(refused(input, path("a/b")), 1, {path("a/b"), "directory", "allowed"});
  expectRefused(refused(input, input), 2, {"-output_dir", input, "allowed"});
  expectRefused(runApp(edges, {"-input_dir", input, "-output_dir", output, "a.pcd"}),
                2,
                {"'a.pcd'", "allowed"});
  EXPECT_FALSE(exists(output));
}

TEST_F(Batch, HistogramsMergeAllSamples)
{
  const std::string model = path("m.json");
  const Words options{"-radius", "0.02", "-json", path("json")};
  Words all{"-input_dir", input, model};
  all.insert(all.end(), options.begin(), options.end());
  expectSuccess(runApp("pcl_shape_histogram", all));
  for (const char* sample : {"/a.pcd", "/c.pcd"})
    expectSuccess(runApp("pcl_shape_histogram",
                         {input + sample, path("single.json"), "-radius", "0.02"}));
  EXPECT_EQ(readFile(model), readFile(path("single.json")));
  EXPECT_EQ(Json::parse(readFile(path("json")))["samples"], 2);
}

} // namespace
