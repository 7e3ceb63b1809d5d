// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Model files read back as they were; damaged ones are refused.

#include "support/errors.h"
#include "support/temporary_directory.h"

#include <pcl/exceptions.h>
#include <pcl/features/shape_model.h>

#include <gtest/gtest.h>

#include <csignal>
#include <filesystem>

#include <sys/resource.h>

namespace {

using namespace pcl;
using namespace pcl::test;

ShapeModel
model()
{
  ShapeHistogram flat(2, 3, 1.5, 0.75), curved(2, 3, 1.5, 0.75);
  flat.add(0, 0, 40);
  flat.add(1, 2, 2);
  curved.add(1, 1, 12345678901234ULL);
  ShapeModel model({0.02, 0.010000000000000002, 0, 1.5});
  model.add("flat", flat, 0.3);
  model.add("curved \"ä\"", curved);
  model.setFloor(1.0 / 3);
  return model;
}

class ShapeModelFile : public testing::Test {
protected:
  ShapeModelFile()
  {
    model().save(file_);
    text_ = contentOf(file_);
  }

  /** \brief The text of the file with one part changed. */
  std::string
  changed(const std::string& from, const std::string& to) const
  {
    const std::size_t at = text_.find(from);
    EXPECT_NE(std::string::npos, at) << from << " is not in " << text_;
    return std::string(text_).replace(at, from.size(), to);
  }

  void
  expectRefused(const std::string& text, std::vector<std::string> parts) const
  {
    writeFile(file_, text);
    const std::string message =
        exceptionOf<IOException>([&] { ShapeModel::load(file_); });
    parts.push_back(file_);
    expectParts(message, parts);
  }

