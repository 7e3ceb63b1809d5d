// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// pcl_shape_label: single files, directories, resuming.

#include "app_test.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <filesystem>

namespace {

using namespace pcl_shape_test;
using Json = nlohmann::ordered_json;
namespace fs = std::filesystem;

const std::string app = "pcl_shape_label";

class Label : public AppTest {
protected:
  Label() : input(path("in")), output(path("out"))
  {
    fs::create_directory(input);
    writeFile(input + "/a.pcd", asciiCloud("x y z", "F F F", planeRows(20)));
    writeFile(input + "/b.pcd", asciiCloud("x y z", "F F F", foldRows(20)));
    writeFile(input + "/notes.txt", "not a cloud");
  }

  Outcome
  label(Words options = {}) const
  {
    options.insert(options.begin(), {input, output});
    return runApp(app, options);
  }

  Json
  manifest() const
  {
    return Json::parse(readFile(output + "/manifest.json"));
  }

  /** \brief Names of all files in the output directory and below. */
  Words
  outputs() const
  {
    Words names;
    for (const auto& entry : fs::recursive_directory_iterator(output))
      if (entry.is_regular_file())
        names.push_back(fs::relative(entry.path(), output));
    std::sort(names.begin(), names.end());
    return names;
  }

  const std::string input;
  const std::string output;
};

TEST_F(Label, OneFileGetsLabelAndConfidence)
{
  expectSuccess(runApp(app, {input + "/b.pcd", path("b.pcd"), "-json", path("json")}));
  const std::string cloud = readFile(path("b.pcd"));
  EXPECT_NE(cloud.find("FIELDS x y z label confidence"), std::string::npos);
  EXPECT_NE(cloud.find("TYPE F F F U F"), std::string::npos);
  const Json json = Json::parse(readFile(path("json")));
  EXPECT_EQ(json["points"], 800);
  std::uint64_t sum = 0;
  for (const auto& [name, count] : json["counts"].items())
    sum += count.get<std::uint64_t>();
  EXPECT_EQ(sum, 800u);
  EXPECT_GT(json["counts"]["planar"], 0);
}

TEST_F(Label, AllIsVoidAboveTheHighestConfidence)
{
  expectSuccess(runApp(
      app,
      {input + "/a.pcd", path("a.ply"), "-confidence", "1", "-json", path("json")}));
  EXPECT_EQ(readFile(path("a.ply")).substr(0, 4), "ply\n");
  EXPECT_EQ(Json::parse(readFile(path("json")))["counts"]["void"], 400);
}

TEST_F(Label, FieldsThatPlyCannotHoldAreNamed)
{
  std::string cloud =
      asciiCloud("x y z time", "F F F U", withColumn(planeRows(20), "7"));
  cloud.replace(cloud.find("4 4 4 4"), 7, "4 4 4 8");
  const Outcome outcome = runApp(app, {file("time.pcd", cloud), path("time.ply")});
  expectSuccessOrWarnings(outcome);
  EXPECT_NE(outcome.err.find("left out 'time'"), std::string::npos) << outcome.err;
}

TEST_F(Label, ADirectoryGetsAManifest)
{
  const Outcome outcome = label({"-json", path("json")});
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_NE(outcome.err.find("2 of 2: " + input + "/b.pcd"), std::string::npos);
  EXPECT_NE(outcome.err.find("s left"), std::string::npos);
  EXPECT_NE(outcome.err.find("0 of 2 files failed"), std::string::npos);
  EXPECT_EQ(outputs(), (Words{"a.pcd", "b.pcd", "manifest.json"}));
  const Json json = manifest();
  EXPECT_EQ(json["format"], "pcl_shape labels");
  EXPECT_TRUE(json["software"].contains("pcl"));
  EXPECT_TRUE(json["software"].contains("pcl_shape"));
  EXPECT_TRUE(json["parameters"].contains("confidence"));
  EXPECT_EQ(json["classes"][3]["name"], "edge");
  ASSERT_EQ(json["files"].size(), 2u);
  EXPECT_EQ(json["files"][1]["input"], "b.pcd");
  EXPECT_EQ(json["files"][1]["points"], 800);
  for (const char* name : {"void", "planar", "curved", "edge"})
    EXPECT_EQ(json["counts"][name],
              json["files"][0]["counts"][name].get<int>() +
                  json["files"][1]["counts"][name].get<int>());
  EXPECT_EQ(Json::parse(readFile(path("json")))["files"].size(), 2u);
}

TEST_F(Label, ADirectoryGivesWhatSingleFilesGive)
{
  ASSERT_EQ(label({"-threads", "2"}).status, 0);
  expectSuccess(runApp(app, {input + "/b.pcd", path("b.pcd"), "-threads", "1"}));
  EXPECT_EQ(readFile(output + "/b.pcd"), readFile(path("b.pcd")));
}

TEST_F(Label, ASecondRunDoesWhatIsMissing)
{
  ASSERT_EQ(label().status, 0);
  const std::string first = readFile(output + "/manifest.json");
  const auto before = fs::last_write_time(output + "/a.pcd");
  fs::remove(output + "/b.pcd");
  const Outcome outcome = label();
  EXPECT_NE(outcome.err.find("1 were done before"), std::string::npos) << outcome.err;
  EXPECT_EQ(readFile(output + "/manifest.json"), first);
  EXPECT_EQ(fs::last_write_time(output + "/a.pcd"), before);
  EXPECT_TRUE(exists(output + "/b.pcd"));
}

TEST_F(Label, AChangedCloudIsLabeledAgain)
{
  ASSERT_EQ(label().status, 0);
  writeFile(input + "/a.pcd", asciiCloud("x y z", "F F F", foldRows(12)));
  const Outcome outcome = label();
  EXPECT_NE(outcome.err.find("1 were done before"), std::string::npos) << outcome.err;
  EXPECT_EQ(manifest()["files"][0]["points"], 288);
}

TEST_F(Label, OtherParametersNeedOverwrite)
{
  ASSERT_EQ(label().status, 0);
  const std::string first = readFile(output + "/manifest.json");
  expectRefused(label({"-confidence", "0.5"}), 1, {"parameters", "0.5", "-overwrite"});
  expectRefused(label({"-format", "ply"}), 1, {"parameters", "ply", "-overwrite"});
  EXPECT_EQ(readFile(output + "/manifest.json"), first);
  EXPECT_EQ(label({"-confidence", "0.5", "-overwrite"}).status, 0);
  EXPECT_EQ(manifest()["parameters"]["confidence"], 0.5);
}

TEST_F(Label, ABadManifestIsRefused)
{
  fs::create_directory(output);
  for (const char* bad : {"", "{", "[]", "{\"files\": [3]}", "{\"files\": [{}]}"}) {
    writeFile(output + "/manifest.json", bad);
    expectRefused(label(), 1, {output + "/manifest.json", "expected"});
    EXPECT_EQ(outputs(), Words{"manifest.json"});
  }
  EXPECT_EQ(label({"-overwrite"}).status, 0);
  Json json = manifest();
  json["files"][0].erase("counts");
  writeFile(output + "/manifest.json", json.dump());
  expectRefused(label(), 1, {output + "/manifest.json", "counts", "expected"});
}

TEST_F(Label, FailuresAreListedAndDoNotStopTheOthers)
{
  writeFile(input + "/aa.pcd", "not a cloud");
  const Outcome outcome = label();
  EXPECT_EQ(outcome.status, 1);
  EXPECT_NE(outcome.err.find("1 of 3 files failed"), std::string::npos) << outcome.err;
  EXPECT_EQ(outputs(), (Words{"a.pcd", "b.pcd", "manifest.json"}));
  ASSERT_EQ(manifest()["failures"].size(), 1u);
  EXPECT_EQ(manifest()["failures"][0]["input"], "aa.pcd");
  fs::remove(input + "/aa.pcd");
  EXPECT_EQ(label().status, 0);
  EXPECT_TRUE(manifest()["failures"].empty());
}

TEST_F(Label, OnlyFailuresLeaveAManifestToo)
{
  for (const char* name : {"/a.pcd", "/b.pcd"})
    writeFile(input + name, "not a cloud");
  EXPECT_EQ(label().status, 1);
  EXPECT_EQ(outputs(), Words{"manifest.json"});
  EXPECT_EQ(manifest()["failures"].size(), 2u);
}

TEST_F(Label, TheSemanticKittiPair)
{
  ASSERT_EQ(label({"-format", "kitti"}).status, 0);
  EXPECT_EQ(outputs(),
            (Words{"classes.yaml",
                   "labels/a.label",
                   "labels/b.label",
                   "manifest.json",
                   "velodyne/a.bin",
                   "velodyne/b.bin"}));
  EXPECT_EQ(fs::file_size(output + "/velodyne/b.bin"), 800u * 16);
  EXPECT_EQ(fs::file_size(output + "/labels/b.label"), 800u * 4);
  // 12,800 bytes would be 640 points of 5 floats, too.
  expectSuccess(
      runApp(app, {output + "/velodyne/b.bin", path("again.pcd"), "-floats", "4"}));
  fs::remove(output + "/labels/b.label");
  EXPECT_NE(label({"-format", "kitti"}).err.find("1 were done before"),
            std::string::npos);
  EXPECT_TRUE(exists(output + "/labels/b.label"));
}

TEST_F(Label, PlyInAndOut)
{
  ASSERT_EQ(label({"-format", "ply"}).status, 0);
  EXPECT_EQ(outputs(), (Words{"a.ply", "b.ply", "manifest.json"}));
  expectSuccess(runApp(app, {output + "/b.ply", path("again.ply")}));
  EXPECT_EQ(readFile(path("again.ply")), readFile(output + "/b.ply"));
}

TEST_F(Label, BadRequestsAreRefused)
{
  const std::string cloud = input + "/a.pcd";
  const std::string out = path("o.pcd");
  expectRefused(runApp(app, {cloud, out, "-confidence", "1.1"}), 2, {"1.1", "0 to 1"});
  expectRefused(runApp(app, {cloud, out, "-format", "las"}), 2, {"las", "expected"});
  expectRefused(
      runApp(app, {cloud, out, "-format", "kitti"}), 2, {"kitti", "expected"});
  expectRefused(runApp(app, {cloud, out, "-overwrite"}), 2, {"-overwrite", "expected"});
  expectRefused(runApp(app, {cloud}), 2, {"expected"});
  expectRefused(runApp(app, {"-input_dir", input}), 2, {"-output_dir", "expected"});
  expectRefused(runApp(app, {path("no.pcd"), out}), 1, {path("no.pcd"), "expected"});
  expectRefused(runApp(app, {input, input}), 2, {input, "expected"});
  expectRefused(runApp(app, {input, cloud}), 1, {cloud, "directory", "expected"});
  fs::create_directory(path("empty"));
  expectRefused(
      runApp(app, {path("empty"), output}), 1, {".pcd or .ply or .bin", "expected"});
  writeFile(input + "/a.ply", "ply");
  expectRefused(label(), 1, {"a.pcd", "a.ply", "expected"});
  EXPECT_FALSE(exists(output));
  EXPECT_FALSE(exists(out));
}

TEST_F(Label, ModelsOfOneClassOrAnotherScaleAreRefused)
{
  const auto learn = [&](const std::string& cloud, const Words& options) {
    Words words{input + cloud};
    words.insert(words.end(), options.begin(), options.end());
    expectSuccess(runApp("pcl_shape_histogram", words));
  };
  const auto add = [&](const std::string& model, const Words& scale) {
    for (const auto& [cloud, name] :
         {std::pair{"/a.pcd", "planar"}, std::pair{"/b.pcd", "folded"}}) {
      Words options{model, "-name", name};
      options.insert(options.end(), scale.begin(), scale.end());
      learn(cloud, options);
      if (std::string(name) == "planar")
        expectRefused(label({"-model", model}), 1, {model, "1 class", "expected"});
    }
  };
  const std::string meters = path("meters.json"), spacings = path("spacings.json");
  add(meters, {"-radius", "0.03", "-normal_radius", "0.03"});
  expectRefused(
      label({"-model", meters}), 1, {meters, "-scale fixed", "-scale density"});
  add(spacings, {"-scale", "density", "-radius", "7", "-normal_radius", "5"});
  ASSERT_EQ(label({"-model", spacings}).status, 0);
  EXPECT_TRUE(manifest()["counts"].contains("folded"));
  EXPECT_NE(manifest()["parameters"]["model"], "default");
}

TEST_F(Label, AKilledRunLeavesNothingHalfWrittenAndIsResumed)
{
  for (int i = 0; i < 8; ++i)
    writeFile(input + "/c" + std::to_string(i) + ".pcd",
              asciiCloud("x y z", "F F F", foldRows(60)));
  RunningApp running(app, {input, output, "-format", "kitti"});
  running.waitUntil([&] { return exists(output + "/manifest.json"); });
  running.kill();
  const std::size_t done = manifest()["files"].size();
  EXPECT_LT(done, 10u) << "killed too late for this test";
  for (const Json& file : manifest()["files"])
    for (const Json& out : file["outputs"])
      EXPECT_EQ(fs::file_size(output + '/' + out["name"].get<std::string>()),
                out["bytes"]);
  writeFile(output + "/labels/c7.label.2147483646.tmp", "of a killed process");
  const Outcome outcome = label({"-format", "kitti"});
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_NE(outcome.err.find(std::to_string(done) + " were done before"),
            std::string::npos)
      << outcome.err;
  EXPECT_EQ(manifest()["files"].size(), 10u);
  for (const std::string& name : outputs())
    EXPECT_EQ(name.find(".tmp"), std::string::npos) << name;
}

} // namespace
