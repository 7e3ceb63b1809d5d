// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Damaged clouds and bad paths are refused, and leave no output.

#include "app_test.h"

#include <unistd.h>

#include <sys/stat.h>

namespace {

using namespace pcl_shape_test;

struct BadCloud {
  std::string name;
  std::string contents;
  Words words;
};

void
PrintTo(const BadCloud& cloud, std::ostream* stream)
{
  *stream << cloud.name;
}

const std::string header_end = "WIDTH 1\nHEIGHT 1\nVIEWPOINT 0 0 0 1 0 0 0\nPOINTS 1\n";
const std::string xyz =
    "VERSION 0.7\nFIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nCOUNT 1 1 1\n";

std::string
sized(const std::string& width, const std::string& points, const std::string& data)
{
  return xyz + "WIDTH " + width + "\nHEIGHT 1\nPOINTS " + points + "\nDATA " + data;
}

std::string
littleEndian(std::uint32_t value)
{
  std::string bytes;
  for (int i = 0; i < 4; ++i, value >>= 8)
    bytes.push_back(static_cast<char>(value & 0xff));
  return bytes;
}

std::vector<BadCloud>
badHeaders()
{
  return {
      {"empty", "", {"empty"}},
      {"text",
       "Dear reader,\nthis is no cloud.\n",
       {"'Dear'", "VERSION", "PLY", ".bin"}},
      {"ply", "ply\nformat ascii 1.0\n", {"'ply'", "a PLY file with the ending .ply"}},
      {"zeros", std::string(300, '\0'), {"header line 1"}},
      {"no_data_line", xyz + header_end, {"DATA"}},
      {"negative_size",
       "FIELDS x y z\nSIZE 4 -4 4\nTYPE F F F\nCOUNT 1 1 1\n" + header_end +
           "DATA ascii\n1 2 3\n",
       {"'y'", "'-4'", "SIZE"}},
      {"size_three",
       "FIELDS x y z\nSIZE 4 4 3\nTYPE F F F\n" + header_end + "DATA ascii\n1 2 3\n",
       {"'z'", "'3'", "SIZE"}},
      {"type_letter",
       "FIELDS x y z\nSIZE 4 4 4\nTYPE F F Q\n" + header_end + "DATA ascii\n1 2 3\n",
       {"'z'", "'Q'", "TYPE"}},
      {"fewer_sizes",
       "FIELDS x y z\nSIZE 4 4\nTYPE F F F\n" + header_end + "DATA ascii\n1 2 3\n",
       {"SIZE", "2", "3"}},
      {"count_zero",
       "FIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nCOUNT 1 0 1\n" + header_end +
           "DATA ascii\n1 2 3\n",
       {"'y'", "COUNT", "'0'"}},
      {"count_huge",
       "FIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nCOUNT 1 4294967295 1\n" + header_end +
           "DATA binary\n",
       {"'y'", "COUNT", "'4294967295'"}},
      {"padding_only",
       "FIELDS _ _\nSIZE 4 4\nTYPE F F\n" + header_end + "DATA ascii\n1 2\n",
       {"padding", "x y z"}},
      {"no_fields", header_end + "DATA ascii\n1 2 3\n", {"FIELDS", "x y z"}},
      {"no_size", xyz + "DATA ascii\n1 2 3\n", {"WIDTH"}},
      {"no_width", xyz + "HEIGHT 1\nPOINTS 1\nDATA ascii\n1 2 3\n", {"WIDTH"}},
      {"width_zero", sized("0", "0", "ascii\n"), {"WIDTH", "'0'", "from 1"}},
      {"width_negative", sized("-1", "1", "ascii\n1 2 3\n"), {"WIDTH", "'-1'"}},
      {"width_text", sized("many", "1", "ascii\n1 2 3\n"), {"WIDTH", "'many'"}},
      {"points_differ",
       sized("2", "3", "ascii\n1 2 3\n4 5 6\n"),
       {"WIDTH 2", "POINTS 3"}},
      {"data_word", sized("1", "1", "zipped\n"), {"'zipped'", "binary_compressed"}},
      {"version", "VERSION 0.8\n" + xyz.substr(12) + header_end, {"DATA"}},
      {"version_known",
       "VERSION 0.8\n" + xyz.substr(12) + header_end + "DATA ascii\n1 2 3\n",
       {"'0.8'", "0.7"}},
      {"viewpoint",
       xyz + "WIDTH 1\nHEIGHT 1\nVIEWPOINT 0 0 nan 1 0 0 0\nPOINTS 1\nDATA ascii\n1 2 "
             "3\n",
       {"VIEWPOINT", "'nan'", "finite"}},
      {"keyword_twice",
       "WIDTH 1\n" + xyz + header_end + "DATA ascii\n1 2 3\n",
       {"WIDTH"}}};
}

std::vector<BadCloud>
badBodies()
{
  return {
      {"huge_ascii", sized("2000000000", "2000000000", "ascii\n1 2 3\n"), {"WIDTH"}},
      {"large_ascii", sized("200000000", "200000000", "ascii\n1 2 3\n"), {"200000000"}},
      {"large_binary",
       sized("200000000", "200000000", "binary\nxx"),
       {"2400000000", "2"}},
      {"large_compressed",
       sized("200000000", "200000000", "binary_compressed\n") + littleEndian(9) +
           littleEndian(2400000000u) + "123456789",
       {"corrupt", "2400000000"}},
      {"cut_ascii", sized("2", "2", "ascii\n1.0 2.0 3.0\n"), {"truncated", "2"}},
      {"cut_binary", sized("2", "2", "binary\n") + std::string(23, 'x'), {"24", "23"}},
      {"cut_compressed",
       sized("2", "2", "binary_compressed\n") + littleEndian(20) + littleEndian(24) +
           "abc",
       {"truncated", "20", "3"}},
      {"compressed_nothing", sized("2", "2", "binary_compressed\n"), {"truncated"}},
      {"compressed_zero",
       sized("2", "2", "binary_compressed\n") + littleEndian(0) + littleEndian(0),
       {"0 bytes", "24"}},
      {"compressed_zero_of_24",
       sized("2", "2", "binary_compressed\n") + littleEndian(0) + littleEndian(24),
       {"corrupt", "24"}},
      {"compressed_other_size",
       sized("2", "2", "binary_compressed\n") + littleEndian(3) + littleEndian(48) +
           "abc",
       {"48", "24"}},
      {"compressed_corrupt",
       sized("2", "2", "binary_compressed\n") + littleEndian(4) + littleEndian(24) +
           "\xff\xff\xff\xff",
       {"corrupt", "24"}},
      {"row_short",
       sized("2", "2", "ascii\n1 2 3\n4.00 5.00\n"),
       {"point 1", "2", "3"}},
      {"row_long", sized("2", "2", "ascii\n1 2 3 4\n4 5 6\n"), {"point 0", "4", "3"}},
      {"row_extra", sized("1", "1", "ascii\n1 2 3\n4 5 6\n"), {"POINTS", "1"}},
      {"row_text", sized("1", "1", "ascii\n1 two 3\n"), {"point 0", "'two'", "'y'"}},
      {"row_out_of_range", sized("1", "1", "ascii\n1 2 1e39\n"), {"'1e39'", "'z'"}},
      {"fields_abc", asciiCloud("a b c", "F F F", {"1 2 3"}), {"'x'", "a b c"}},
      {"no_z", asciiCloud("x y", "F F", {"1 2"}), {"'z'", "x y"}},
      {"z_twice",
       "FIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nCOUNT 1 1 2\n" + header_end +
           "DATA ascii\n1 2 3 4\n",
       {"'z'", "COUNT", "2"}},
      {"all_nan",
       asciiCloud("x y z", "F F F", {"nan nan nan", "1 inf 3"}),
       {"2 points", "finite"}}};
}

class BadClouds : public AppTest, public ::testing::WithParamInterface<BadCloud> {
protected:
  /** \brief With no output file before, and with an old one. */
  void
  expectRefusedBy(const std::string& app,
                  const Words& options,
                  const std::string& cloud)
  {
    Words words = GetParam().words;
    words.push_back(cloud);
    words.emplace_back("expected");
    for (const char* output : {"new", "old"}) {
      Words arguments{cloud, path(output), "-json", path("json")};
      arguments.insert(arguments.end(), options.begin(), options.end());
      expectRefused(runApp(app, arguments), 1, words);
    }
    EXPECT_EQ(files(), (Words{"bad.pcd", "old"})) << app;
    EXPECT_EQ(readFile(path("old")), "as it was") << app;
  }
};

TEST_P(BadClouds, AreRefusedByEveryApp)
{
  const std::string cloud = file("bad.pcd", GetParam().contents);
  file("old", "as it was");
  expectRefusedBy("pcl_inad_estimation", {"-radius", "0.02"}, cloud);
  expectRefusedBy("pcl_shape_back_projection", {}, cloud);
  expectRefusedBy("pcl_shape_edge_detection", {}, cloud);
}

TEST_P(BadClouds, AreRefusedAsSamplesAndAsPredictions)
{
  const std::string cloud = file("bad.pcd", GetParam().contents);
  Words words = GetParam().words;
  words.push_back(cloud);
  words.emplace_back("expected");
  expectRefused(
      runApp("pcl_shape_histogram", {cloud, path("new.json"), "-radius", "0.02"}),
      1,
      words);
  EXPECT_EQ(files(), Words{"bad.pcd"});
  expectRefused(
      runApp("pcl_shape_evaluate", {cloud, cloud, "-json", path("json")}), 1, words);
  EXPECT_EQ(files(), Words{"bad.pcd"});
}

const auto name_of = [](const auto& info) { return info.param.name; };
INSTANTIATE_TEST_SUITE_P(Header, BadClouds, ::testing::ValuesIn(badHeaders()), name_of);
INSTANTIATE_TEST_SUITE_P(Body, BadClouds, ::testing::ValuesIn(badBodies()), name_of);

class BadPaths : public AppTest {
protected:
  void
  expectRefusedInput(const std::string& input, const Words& words) const
  {
    for (const char* app : {"pcl_shape_back_projection", "pcl_shape_edge_detection"})
      expectRefused(runApp(app, {input, path("out.pcd")}), 1, words);
    EXPECT_FALSE(exists(path("out.pcd")));
  }
};

TEST_F(BadPaths, MissingFile)
{
  expectRefusedInput(path("missing.pcd"), {"missing.pcd", "No such file", "expected"});
}

TEST_F(BadPaths, Directory)
{
  expectRefusedInput(path(""), {path(""), "is a directory", "expected"});
}

TEST_F(BadPaths, Device)
{
  expectRefusedInput("/dev/null", {"/dev/null", "not a regular file", "expected"});
}

TEST_F(BadPaths, UnreadableFile)
{
  if (geteuid() == 0)
    GTEST_SKIP() << "root may read everything";
  const std::string cloud = file("a.pcd", asciiCloud("x y z", "F F F", {"1 2 3"}));
  ASSERT_EQ(chmod(cloud.c_str(), 0), 0);
  expectRefusedInput(cloud, {cloud, "Permission denied", "expected"});
}

TEST_F(BadPaths, LineBreaksInNamesStayOnOneLine)
{
  expectRefusedInput(path("a\nb.pcd"), {"a?b.pcd", "No such file"});
}

} // namespace
