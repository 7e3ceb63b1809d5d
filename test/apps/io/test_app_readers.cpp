// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Files as other programs write them; where PCL reads one, its values are the
// reference.

#include "app_test.h"
#include "cli/input.h"
#include "io/any_cloud.h"
#include "io/errors.h"
#include "io/kitti_file.h"
#include "io/pcd.h"
#include "io/ply.h"
#include "io/text.h"

#include <pcl/io/pcd_io.h>
#include <pcl/io/ply_io.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <limits>
#include <optional>

namespace {

using namespace pcl::app;
using namespace pcl_shape_test;

class Readers : public AppTest {
protected:
  /** \brief Read a file of this name by both, and compare the fields by their names. */
  CloudFile
  sameAsPcl(const std::string& name, const std::string& contents) const
  {
    const std::string path = file(name, contents);
    const std::optional<CloudFile> theirs = readByPcl(path);
    EXPECT_TRUE(theirs) << name;
    CloudFile ours = readAnyCloud(path);
    if (theirs)
      expectSame(ours, *theirs);
    return ours;
  }

  static std::optional<CloudFile>
  readByPcl(const std::string& path)
  {
    CloudFile cloud;
    Eigen::Vector4f origin;
    Eigen::Quaternionf orientation;
    int version = 0;
    const int status =
        endingOf(path) == ".ply"
            ? pcl::PLYReader().read(path, cloud.blob, origin, orientation, version)
            : pcl::PCDReader().read(path, cloud.blob, origin, orientation, version);
    return status < 0 ? std::nullopt : std::make_optional(std::move(cloud));
  }