  TemporaryDirectory directory_;
  std::string file_ = directory_.file("model.json");
  std::string text_;
};

TEST_F(ShapeModelFile, RoundTrip)
{
  const ShapeModel expected = model(), loaded = ShapeModel::load(file_);
  EXPECT_EQ("", expected.disagreement(loaded.parameters()));
  EXPECT_EQ(expected.parameters().radius, loaded.parameters().radius);
  EXPECT_EQ(expected.floor(), loaded.floor());
  ASSERT_EQ(expected.classes().size(), loaded.classes().size());
  for (std::size_t c = 0; c < loaded.classes().size(); ++c) {
    const ShapeModel::Class &a = expected.classes()[c], &b = loaded.classes()[c];
    EXPECT_EQ(a.name, b.name);
    EXPECT_EQ(a.prior, b.prior);
    EXPECT_TRUE(a.histogram.sameBins(b.histogram));
    for (std::size_t i = 0; i < 6; ++i)
      EXPECT_EQ(a.histogram.count(i / 3, i % 3), b.histogram.count(i / 3, i % 3));
  }
  loaded.save(file_);
  EXPECT_EQ(text_, contentOf(file_));
}

TEST_F(ShapeModelFile, RoundTripOfNearestPoints)
{
  ShapeModel::idealPlane({0.0, 0.0, 12, 2.0}).save(file_);
  EXPECT_EQ(12, ShapeModel::load(file_).parameters().k);
}

TEST_F(ShapeModelFile, RoundTripOfSmoothing)
{
  for (const auto mode : {AdaptiveRadius::FIXED, AdaptiveRadius::DENSITY}) {
    INADParameters parameters;
    parameters.radius_mode = mode;
    ShapeModel smooth = ShapeModel::idealPlane(parameters);
    smooth.setSmoothing(1.5);
    smooth.save(file_);
    const ShapeModel loaded = ShapeModel::load(file_);
    EXPECT_EQ(1.5, loaded.smoothing());
    EXPECT_EQ(mode, loaded.parameters().radius_mode);
  }
}

TEST_F(ShapeModelFile, Truncated)
{
  for (const std::size_t size : {std::size_t{0}, text_.size() / 2, text_.size() - 3})
    expectRefused(text_.substr(0, size), {"complete JSON"});
}

TEST_F(ShapeModelFile, NotJson) { expectRefused("# .PCD v0.7\n", {"JSON"}); }

TEST_F(ShapeModelFile, SomethingAfterTheEnd) { expectRefused(text_ + "{}", {"JSON"}); }

TEST_F(ShapeModelFile, OtherJson)
{
  for (const char* other : {"[]", "7", "{}", "{\"format\": \"glTF\"}"})
    expectRefused(other, {"not a shape model", "\"format\": \"pcl_shape model\""});
}

TEST_F(ShapeModelFile, OtherVersion)
{
  const std::string allowed = "only version 1";
  expectRefused(changed("\"version\": 1", "\"version\": 2"), {"version is 2", allowed});
  expectRefused(changed("\"version\": 1,", ""), {"version is missing", allowed});
}

TEST_F(ShapeModelFile, MissingMember)
{
  expectRefused(changed("\"floor\"", "\"flor\""), {"has no 'floor'"});
  expectRefused(changed("\"k\": 0,", ""), {"'parameters' has no 'k'"});
  expectRefused(changed("\"prior\": 0.3,", ""), {"a class has no 'prior'"});
}

TEST_F(ShapeModelFile, UnknownMember)
{
  expectRefused(changed("\"floor\"", "\"ceiling\": 1, \"floor\""),
                {"unknown member 'ceiling'"});
  expectRefused(changed("\"k\": 0", "\"k\": 0, \"kk\": 1"),
                {"'parameters' has an unknown member 'kk'"});
  expectRefused(changed("\"prior\": 0.3", "\"prior\": 0.3, \"weight\": 1"),
                {"a class has an unknown member 'weight'"});
}

TEST_F(ShapeModelFile, WrongType)
{
  expectRefused(changed("\"radius\": 0.01", "\"radius\": \"0.01\", \"x\": 0.01"),
                {"'parameters'", "'x'"});
  expectRefused(changed("\"normal_radius\": 0.02", "\"normal_radius\": \"2 cm\""),
                {"'normal_radius' is \"2 cm\"", "must be a number"});
  expectRefused(changed("\"name\": \"flat\"", "\"name\": 3"),
                {"'name' is 3", "must be a string"});
  expectRefused("{\"format\": \"pcl_shape model\", \"version\": 1, \"parameters\": 1, "
                "\"bins\": 1, \"floor\": 0, \"classes\": 1}",
                {"'parameters'", "must be an object"});
}

TEST_F(ShapeModelFile, NaN)
{
  expectRefused(changed("\"prior\": 0.3", "\"prior\": NaN"), {"JSON"});
  expectRefused(changed("\"prior\": 0.3", "\"prior\": null"),
                {"'prior' is null", "must be a number"});
  expectRefused(changed("40", "null"), {"count null", "bin (0, 0)", "whole numbers"});
  expectRefused(changed("\"prior\": 0.3", "\"prior\": 1e999"), {"JSON"});
}

TEST_F(ShapeModelFile, BadCounts)
{
  const std::string allowed = "whole numbers, not negative";
  expectRefused(changed("40", "-40"), {"count -40", "bin (0, 0)", "'flat'", allowed});
  expectRefused(changed("40", "4.5"), {"count 4.5", "bin (0, 0)", "'flat'", allowed});
  expectRefused(changed("40", "\"40\""), {"count \"40\"", allowed});
  expectRefused(changed("40", "18446744073709551615"), {"count 2", "below 2^64"});
  expectRefused(changed("12345678901234", "0"), {"'curved \"ä\"' is empty"});
}

TEST_F(ShapeModelFile, BinsThatDoNotMatch)
{
  expectRefused(changed("\"mu\": 2", "\"mu\": 3"), {"must have 3 rows", "not 2"});
  expectRefused(changed("\"sigma\": 3", "\"sigma\": 4"),
                {"4 counts in each row", "row 0"});
  expectRefused(changed("40,", ""), {"3 counts in each row", "'flat'", "row 0"});
}

TEST_F(ShapeModelFile, BadBins)
{
  expectRefused(changed("\"mu\": 2", "\"mu\": 0"), {"mu_bins is 0", "1 to 4096"});
  expectRefused(changed("\"mu\": 2", "\"mu\": 99999999999"), {"1 to 4096"});
  expectRefused(changed("\"mu\": 2", "\"mu\": -2"), {"'mu' is -2", "not negative"});
  expectRefused(changed("\"mu_range\": 1.5", "\"mu_range\": 0"),
                {"mu_range is 0", "positive and finite"});
}

TEST_F(ShapeModelFile, BadParameters)
{
  expectRefused(changed("\"normal_radius\": 0.02", "\"normal_radius\": -0.02"),
                {"normal radius -0.02", "must be positive"});
  expectRefused(changed("\"k\": 0", "\"k\": 12"), {"k 12", "k 0"});
  expectRefused(changed("\"k\": 0", "\"k\": -1"), {"'k' is -1", "not negative"});
  expectRefused(changed("\"k\": 0", "\"k\": 4294967296"), {"'k'", "at most 2^31 - 1"});
  expectRefused(changed("\"outlier_rate\": 1.5", "\"outlier_rate\": -1"),
                {"outlier rate -1", "0 or positive"});
  expectRefused(changed("\"prior\": 0.3", "\"prior\": 0"), {"prior of class 'flat'"});
  expectRefused(changed("\"floor\": 0.33", "\"floor\": -0.33"), {"floor -0.33"});
}

TEST_F(ShapeModelFile, BadClasses)
{
  expectRefused(changed("\"name\": \"flat\"", "\"name\": \"\""), {"needs a name"});
  expectRefused(changed("curved \\\"ä\\\"", "flat"), {"'flat' occurs twice"});
  const std::size_t begin = text_.find("\"classes\"");
  expectRefused(text_.substr(0, begin) + "\"classes\": []}", {"has no class"});
  expectRefused(text_.substr(0, begin) + "\"classes\": {}}", {"must be an array"});
}

TEST_F(ShapeModelFile, MissingFile)
{
  const std::string missing = directory_.file("missing.json");
  expectParts(exceptionOf<IOException>([&] { ShapeModel::load(missing); }),
              {missing, "cannot be read", "No such file"});
}

TEST_F(ShapeModelFile, Directory)
{
  expectParts(exceptionOf<IOException>([&] { ShapeModel::load(directory_.path()); }),
              {directory_.path(), "is a directory"});
}

TEST_F(ShapeModelFile, SaveReplacesTheFileAsAWhole)
{
  const std::string old = directory_.file("old.json");
  std::filesystem::create_hard_link(file_, old);
  ShapeModel::idealPlane().save(file_);
  EXPECT_EQ(text_, contentOf(old));
  EXPECT_EQ("planar", ShapeModel::load(file_).classes()[0].name);
  EXPECT_EQ(2U, directory_.countFiles());
}

TEST_F(ShapeModelFile, SaveWithoutSpaceLeavesTheOldFile)
{
  rlimit old_limit{};
  getrlimit(RLIMIT_FSIZE, &old_limit);
  const auto old_handler = std::signal(SIGXFSZ, SIG_IGN);
  const rlimit limit{64, old_limit.rlim_max};
  setrlimit(RLIMIT_FSIZE, &limit);
  const std::string message =
      exceptionOf<IOException>([&] { ShapeModel::idealPlane().save(file_); });
  setrlimit(RLIMIT_FSIZE, &old_limit);
  std::signal(SIGXFSZ, old_handler);
  expectParts(message, {file_, "cannot be written"});
  EXPECT_EQ(text_, contentOf(file_));
  EXPECT_EQ(1U, directory_.countFiles());
}

TEST_F(ShapeModelFile, SaveToBadPaths)
{
  const std::string nowhere = directory_.file("no/such/model.json");
  expectParts(exceptionOf<IOException>([&] { model().save(nowhere); }),
              {nowhere, "cannot be written"});
  expectParts(exceptionOf<IOException>([&] { model().save(directory_.path()); }),
              {directory_.path(), "cannot be written"});
  EXPECT_EQ(1U, directory_.countFiles());
  const std::filesystem::path target = directory_.path();
  for (const auto& file : std::filesystem::directory_iterator(target.parent_path())) {
    const std::string name = file.path().filename();
    EXPECT_NE(0, name.rfind(target.filename().string() + ".", 0)) << name;
  }
}

TEST_F(ShapeModelFile, AModelWithoutAClassIsNotSaved)
{
  expectParts(exceptionOf<BadArgumentException>([&] { ShapeModel().save(file_); }),
              {"without a class", "add() one"});
  EXPECT_EQ(text_, contentOf(file_));
}

} // namespace
