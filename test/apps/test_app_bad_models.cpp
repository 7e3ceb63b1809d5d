// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Damaged model files, and models that disagree with the options.

#include "app_test.h"

#include <nlohmann/json.hpp>

#include <functional>

namespace {

using namespace pcl_shape_test;
using Json = nlohmann::ordered_json;

const std::string histogram = "pcl_shape_histogram";

class Models : public AppTest {
protected:
  Models()
  : plane(file("plane.pcd", asciiCloud("x y z", "F F F", planeRows(12))))
  , fold(file("fold.pcd", asciiCloud("x y z", "F F F", foldRows(12))))
  {}

  std::string
  makeModel() const
  {
    expectSuccess(runApp(histogram, {plane, path("m.json"), "-radius", "0.02"}));
    return path("m.json");
  }

  const std::string plane;
  const std::string fold;
};

struct Damage {
  std::string name;
  std::function<std::string(Json model)> damage;
  Words words;
};

void
PrintTo(const Damage& damage, std::ostream* stream)
{
  *stream << damage.name;
}

std::string
changed(Json model, const std::string& pointer, const Json& value)
{
  model[Json::json_pointer(pointer)] = value;
  return model.dump();
}

std::string
textChanged(std::string text, const std::string& from, const std::string& to)
{
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return text.replace(at, from.size(), to);
}

std::vector<Damage>
damages()
{
  return {
      {"empty", [](const Json&) { return ""; }, {}},
      {"text", [](const Json&) { return "Dear reader"; }, {}},
      {"truncated",
       [](const Json& m) { return m.dump().substr(0, m.dump().size() / 2); },
       {}},
      {"last_byte",
       [](const Json& m) { return m.dump().substr(0, m.dump().size() - 1); },
       {}},
      {"other_version",
       [](const Json& m) { return changed(m, "/version", 2); },
       {"2", "1"}},
      {"other_format",
       [](const Json& m) { return changed(m, "/format", "x"); },
       {"format"}},
      {"negative_count",
       [](const Json& m) { return changed(m, "/classes/0/counts/0/1", -3); },
       {"-3"}},
      {"fraction",
       [](const Json& m) { return changed(m, "/classes/0/counts/0/1", 0.5); },
       {"0.5"}},
      {"fewer_rows", [](const Json& m) { return changed(m, "/bins/mu", 11); }, {"11"}},
      {"fewer_columns",
       [](const Json& m) { return changed(m, "/bins/sigma", 11); },
       {"11"}},
      {"no_bins", [](const Json& m) { return changed(m, "/bins/mu", 0); }, {"0"}},
      {"nan_radius",
       [](const Json& m) {
         return textChanged(m.dump(), "\"radius\":0.02", "\"radius\":NaN");
       },
       {}},
      {"null_radius",
       [](const Json& m) { return changed(m, "/parameters/radius", nullptr); },
       {"radius", "null"}},
      {"negative_radius",
       [](const Json& m) { return changed(m, "/parameters/radius", -1); },
       {"-1"}},
      {"prior_zero",
       [](const Json& m) { return changed(m, "/classes/0/prior", 0); },
       {"0"}},
      {"no_classes",
       [](const Json& m) { return changed(m, "/classes", Json::array()); },
       {}}};
}

class DamagedModels : public Models, public ::testing::WithParamInterface<Damage> {};

TEST_P(DamagedModels, AreRefusedAndStay)
{
  const Json model = Json::parse(readFile(makeModel()));
  const std::string damaged = GetParam().damage(model);
  const std::string name = file("damaged.json", damaged);
  Words words = GetParam().words;
  words.push_back(name);
  for (const char* app : {"pcl_shape_back_projection", "pcl_shape_edge_detection"})
    expectRefused(runApp(app, {plane, path("out.pcd"), "-model", name}), 1, words);
  expectRefused(runApp(histogram, {plane, name, "-radius", "0.02"}), 1, words);
  EXPECT_EQ(readFile(name), damaged);
  EXPECT_EQ(files(), (Words{"damaged.json", "fold.pcd", "m.json", "plane.pcd"}));
}

INSTANTIATE_TEST_SUITE_P(Models,
                         DamagedModels,
                         ::testing::ValuesIn(damages()),
                         [](const auto& info) { return info.param.name; });

TEST_F(Models, MissingOnesAreRefused)
{
  expectRefused(runApp("pcl_shape_back_projection",
                       {plane, path("out.pcd"), "-model", path("missing.json")}),
                1,
                {path("missing.json")});
  expectRefused(
      runApp("pcl_shape_back_projection", {plane, path("out.pcd"), "-model", path("")}),
      1,
      {path(""), "directory"});
}

TEST_F(Models, OtherRadiiAreRefusedUnlessToldSo)
{
  const std::string model = makeModel();
  const Words arguments{
      fold, path("out.pcd"), "-mode", "paper", "-model", model, "-radius", "0.03"};
  for (const char* app : {"pcl_shape_back_projection", "pcl_shape_edge_detection"}) {
    expectRefused(runApp(app, arguments),
                  1,
                  {model, "radius", "0.03", "0.02", "-ignore_model_parameters"});
    EXPECT_FALSE(exists(path("out.pcd")));
  }
  for (const Words& other : {Words{"-radius", "0.03"}, Words{"-k", "30"}}) {
    Words ignoring{fold,
                   path("out.pcd"),
                   "-mode",
                   "paper",
                   "-model",
                   model,
                   "-ignore_model_parameters"};
    ignoring.insert(ignoring.end(), other.begin(), other.end());
    expectSuccess(runApp("pcl_shape_back_projection", ignoring));
  }
}

TEST_F(Models, ExtendingKeepsParametersAndBins)
{
  const std::string model = makeModel();
  const std::string before = readFile(model);
  expectRefused(runApp(histogram, {fold, model, "-radius", "0.03", "-name", "fold"}),
                1,
                {model, "radius", "0.03", "0.02", "expected"});
  expectRefused(
      runApp(histogram,
             {fold, model, "-radius", "0.02", "-bins", "20", "-name", "fold"}),
      1,
      {model, "20 x 20", "10 x 10", "expected"});
  EXPECT_EQ(readFile(model), before);

  expectSuccess(runApp(
      histogram, {fold, model, "-radius", "0.02", "-name", "fold", "-prior", "0.25"}));
  const Json extended = Json::parse(readFile(model));
  ASSERT_EQ(extended["classes"].size(), 2u);
  EXPECT_EQ(extended["classes"][0], Json::parse(before)["classes"][0]);
  EXPECT_EQ(extended["classes"][1]["name"], "fold");
  EXPECT_EQ(extended["classes"][1]["prior"], 0.25);
}

TEST_F(Models, SamplesOfOneClassAddUp)
{
  const std::string model = makeModel();
  expectSuccess(runApp(histogram, {plane, model, "-json", path("json")}));
  const Json classes = Json::parse(readFile(model))["classes"];
  ASSERT_EQ(classes.size(), 1u);
  EXPECT_EQ(classes[0]["name"], "plane");
  EXPECT_EQ(classes[0]["counts"][0][0], 2 * 144);
  EXPECT_EQ(Json::parse(readFile(path("json")))["histogram"]["peak"], 2 * 144);
}

TEST_F(Models, EdgesNeedOneClass)
{
  const std::string model = makeModel();
  expectSuccess(runApp(histogram, {fold, model, "-name", "fold"}));
  expectRefused(runApp("pcl_shape_edge_detection",
                       {fold, path("out.pcd"), "-mode", "paper", "-model", model}),
                1,
                {model, "2 classes", "expected one"});
}

TEST_F(Models, SamplesWithoutACountedPointAreRefused)
{
  const std::string empty =
      file("part.pcd",
           asciiCloud("x y z surface", "F F F U", withColumn(planeRows(12), "1")));
  const Words part{empty, path("new.json"), "-radius", "0.02", "-field", "surface"};
  Words other = part;
  other.insert(other.end(), {"-value", "2"});
  expectRefused(
      runApp(histogram, other), 1, {empty, "'surface'", "value 2", "expected"});
  EXPECT_FALSE(exists(path("new.json")));
  Words right = part;
  right.insert(right.end(), {"-value", "1"});
  expectSuccess(runApp(histogram, right));
}

TEST_F(Models, BadOutputPathsAreRefused)
{
  expectRefused(runApp(histogram, {plane, path("missing/m.json"), "-radius", "0.02"}),
                1,
                {path("missing/m.json"), "cannot be written", "expected"});
}

} // namespace