  static void
  expectSame(const CloudFile& ours, const CloudFile& theirs)
  {
    ASSERT_EQ(ours.blob.width, theirs.blob.width);
    ASSERT_EQ(ours.blob.height, theirs.blob.height);
    for (std::size_t f = 0; f < theirs.blob.fields.size(); ++f) {
      const pcl::PCLPointField& field = theirs.blob.fields[f];
      // In its place, unless padding is before it: names may be there twice.
      const pcl::PCLPointField* const same =
          f < ours.blob.fields.size() && ours.blob.fields[f].name == field.name
              ? &ours.blob.fields[f]
          : findField(ours, field.name) ? findField(ours, field.name)
                                        : findField(ours, toLower(field.name)); // X Y Z
      if (field.name == "_" || !same) {
        EXPECT_EQ(field.name, "_");
        continue;
      }
      EXPECT_EQ(same->datatype, field.datatype) << field.name;
      EXPECT_EQ(same->count, field.count) << field.name;
      const std::size_t bytes = valueSize(field.datatype) * field.count;
      for (std::size_t i = 0; i < ours.size(); ++i)
        ASSERT_EQ(std::memcmp(ours.at(i, *same), theirs.at(i, field), bytes), 0)
            << field.name << " of point " << i;
    }
  }
};

std::string
pcdHead(const std::string& types)
{
  return "VERSION .7\nFIELDS x y z\nSIZE 4 4 4\nTYPE " + types +
         "\nCOUNT 1 1 1\nWIDTH 2\nHEIGHT 1\nPOINTS 2\n";
}

template <typename T>
std::string
bytesOf(const std::vector<T>& values)
{
  std::string bytes(values.size() * sizeof(T), '\0');
  std::memcpy(bytes.data(), values.data(), bytes.size());
  return bytes;
}

std::string
reversed(std::string bytes, std::size_t size)
{
  for (std::size_t i = 0; i < bytes.size(); i += size)
    std::reverse(bytes.begin() + static_cast<std::ptrdiff_t>(i),
                 bytes.begin() + static_cast<std::ptrdiff_t>(i + size));
  return bytes;
}

const std::string xyz_properties =
    "property float x\nproperty float y\nproperty float z\n";
const std::string binary_ply = "ply\nformat binary_little_endian 1.0\n";
const std::vector<float> two_points{0.25f, 1.0f, 2.0f, 3.0f, -4.0f, 5.5f};

void
expectTwoPoints(const CloudFile& cloud)
{
  ASSERT_EQ(cloud.size(), 2u);
  EXPECT_EQ(floatsOf(cloud, "x"), (std::vector<float>{0.25f, 3.0f}));
  EXPECT_EQ(floatsOf(cloud, "y"), (std::vector<float>{1.0f, -4.0f}));
  EXPECT_EQ(floatsOf(cloud, "z"), (std::vector<float>{2.0f, 5.5f}));
}

const std::string two_rows = "0.25 1 2\n3 -4 5.5\n";

TEST_F(Readers, WordsOfAPcdHeaderInAnyCase)
{
  expectTwoPoints(sameAsPcl("type.pcd", pcdHead("f F f") + "DATA ascii\n" + two_rows));
  // PCL 1.15 knows these words in lower case alone.
  expectTwoPoints(decodePcd("data.pcd", pcdHead("F F F") + "DATA ASCII\n" + two_rows));
  expectTwoPoints(decodePcd("binary.pcd",
                            pcdHead("F F F") + "DATA Binary\n" + bytesOf(two_points)));
  expectTwoPoints(
      decodePcd("crlf.pcd",
                "# .PCD\r\nVERSION 0.7\r\nFIELDS X Y Z\r\nSIZE 4 4 4\r\nTYPE F F F\r\n"
                "WIDTH 2\r\nPOINTS 2\r\nDATA ascii\r\n0.25 1 2\r\n3 -4 5.5\r\n"));
}

TEST_F(Readers, MarksBeforeTheTextAreLeftOut)
{
  const std::string mark = "\xef\xbb\xbf";
  expectTwoPoints(
      decodePcd("marked.pcd", mark + pcdHead("F F F") + "DATA ascii\n" + two_rows));
  for (const char* const name : {"marked.ply", "marked"})
    expectTwoPoints(decodeAnyCloud(name,
                                   mark + "ply\nformat ascii 1.0\nelement vertex 2\n" +
                                       xyz_properties + "end_header\n" + two_rows));
}

TEST_F(Readers, OldPcdHeaders)
{
  expectTwoPoints(sameAsPcl(
      "old.pcd",
      "# .PCD v.5\nVERSION .5\nCOLUMNS x y z\nPOINTS 2\nDATA ascii\n" + two_rows));
  expectTwoPoints(sameAsPcl("width_as_float.pcd",
                            "FIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nCOUNT 1 1 1\nWIDTH "
                            "2.0\nHEIGHT 1\nPOINTS 2.0\nDATA ascii\n" +
                                two_rows));
  expectTwoPoints(decodePcd(
      "width.pcd",
      "FIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nWIDTH 2\nHEIGHT 1\nDATA ascii\n" +
          two_rows));
}

TEST_F(Readers, PaddingOfNoBytes)
{
  const std::string head =
      "VERSION 0.7\nFIELDS x y _ z _\nSIZE 4 4 1 4 1\nTYPE F F U F U\nCOUNT 1 1 0 1 "
      "4\nWIDTH 2\nHEIGHT 1\nPOINTS 2\nDATA binary\n";
  std::vector<float> values;
  for (std::size_t i = 0; i < two_points.size(); ++i) {
    values.push_back(two_points[i]);
    if (i % 3 == 2)
      values.push_back(0.0f); // the padding of four bytes
  }
  expectTwoPoints(sameAsPcl("hesai.pcd", head + bytesOf(values)));
  EXPECT_THROW(decodePcd("none.pcd",
                         "FIELDS a b\nSIZE 4 4\nTYPE F F\nCOUNT 0 0\nPOINTS 1\nDATA "
                         "binary\n"),
               InputError);
}

TEST_F(Readers, WhatFollowsTheValueOfAPcdHeader)
{
  expectTwoPoints(
      sameAsPcl("remarks.pcd",
                "VERSION 0.7 made by hand\nFIELDS x y z\nSIZE 4 4 4\nTYPE F F "
                "F\nCOUNT 1 1 1\nWIDTH 2 # columns\nHEIGHT 1 # row\nPOINTS 2 "
                "#\nDATA ascii # rows follow\n" +
                    two_rows));
  expectTwoPoints(sameAsPcl("no_line_end.pcd",
                            pcdHead("F F F") + "DATA ascii-1.5 2 3\n" + two_rows));
}

TEST_F(Readers, NumbersAsOthersWriteThem)
{
  expectTwoPoints(sameAsPcl(
      "plus.pcd", pcdHead("F F F") + "DATA ascii\n+0.25 +1. +2e0\n+3 -4 +5.5\n"));
  expectTwoPoints(decodePcd(
      "comments.pcd",
      pcdHead("F F F") + "DATA ascii\n# one\n0.25 1 2\n\n  # two\n3 -4 5.5\n# end\n"));
  const std::string whole =
      "FIELDS x y z a b c d\nSIZE 4 4 4 1 2 4 1\nTYPE F F F U I U I\nWIDTH 2\nPOINTS "
      "2\nDATA ascii\n0.25 1 2 7.0 -3.0 40.0 nan\n3 -4 5.5 255.0 2.75 -1 -1.0\n";
  const CloudFile cloud = decodePcd("whole.pcd", whole);
  expectTwoPoints(cloud);
  EXPECT_EQ(numbersOf(cloud, "a"), (std::vector<double>{7, 255}));
  EXPECT_EQ(numbersOf(cloud, "b"), (std::vector<double>{-3, 2}));
  EXPECT_EQ(numbersOf(cloud, "c"), (std::vector<double>{40, 4294967295}));
  EXPECT_EQ(numbersOf(cloud, "d"), (std::vector<double>{0, -1}));
  EXPECT_THROW(decodePcd("big.pcd",
                         "FIELDS x y z a\nSIZE 4 4 4 1\nTYPE F F F U\nPOINTS 1\nDATA "
                         "ascii\n1 2 3 256.0\n"),
               InputError);
  EXPECT_THROW(
      decodePcd("signs.pcd", pcdHead("F F F") + "DATA ascii\n+-1 2 3\n4 5 6\n"),
      InputError);
}

TEST_F(Readers, NanAndInfinityAsOthersWriteThem)
{
  for (const char* nan : {"nan",
                          "NaN",
                          "-nan",
                          "+nan",
                          "-nan(ind)",
                          "nan(snan)",
                          "1.#QNAN",
                          "-1.#IND",
                          "-1.#IND00",
                          "1.#QNAN00",
                          "1.#SNAN"}) {
    const CloudFile cloud = decodePcd(
        "nan.pcd", pcdHead("F F F") + "DATA ascii\n" + nan + " 1 2\n3 -4 5.5\n");
    EXPECT_TRUE(std::isnan(floatsOf(cloud, "x")[0])) << nan;
    EXPECT_EQ(floatsOf(cloud, "x")[1], 3.0f);
  }
  constexpr float infinity = std::numeric_limits<float>::infinity();
  for (const auto& [word, value] : {std::pair<const char*, float>{"inf", infinity},
                                    {"-inf", -infinity},
                                    {"Infinity", infinity},
                                    {"+INF", infinity},
                                    {"1.#INF", infinity},
                                    {"-1.#INF00", -infinity}})
    EXPECT_EQ(floatsOf(decodePcd("inf.pcd",
                                 pcdHead("F F F") + "DATA ascii\n" + word +
                                     " 1 2\n3 -4 5.5\n"),
                       "x")[0],
              value)
        << word;
}

TEST_F(Readers, PaddingIsLeftOutAndPclReadsTheRest)
{
  struct Point {
    float x, y, z, gap, rgb;
    char tail[12];
  };
  std::vector<Point> points(3);
  for (std::size_t i = 0; i < points.size(); ++i) {
    std::memset(&points[i], 0x7f, sizeof(Point));
    points[i].x = points[i].y = points[i].z = 1.0f + static_cast<float>(i);
    points[i].rgb = 2.0f;
  }
  const std::string head =
      "FIELDS x y z _ rgb _\nSIZE 4 4 4 1 4 1\nTYPE F F F U F U\nCOUNT 1 1 1 4 1 "
      "12\nWIDTH 3\nHEIGHT 1\nVIEWPOINT 0 0 0 1 0 0 0\nPOINTS 3\nDATA ";
  const CloudFile cloud = sameAsPcl("ros.pcd", head + "binary\n" + bytesOf(points));
  ASSERT_EQ(cloud.blob.fields.size(), 4u);
  EXPECT_EQ(floatsOf(cloud, "rgb"), (std::vector<float>{2, 2, 2}));
  for (const PCDFormat format :
       {PCDFormat::ascii, PCDFormat::binary, PCDFormat::binary_compressed})
    sameAsPcl("out.pcd", encodeCloud(cloud, format));
  // Compressed, PCL leaves the padding out of the data, but not out of the header.
  const std::string packed = encodeCloud(cloud, PCDFormat::binary_compressed);
  const std::string data = "binary_compressed\n";
  EXPECT_EQ(decodePcd("c.pcd", head + packed.substr(packed.find(data))).blob.data,
            cloud.blob.data);
  const CloudFile text = decodePcd(
      "t.pcd",
      "FIELDS x _ y z\nSIZE 4 1 4 4\nTYPE F U F F\nCOUNT 1 2 1 1\nPOINTS 2\nDATA "
      "ascii\n0.25 - ? 1 2\n3 0 999 -4 5.5\n");
  expectTwoPoints(text);
}

TEST_F(Readers, RepeatedNamesAreKept)
{
  const CloudFile cloud = sameAsPcl(
      "twice.pcd",
      "VERSION .7\nFIELDS x y z a a\nSIZE 4 4 4 4 4\nTYPE F F F F F\nCOUNT 1 1 1 1 "
      "1\nWIDTH 1\nHEIGHT 1\nPOINTS 1\nDATA ascii\n1 2 3 4 5\n");
  EXPECT_EQ(cloud.blob.fields.size(), 5u);
  EXPECT_EQ(floatsOf(cloud, "a"), std::vector<float>{4.0f});
  EXPECT_EQ(decodePcd("o.pcd", encodeCloud(cloud, PCDFormat::binary)).blob.data,
            cloud.blob.data);
  EXPECT_EQ(decodePly("o.ply", encodePly(cloud)).blob.data, cloud.blob.data);
}

TEST_F(Readers, PlyOfEitherOrderOfBytes)
{
  const std::string body = "element vertex 2\n" + xyz_properties + "end_header\n";
  expectTwoPoints(sameAsPcl("l.ply", binary_ply + body + bytesOf(two_points)));
  expectTwoPoints(sameAsPcl("b.ply",
                            "ply\nformat binary_big_endian 1.0\n" + body +
                                reversed(bytesOf(two_points), sizeof(float))));
  expectTwoPoints(decodeAnyCloud("SCAN.PLY", binary_ply + body + bytesOf(two_points)));
  expectTwoPoints(decodeAnyCloud("-", binary_ply + body + bytesOf(two_points)));
}

TEST_F(Readers, LinesThatEndWithACarriageReturnAlone) // as of Rhinoceros
{
  const auto old = [](std::string text) {
    std::replace(text.begin(), text.end(), '\n', '\r');
    return text;
  };
  const std::string body = "element vertex 2\n" + xyz_properties + "end_header\n";
  for (const char* const name : {"old.ply", "old"}) {
    expectTwoPoints(decodeAnyCloud(name, old(binary_ply + body) + bytesOf(two_points)));
    expectTwoPoints(
        decodeAnyCloud(name, old("ply\nformat ascii 1.0\n" + body + two_rows)));
  }
  const std::string head = pcdHead("F F F");
  expectTwoPoints(decodePcd(
      "b.pcd", old("# .PCD\n" + head + "DATA binary\n") + bytesOf(two_points)));
  expectTwoPoints(decodePcd("a.pcd", old(head + "DATA ascii\n" + two_rows)));
  for (const char* const cut : {"V\r", "DATA\r", "VERSION 0.7\rDATA", "\r"})
    EXPECT_THROW(decodePcd("cut.pcd", cut), InputError);
  for (const char* const cut : {"ply\r", "ply\rformat ascii 1.0\rend_header"})
    EXPECT_THROW(decodePly("cut.ply", cut), InputError);
}

TEST_F(Readers, ACarriageReturnInTheDataIsNoLineEnd)
{
  const auto old = [](std::string text) {
    std::replace(text.begin(), text.end(), '\n', '\r');
    return text;
  };
  const std::string bytes(two_points.size() * sizeof(float), '\r');
  const std::vector<std::uint8_t> data(bytes.size(), '\r');
  const std::string body = "element vertex 2\n" + xyz_properties + "end_header\n";
  EXPECT_EQ(decodePly("data.ply", old(binary_ply + body) + bytes).blob.data, data);
  const std::string ply = old(binary_ply + "comment format ascii 1.0\n" + body);
  EXPECT_EQ(decodePly("comment.ply", ply + bytes).blob.data, data);
  const std::string head = pcdHead("F F F");
  for (const std::string& file : {old(head + "data binary\n"),
                                  old(head + "  DATA  binary\n"),
                                  old("# DATA ascii\n" + head + "DATA binary\n"),
                                  "# a\r b\n" + head + "DATA binary\n"})
    EXPECT_EQ(decodePcd("data.pcd", file + bytes).blob.data, data) << file;
  for (const char* const line : {"DATA ASCII\n", "DATA  ascii\n"})
    expectTwoPoints(decodePcd("text.pcd", old(head + line + two_rows)));
}

TEST_F(Readers, WhatIsNoRemarkIsRefused)
{
  std::string head = pcdHead("F F F");
  EXPECT_THROW(decodePcd("a.pcd", head + "DATA asciibinary\n" + two_rows), InputError);
  head.insert(head.find('\n', head.find("WIDTH")), " 000");
  EXPECT_THROW(decodePcd("a.pcd", head + "DATA ascii\n" + two_rows), InputError);
  EXPECT_THROW(decodePly("a.ply",
                         "ply\nformat ascii 1.0\nelement vertex 2\n" + xyz_properties +
                             "comment a\npropertx float a\nend_header\n" + two_rows),
               InputError);
}

TEST_F(Readers, PlyCommentsOfSeveralLines)
{
  const std::string body = "element vertex 2\n" + xyz_properties + "end_header\n";
  expectTwoPoints(sameAsPcl("blender.ply",
                            "ply\nformat ascii 1.0\nCreated by Blender3D 247, source "
                            "file:\n" +
                                body + two_rows));
  expectTwoPoints(sameAsPcl("two.ply",
                            "ply\nformat ascii 1.0\ncomment one\n  and two\nand "
                            "three\n" +
                                body + two_rows));
  EXPECT_THROW(decodePly("word.ply",
                         "ply\nformat ascii 1.0\nelement vertex 2\n" + xyz_properties +
                             "propertx float a\nend_header\n" + two_rows),
               InputError);
}

TEST_F(Readers, PlyListsAndOtherElements)
{
  const std::string head =
      "element face 2\nproperty list uchar int vertex_indices\nproperty uchar "
      "flag\nelement nothing 7\nelement vertex 2\nproperty list uint16 float32 "
      "before\nproperty float32 x\nproperty float y\nproperty list uchar uint "
      "between\nproperty float z\nelement edge 1\nproperty int a\nend_header\n";
  const auto list = [](std::uint8_t count) {
    return std::string(1, static_cast<char>(count)) +
           bytesOf(std::vector<std::uint32_t>(count, 77));
  };
  const auto before = [](std::uint16_t count) {
    return bytesOf(std::vector<std::uint16_t>{count}) +
           bytesOf(std::vector<float>(count, 9.0f));
  };
  const std::string body = list(3) + 'f' + list(0) + 'f' + before(2) +
                           bytesOf(std::vector<float>{0.25f, 1.0f}) + list(1) +
                           bytesOf(std::vector<float>{2.0f}) + before(0) +
                           bytesOf(std::vector<float>{3.0f, -4.0f}) + list(200) +
                           bytesOf(std::vector<float>{5.5f});
  expectTwoPoints(decodePly("binary.ply", binary_ply + head + body));
  for (std::size_t size = 0; size < body.size(); size += 7)
    EXPECT_THROW(decodePly("cut.ply", binary_ply + head + body.substr(0, size)),
                 InputError);
  expectTwoPoints(decodePly(
      "text.ply",
      "ply\r\nformat ascii 1.0\r\nobj_info made by hand, num_cols 3\r\n" + head +
          "3 0 1 0 5\r\n0 5\n# a remark\n2 9 9 0.25 1 1 77 2\n0 3 -4 0 5.5\n1\n"));
  EXPECT_THROW(decodePly("short.ply", "ply\nformat ascii 1.0\n" + head + "3 0 1\n"),
               InputError);
}

TEST_F(Readers, PlyCamerasGiveTheViewpoint)
{
  const std::string camera =
      "element camera 1\nproperty float view_px\nproperty float view_py\nproperty "
      "float view_pz\n";
  const std::string vertex = "element vertex 2\n" + xyz_properties;
  const std::string place = bytesOf(std::vector<float>{7.0f, 8.0f, 9.0f});
  const CloudFile first = decodePly("f.ply",
                                    binary_ply + camera + vertex + "end_header\n" +
                                        place + bytesOf(two_points));
  const CloudFile last = decodePly("l.ply",
                                   binary_ply + vertex + camera + "end_header\n" +
                                       bytesOf(two_points) + place);
  for (const CloudFile* cloud : {&first, &last}) {
    expectTwoPoints(*cloud);
    EXPECT_EQ(cloud->viewpoint, (std::array<float, 7>{7, 8, 9, 1, 0, 0, 0}));
  }
  pcl::PointCloud<pcl::PointXYZ> points(2, 1);
  points.sensor_origin_ = Eigen::Vector4f(1, 2, 3, 0);
  points.sensor_orientation_ = Eigen::Quaternionf(0.5f, 0.5f, -0.5f, 0.5f);
  for (const bool is_binary : {true, false}) {
    ASSERT_EQ(pcl::io::savePLYFile(path("pcl.ply"), points, is_binary), 0);
    EXPECT_EQ(readAnyCloud(path("pcl.ply")).viewpoint,
              (std::array<float, 7>{1, 2, 3, 0.5f, 0.5f, -0.5f, 0.5f}));
  }
}

TEST_F(Readers, ImagesOfPclsPlyWriterAreOrganized)
{
  const float nan = std::numeric_limits<float>::quiet_NaN();
  CloudFile image;
  for (const char* const name : {"x", "y", "z"})
    addField(image, name, pcl::PCLPointField::FLOAT32);
  addField(image, "label", pcl::PCLPointField::UINT16);
  image.blob.width = 3;
  image.blob.height = 2;
  image.blob.row_step = 3 * image.blob.point_step;
  image.blob.is_dense = 0;
  for (std::uint16_t i = 0; i < 6; ++i) {
    const float x = i % 4 == 1 ? nan : 0.5f * static_cast<float>(i);
    const std::string point =
        bytesOf(std::vector<float>{x, x, x}) + bytesOf(std::vector<std::uint16_t>{i});
    image.blob.data.insert(image.blob.data.end(), point.begin(), point.end());
  }
  for (const bool is_binary : {true, false})
    for (const bool has_camera : {true, false}) { // else it has a range_grid
      pcl::PLYWriter().write(path("pcl.ply"),
                             image.blob,
                             Eigen::Vector4f::Zero(),
                             Eigen::Quaternionf::Identity(),
                             is_binary,
                             has_camera);
      const CloudFile ours = readAnyCloud(path("pcl.ply"));
      EXPECT_EQ(ours.blob.width, 3u);
      EXPECT_EQ(ours.blob.height, 2u);
      expectSame(ours, *readByPcl(path("pcl.ply")));
    }
  const std::string grid =
      "ply\nformat ascii 1.0\nobj_info num_cols 2\nobj_info num_rows "
      "2\nelement vertex 1\n" +
      xyz_properties +
      "element range_grid 4\nproperty list uchar int "
      "vertex_indices\nend_header\n1 2 3\n0\n1 0\n0\n";
  EXPECT_EQ(floatsOf(decodePly("grid.ply", grid + "0\n"), "z")[1], 3.0f);
  for (const char* const vertex : {"1 1\n", "1 -1\n"})
    EXPECT_THROW(decodePly("grid.ply", grid + vertex), InputError);
}

TEST_F(Readers, PlyImagesHaveTheSizeThatFits)
{
  const auto text = [](const std::string& more, const std::string& values) {
    return "ply\nformat ascii 1.0\nobj_info num_cols 3\nobj_info num_rows 2\n"
           "element vertex 6\n" +
           xyz_properties + more + "end_header\n" +
           "0 0 0\n1 1 1\n2 2 2\n3 3 3\n4 4 4\n5 5 5\n" + values;
  };
  const std::string camera =
      "element camera 1\nproperty int viewportx\nproperty int viewporty\n";
  const std::string grid = "element range_grid 6\nproperty float confidence\n"
                           "property list uchar float vertex_indices\n";
  const std::string pixels = "2.5 1 5\n1 1 4\n1 1 3\n1 1 2\n1 0\n1 1 ";
  const CloudFile picture = decodePly("p.ply", text(camera, "1280 1024\n"));
  EXPECT_EQ(picture.blob.width, 3u);
  EXPECT_EQ(picture.blob.height, 2u);
  EXPECT_EQ(decodePly("c.ply", text(camera, "2 3\n")).blob.width, 2u);
  const CloudFile both =
      decodePly("b.ply", text(camera + grid, "1280 1024\n" + pixels + "0\n"));
  EXPECT_EQ(both.blob.width, 3u);
  EXPECT_EQ(floatsOf(both, "z")[0], 5.0f);
  EXPECT_EQ(floatsOf(both, "z")[5], 0.0f);
  const auto refusal = [&](const std::string& more, const std::string& values) {
    try {
      decodePly("r.ply", text(more, values));
    }
    catch (const InputError& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  EXPECT_NE(refusal(grid, pixels + "-1\n").find("vertex -1;"), std::string::npos);
  EXPECT_NE(refusal(grid, pixels + "0.5\n").find("vertex 0.5;"), std::string::npos);
  EXPECT_NE(
      refusal("element range_grid 1\nproperty list uchar int vertex_indices\n", "1 0\n")
          .find("range_grid has 1 pixels"),
      std::string::npos);
}

TEST_F(Readers, CoordinatesMayBeWholeNumbers)
{
  const CloudFile pcd =
      sameAsPcl("whole.pcd", pcdHead("I I I") + "DATA ascii\n1 -2 3\n4 5 6\n");
  const CloudFile ply =
      sameAsPcl("whole.ply",
                "ply\nformat ascii 1.0\nelement vertex 2\nproperty int "
                "x\nproperty short y\nproperty uchar "
                "z\nend_header\n1 -2 3\n4 5 6\n");
  for (const CloudFile* const cloud : {&pcd, &ply}) {
    EXPECT_EQ((*pointsOf(*cloud))[0].y, -2.0f);
    EXPECT_EQ(coordinatesOf(*cloud)[1], (std::array<double, 3>{4.0, 5.0, 6.0}));
  }
  EXPECT_TRUE(exceedFloats(pcd)); // an offset keeps what float would round
}

/** What decodePcd() says of a file that it refuses. */
std::string
refusalOf(const std::string& file)
{
  try {
    decodePcd("bad.pcd", file);
  }
  catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST_F(Readers, NumbersOfAPcdHeaderAreWhole)
{
  const auto head =
      [](const std::string& size, const std::string& count, const std::string& width) {
        return "FIELDS x y z\nSIZE 4 4 " + size + "\nTYPE F F F\nCOUNT 1 1 " + count +
               "\nWIDTH " + width + "\nDATA ascii\n" + two_rows;
      };
  expectTwoPoints(decodePcd("whole.pcd", head("4.0", "+1", "2.0")));
  EXPECT_NE(refusalOf(head("4", "1", "2.5")).find("WIDTH is '2.5'"), std::string::npos);
  EXPECT_NE(refusalOf(head("4", "1.5", "2")).find("COUNT '1.5'"), std::string::npos);
  EXPECT_NE(refusalOf(head("4.5", "1", "2")).find("SIZE '4.5'"), std::string::npos);
  EXPECT_NE(refusalOf(head("4", "1", "nan")).find("WIDTH is 'nan'"), std::string::npos);
}

TEST_F(Readers, OtherFormatsAreToBeConverted)
{
  const std::string message = refusalOf("0.25 1 2\n");
  for (const char* const words :
       {"header line 1", "'0.25'", "convert other formats, such as LAS, E57 or XYZ,"})
    EXPECT_NE(message.find(words), std::string::npos) << message;
}

TEST_F(Readers, BooleansStayBooleans)
{
  const std::string head =
      "VERSION .7\nFIELDS x y z is\nSIZE 4 4 4 1\nTYPE F F F B\nCOUNT "
      "1 1 1 1\nWIDTH 2\nHEIGHT 1\nPOINTS 2\n";
  const CloudFile cloud =
      sameAsPcl("bool.pcd", head + "DATA ascii\n0.25 1 2 1\n3 -4 5.5 0\n");
  EXPECT_EQ(labelsOf(cloud, "is"), (std::vector<std::uint32_t>{1, 0}));
  sameAsPcl("again.pcd", encodeCloud(cloud, PCDFormat::binary_compressed));
  EXPECT_EQ(labelsOf(decodePly("bool.ply", encodePly(cloud)), "is"),
            labelsOf(cloud, "is"));
  const CloudFile ply = decodePly("pyntcloud.ply",
                                  binary_ply + "element vertex 1\n" + xyz_properties +
                                      "property bool is\nend_header\n" +
                                      bytesOf(std::vector<float>{1, 2, 3}) + '\1');
  EXPECT_EQ(ply.blob.fields.back().datatype, pcl::PCLPointField::BOOL);
  EXPECT_EQ(labelsOf(ply, "is"), std::vector<std::uint32_t>{1});
}

TEST_F(Readers, PointersOfGitLfsAreNamed)
{
  for (const char* const name : {"a.pcd", "a.ply", "a.bin", "a"})
    try {
      decodeAnyCloud(name,
                     "version https://git-lfs.github.com/spec/v1\noid sha256:0\n");
      FAIL() << name;
    }
    catch (const InputError& error) {
      EXPECT_NE(std::string(error.what()).find("git lfs pull"), std::string::npos);
    }
}

TEST_F(Readers, PlyColorsAndNormalsHaveThePclNames)
{
  const std::string colors = "property uchar red\nproperty uchar green\nproperty uchar "
                             "blue\n";
  const std::string normals =
      "property float nx\nproperty float ny\nproperty float nz\n";
  const auto text = [&](const std::string& more, const std::string& row) {
    return "ply\nformat ascii 1.0\nelement vertex 1\n" + xyz_properties + more +
           "end_header\n" + row + "\n";
  };
  const CloudFile rgb = sameAsPcl("c.ply", text(colors, "0 1 2 1 2 3"));
  const CloudFile rgba =
      sameAsPcl("a.ply", text(colors + "property uchar alpha\n", "0 1 2 1 2 3 4"));
  std::uint32_t packed = 0;
  std::memcpy(&packed, rgb.at(0, *findField(rgb, "rgb")), sizeof(packed));
  EXPECT_EQ(packed, 0x010203u);
  EXPECT_EQ(labelsOf(rgba, "rgba").front(), 0x04010203u);
  const CloudFile with_normals = sameAsPcl("n.ply", text(normals, "0 1 2 0.6 0 0.8"));
  EXPECT_EQ(normalsOf(with_normals)->front().normal_z, 0.8f);
  sameAsPcl("out.ply", encodePly(with_normals));
  EXPECT_EQ(decodePly("out.ply", encodePly(rgba, true)).blob.data, rgba.blob.data);
  const CloudFile diffuse = decodePly(
      "d.ply",
      text("property uchar diffuse_blue\nproperty uint8 diffuse_green\nproperty "
           "uchar diffuse_red\n",
           "0 1 2 3 2 1"));
  std::memcpy(&packed, diffuse.at(0, *findField(diffuse, "rgb")), sizeof(packed));
  EXPECT_EQ(packed, 0x010203u);
}

TEST_F(Readers, PlyOfTextIsReadByPcl)
{
  CloudFile cloud = decodePly("b.ply",
                              binary_ply + "element vertex 2\n" + xyz_properties +
                                  "end_header\n" + bytesOf(two_points));
  setField(cloud, "label", std::vector<std::uint32_t>{1, 4000000000u});
  expectTwoPoints(sameAsPcl("t.ply", encodePly(cloud, true)));
}

TEST_F(Readers, DoublesStayDoubles)
{
  const std::string ply =
      binary_ply +
      "element vertex 1\nproperty double x\nproperty float64 y\nproperty double "
      "z\nend_header\n" +
      bytesOf(std::vector<double>{500000.001, 5000000.002, 300.003});
  CloudFile cloud = decodePly("d.ply", ply);
  cloud.offset = {500000.0, 5000000.0, 300.0};
  cloud.viewpoint[2] = 302.0f;
  const auto points = pointsOf(cloud);
  EXPECT_EQ((*points)[0].x, static_cast<float>(500000.001 - 500000.0));
  EXPECT_EQ((*points)[0].y, static_cast<float>(5000000.002 - 5000000.0));
  EXPECT_EQ(points->sensor_origin_.z(), 2.0f);
  for (const PCDFormat format :
       {PCDFormat::ascii, PCDFormat::binary, PCDFormat::binary_compressed})
    EXPECT_EQ(numbersOf(sameAsPcl("d.pcd", encodeCloud(cloud, format)), "y")[0],
              5000000.002);
  EXPECT_EQ(numbersOf(decodePly("o.ply", encodePly(cloud)), "x")[0], 500000.001);
  EXPECT_EQ(numbersOf(decodePly("t.ply", encodePly(cloud, true)), "x")[0], 500000.001);
}

TEST_F(Readers, ScansOfFourOrFiveFloats)
{
  const std::string bytes = bytesOf(std::vector<float>(20, 1.0f));
  EXPECT_EQ(decodeVelodyne("a.bin", bytes, 4).size(), 5u);
  const CloudFile five = decodeVelodyne("a.bin", bytes, 5);
  EXPECT_EQ(five.size(), 4u);
  EXPECT_NE(findField(five, "ring"), nullptr);
  EXPECT_EQ(decodeVelodyne("a.bin", bytes.substr(0, 16)).size(), 1u);
  EXPECT_EQ(decodeVelodyne("a.bin", bytes.substr(0, 20)).blob.fields.size(), 5u);
  try {
    decodeVelodyne("a.bin", bytes);
    FAIL() << "nothing says whether it is 4 or 5";
  }
  catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("-floats 5"), std::string::npos);
  }
}

/** \brief The clouds of PCL's own repositories (doc/files.md lists them), in the
 * directory that PCL_SHAPE_PCL_FILES names. */
TEST_F(Readers, FilesOfPclsOwnRepositories)
{
  const char* const directory = std::getenv("PCL_SHAPE_PCL_FILES");
  if (!directory)
    GTEST_SKIP() << "PCL_SHAPE_PCL_FILES is not set";
  std::size_t read = 0;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(directory)) {
    const std::string path = entry.path();
    const std::string ending = endingOf(path);
    if (!entry.is_regular_file() || (ending != ".pcd" && ending != ".ply"))
      continue;
    SCOPED_TRACE(path);
    const std::optional<CloudFile> theirs = readByPcl(path);
    if (!theirs)
      continue;
    EXPECT_NO_THROW(expectSame(readAnyCloud(path), *theirs));
    ++read;
  }
  EXPECT_GT(read, 0u);
}

} // namespace
