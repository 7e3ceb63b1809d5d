// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Damaged clouds are read or refused, and nothing else: every beginning of small files,
// and files with some bytes changed. scripts/test_sanitizers.sh looks for wrong
// accesses.

#include "io/any_cloud.h"
#include "io/errors.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <random>
#include <string>
#include <vector>

namespace {

using namespace pcl::app;

/** \brief How often each file is damaged; more if PCL_SHAPE_DAMAGED_FILES says so. */
int
damageCount()
{
  const char* const count = std::getenv("PCL_SHAPE_DAMAGED_FILES");
  return count ? std::atoi(count) : 1000;
}

/** \brief Read or refuse it. \return whether it is refused */
bool
isRefused(const std::string& name, const std::string& contents)
{
  try {
    const CloudFile cloud = decodeAnyCloud(name, contents);
    EXPECT_EQ(cloud.blob.data.size(), cloud.size() * cloud.blob.point_step);
    return false;
  }
  catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("expected"), std::string::npos)
        << error.what();
    return true;
  }
}

/** \brief Points with a field of each size, one of them with two values. */
CloudFile
someCloud()
{
  const std::string head = "VERSION .7\nFIELDS x y z rgb ring time pair\n"
                           "SIZE 4 4 4 4 1 8 2\nTYPE F F F F U F I\n"
                           "COUNT 1 1 1 1 1 1 2\nWIDTH 12\nHEIGHT 1\nPOINTS 12\n"
                           "DATA ascii\n";
  std::string rows;
  for (int i = 0; i < 12; ++i)
    rows += std::to_string(i) + " 0.5 nan 1 2 3.25 4 -5\n";
  return decodeAnyCloud("some.pcd", head + rows);
}

std::string
plyOf(const std::string& format, const std::string& body)
{
  return "ply\nformat " + format +
         " 1.0\nelement camera 1\nproperty float view_px\nelement vertex 2\n"
         "property float x\nproperty float y\nproperty float z\nproperty uchar red\n"
         "property uchar green\nproperty uchar blue\nproperty list uchar int seen\n"
         "end_header\n" +
         body;
}

/** \brief With carriage returns alone, up to and with the line that begins so. */
std::string
withOldLineEnds(std::string file, const std::string& last)
{
  const auto end = static_cast<std::ptrdiff_t>(file.find('\n', file.find(last)) + 1);
  std::replace(file.begin(), file.begin() + end, '\n', '\r');
  return file;
}

struct Whole {
  std::string name, contents;
};

std::vector<Whole>
wholeFiles()
{
  const CloudFile cloud = someCloud();
  const std::string no_list(12, '\1');
  const std::string vertex = no_list + "rgb" + '\0';
  const std::string list = no_list + "rgb" + '\1' + std::string(4, '\2');
  return {
      {"ascii.pcd", encodeAnyCloud("a.pcd", cloud, PCDFormat::ascii)},
      {"binary.pcd", encodeAnyCloud("a.pcd", cloud, PCDFormat::binary)},
      {"old.pcd",
       withOldLineEnds(encodeAnyCloud("a.pcd", cloud, PCDFormat::binary), "DATA")},
      {"old.ply",
       withOldLineEnds(
           plyOf("binary_little_endian", std::string(4, '\0') + list + vertex),
           "end_header")},
      {"compressed.pcd", encodeAnyCloud("a.pcd", cloud, PCDFormat::binary_compressed)},
      {"ascii.ply", plyOf("ascii", "1\n1 2 3 4 5 6 1 5\n1 2 3 4 5 6 0\n")},
      {"little.ply",
       plyOf("binary_little_endian", std::string(4, '\0') + list + vertex)},
      {"big.ply", plyOf("binary_big_endian", std::string(4, '\0') + vertex + vertex)},
      {"grid.ply",
       "ply\nformat ascii 1.0\nobj_info num_cols 2\nobj_info num_rows 2\nelement "
       "vertex "
       "2\nproperty float x\nproperty float y\nproperty float z\nelement range_grid "
       "4\nproperty list uchar int vertex_indices\nend_header\n1 2 3\n4 5 6\n1 "
       "0\n0\n0\n1 1\n"}};
}

TEST(Damage, WholeFilesAreRead)
{
  for (const Whole& whole : wholeFiles())
    EXPECT_FALSE(isRefused(whole.name, whole.contents)) << whole.name;
}

TEST(Damage, EveryBeginningIsRefused)
{
  for (const Whole& whole : wholeFiles()) {
    // The last end of a line, and the digit before it, may be missing from text.
    for (std::size_t size = 0; size + 2 < whole.contents.size(); ++size)
      EXPECT_TRUE(isRefused(whole.name, whole.contents.substr(0, size)))
          << whole.name << ' ' << size;
  }
}

TEST(Damage, ChangedBytesAreReadOrRefused)
{
  std::mt19937 random(7);
  const auto upTo = [&random](std::size_t last) {
    return std::uniform_int_distribution<std::size_t>(0, last)(random);
  };
  for (const Whole& whole : wholeFiles()) {
    int refused = 0;
    for (int i = 0; i < damageCount(); ++i) {
      std::string damaged = whole.contents;
      for (std::size_t changes = 1 + upTo(3); changes > 0; --changes)
        damaged[upTo(damaged.size() - 1)] = static_cast<char>(upTo(255));
      refused += isRefused(whole.name, damaged) ? 1 : 0;
    }
    EXPECT_GT(refused, damageCount() / 20) << whole.name;
  }
}

} // namespace
