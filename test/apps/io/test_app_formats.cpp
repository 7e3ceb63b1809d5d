// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// PLY and KITTI files; the reader and writer of PCL are the reference of PLY.

#include "app_test.h"
#include "io/any_cloud.h"
#include "io/errors.h"
#include "io/kitti_file.h"
#include "io/pcd.h"
#include "io/ply.h"

#include <pcl/conversions.h>
#include <pcl/io/ply_io.h>

#include <cstring>

// PLY and KITTI files; the reader and writer of PCL are the reference of PLY's.
namespace {

using namespace pcl_shape_test;
using namespace pcl::app;

class Formats : public AppTest {
protected:
  CloudFile
  cloud(const std::string& fields, const std::string& types, const Words& rows) const
  {
    return readCloud(file("in.pcd", asciiCloud(fields, types, rows)));
  }
};

void
expectSame(const CloudFile& a, const CloudFile& b)
{
  ASSERT_EQ(a.blob.fields.size(), b.blob.fields.size());
  for (std::size_t f = 0; f < a.blob.fields.size(); ++f) {
    EXPECT_EQ(a.blob.fields[f].name, b.blob.fields[f].name);
    EXPECT_EQ(a.blob.fields[f].datatype, b.blob.fields[f].datatype);
  }
  EXPECT_EQ(a.blob.width, b.blob.width);
  EXPECT_EQ(a.blob.height, b.blob.height);
  EXPECT_EQ(a.blob.data, b.blob.data);
  EXPECT_EQ(a.viewpoint, b.viewpoint);
}

TEST_F(Formats, PlyReadsBackAsItWas)
{
  CloudFile in = cloud("x y z label confidence",
                       "F F F U F",
                       {"0 1 2 3 0.5", "3 4 5 4294967295 1", "nan 0 0 0 0"});
  in.viewpoint = {1, 2, 3, 0.5f, 0.5f, 0.5f, 0.5f};
  const CloudFile back = decodePly("back.ply", encodePly(in));
  expectSame(in, back);
  EXPECT_TRUE(fieldsWithoutPly(in).empty());
}

TEST_F(Formats, PlyKeepsTheLayoutOfAnOrganizedCloud)
{
  CloudFile in = cloud("x y z", "F F F", {"0 1 2", "3 4 5", "6 7 8", "9 1 2"});
  in.blob.width = in.blob.height = 2;
  in.blob.row_step = 2 * in.blob.point_step;
  expectSame(in, decodePly("back.ply", encodePly(in)));
}

TEST_F(Formats, PclReadsOurPly)
{
  CloudFile in =
      cloud("x y z rgb label", "F F F U U", {"0 1 2 66051 3", "3 4 5 16711680 1"});
  writeFile(path("our.ply"), encodePly(in));
  pcl::PLYReader reader;
  pcl::PCLPointCloud2 blob;
  ASSERT_EQ(reader.read(path("our.ply"), blob), 0);
  pcl::PointCloud<pcl::PointXYZRGBL> points;
  pcl::fromPCLPointCloud2(blob, points);
  ASSERT_EQ(points.size(), 2u);
  EXPECT_EQ(points[1].y, 4.0f);
  EXPECT_EQ(points[0].label, 3u);
  EXPECT_EQ(points[0].r, 1);
  EXPECT_EQ(points[0].g, 2);
  EXPECT_EQ(points[0].b, 3);
}

TEST_F(Formats, WeReadPclsPly)
{
  pcl::PointCloud<pcl::PointXYZI> points(3, 1);
  for (std::size_t i = 0; i < points.size(); ++i) {
    points[i].x = static_cast<float>(i);
    points[i].intensity = 0.25f * static_cast<float>(i);
  }
  for (const bool is_binary : {true, false}) {
    ASSERT_EQ(pcl::io::savePLYFile(path("pcl.ply"), points, is_binary), 0);
    const CloudFile cloud = readAnyCloud(path("pcl.ply"));
    ASSERT_EQ(cloud.size(), 3u);
    EXPECT_EQ(floatsOf(cloud, "x")[2], 2.0f);
    EXPECT_EQ(floatsOf(cloud, "intensity")[1], 0.25f);
  }
}

TEST_F(Formats, PlyLeavesOutWhatItCannotHold)
{
  CloudFile in = cloud("x y z", "F F F", {"0 1 2"});
  pcl::PCLPointField field = in.blob.fields.back();
  field.name = "time";
  field.datatype = pcl::PCLPointField::UINT64;
  field.offset = 12;
  in.blob.fields.push_back(field);
  field.name = "pair";
  field.datatype = pcl::PCLPointField::FLOAT32;
  field.count = 2;
  field.offset = 20;
  in.blob.fields.push_back(field);
  in.blob.point_step = 28;
  in.blob.data.resize(28);
  EXPECT_EQ(fieldsWithoutPly(in), Words{"time"});
  const CloudFile back = decodePly("back.ply", encodePly(in));
  EXPECT_TRUE(findField(back, "pair_0") && findField(back, "pair_1"));
  EXPECT_FALSE(findField(back, "time"));
}

TEST_F(Formats, FacesAfterTheVerticesAreLeftOut)
{
  const std::string header = "ply\r\nformat ascii 1.0\r\ncomment by hand\r\nelement "
                             "vertex 2\r\nproperty float "
                             "x\nproperty float y\nproperty float32 z\nelement face "
                             "1\nproperty list uchar int "
                             "vertex_indices\nend_header\n";
  const CloudFile cloud = decodePly("a.ply", header + "0 1 2\n3 4 5\n3 0 1 0\n");
  EXPECT_EQ(floatsOf(cloud, "z"), (std::vector<float>{2.0f, 5.0f}));
}

TEST_F(Formats, BadPlyIsRefused)
{
  const std::string xyz = "property float x\nproperty float y\nproperty float z\n";
  const std::string start = "ply\nformat binary_little_endian 1.0\n";
  const std::string bytes(24, '\0');
  ASSERT_EQ(
      decodePly("a.ply", start + "element vertex 2\n" + xyz + "end_header\n" + bytes)
          .size(),
      2u);
  for (const std::string& bad :
       {std::string(),
        std::string("plx\n"),
        start + "element vertex 2\n" + xyz,
        "ply\nformat binary_middle_endian 1.0\nelement vertex 2\n" + xyz +
            "end_header\n" + bytes,
        "ply\nelement vertex 2\n" + xyz + "end_header\n" + bytes,
        start + "end_header\n" + bytes,
        start + "element vertex 2\nend_header\n" + bytes,
        start + "element vertex 3\n" + xyz + "end_header\n" + bytes,
        start + "element vertex 0\n" + xyz + "end_header\n" + bytes,
        start + "element vertex -1\n" + xyz + "end_header\n" + bytes,
        start + "element vertex 268435456\n" + xyz + xyz + "end_header\n",
        start + "element vertex 100000000\n" + xyz + "end_header\n" + bytes,
        start + "element face 2\n" + xyz + "end_header\n" + bytes,
        start + "element vertex 2\nproperty list uchar int x\nend_header\n" + bytes,
        start + "element vertex 2\nproperty half x\nend_header\n" + bytes,
        start + "element vertex 2\nproperty\nend_header\n" + bytes,
        start + "element vertex 2\n" + xyz + "element vertex 2\n" + xyz +
            "end_header\n" + bytes + bytes,
        start + "element vertex 2\n" + xyz +
            "property list float int view_indices\nend_header\n" + bytes,
        start + "element camera 9\nproperty float view_px\nelement vertex 2\n" + xyz +
            "end_header\n" + bytes,
        start + "vertices 2\nend_header\n" + bytes}) {
    try {
      decodePly("a.ply", bad);
      ADD_FAILURE() << bad;
    }
    catch (const InputError& error) {
      EXPECT_NE(std::string(error.what()).find("a.ply: "), std::string::npos);
      EXPECT_NE(std::string(error.what()).find("expected"), std::string::npos) << bad;
    }
  }
}

TEST_F(Formats, VelodyneScansReadBackAsTheyWere)
{
  const CloudFile in = cloud("x intensity y z", "F F F F", {"0 0.5 1 2", "3 0.25 4 5"});
  const std::string bytes = encodeVelodyne(in);
  ASSERT_EQ(bytes.size(), 32u);
  float fourth = 0.0f;
  std::memcpy(&fourth, bytes.data() + 12, sizeof(fourth));
  EXPECT_EQ(fourth, 0.5f);
  const CloudFile back = decodeVelodyne("a.bin", bytes);
  EXPECT_EQ(floatsOf(back, "z"), (std::vector<float>{2.0f, 5.0f}));
  EXPECT_EQ(encodeVelodyne(back), bytes);
  EXPECT_THROW(decodeVelodyne("a.bin", bytes.substr(1)), InputError);
  EXPECT_THROW(decodeVelodyne("a.bin", ""), InputError);
  const CloudFile plain = cloud("x y z", "F F F", {"0 1 2"});
  EXPECT_EQ(encodeVelodyne(plain).substr(12), std::string(4, '\0'));
}

TEST_F(Formats, LabelsAreFourBytesEach)
{
  EXPECT_EQ(encodeLabels({1, 0x0203}), std::string("\1\0\0\0\3\2\0\0", 8));
}

TEST_F(Formats, KittiClassesHaveTheKeysOfSemanticKitti)
{
  const std::string yaml = encodeKittiClasses({{"unlabeled", 0.25}, {"planar", 0.75}});
  EXPECT_NE(yaml.find("labels:\n  0: \"unlabeled\"\n  1: \"planar\"\n"),
            std::string::npos);
  EXPECT_NE(yaml.find("content:\n  0: 0.25\n  1: 0.75\n"), std::string::npos);
  EXPECT_NE(yaml.find("learning_ignore:\n  0: True\n  1: False\n"), std::string::npos);
  for (const char* key : {"color_map:",
                          "learning_map:",
                          "learning_map_inv:",
                          "split:\n  train:\n    - 0"})
    EXPECT_NE(yaml.find('\n' + std::string(key)), std::string::npos) << key;
}

} // namespace
