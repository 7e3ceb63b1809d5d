// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// PCD files; the reader and writer of PCL are the reference.

#include "app_test.h"
#include "io/errors.h"
#include "io/pcd.h"

#include <pcl/io/pcd_io.h>

#include <cmath>
#include <cstring>
#include <limits>
#include <random>

namespace {

using namespace pcl::app;
using namespace pcl_shape_test;

class PCDTest : public AppTest {};

/** Every type, several values in a field, a color whose bits are a NaN, viewpoint. */
CloudFile
richCloud(std::uint32_t width, std::uint32_t height)
{
  using Field = pcl::PCLPointField;
  CloudFile cloud;
  cloud.blob.width = width;
  cloud.blob.height = height;
  cloud.viewpoint = {0.1f, -2.0f, 512345.6f, 0.5f, 0.5f, -0.5f, 0.5f};
  std::uint32_t offset = 0;
  const auto add = [&](const char* name, std::uint8_t type, std::uint32_t count) {
    Field field;
    field.name = name;
    field.datatype = type;
    field.count = count;
    field.offset = offset;
    cloud.blob.fields.push_back(field);
    offset += static_cast<std::uint32_t>(valueSize(type)) * count;
  };
  add("x", Field::FLOAT32, 1);
  add("y", Field::FLOAT32, 1);
  add("z", Field::FLOAT32, 1);
  add("rgb", Field::FLOAT32, 1);
  add("label", Field::UINT32, 1);
  add("small", Field::INT8, 1);
  add("ring", Field::UINT16, 1);
  add("stamp", Field::FLOAT64, 1);
  add("descriptor", Field::FLOAT32, 5);
  add("level", Field::INT16, 2);
  add("count", Field::INT32, 1);
  cloud.blob.point_step = offset;
  cloud.blob.row_step = offset * width;
  cloud.blob.data.resize(std::size_t{offset} * width * height);
  std::mt19937 random(1);
  std::uniform_real_distribution<float> meters(-1.0f, 1.0f);
  std::uniform_int_distribution<int> bytes(0, 255);
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    std::uint8_t* point = cloud.blob.data.data() + i * offset;
    for (std::uint32_t b = 0; b < offset; ++b)
      point[b] = static_cast<std::uint8_t>(bytes(random));
    float x = meters(random);
    for (const std::uint32_t at : {0u, 4u, 8u, 31u, 35u, 39u, 43u, 47u})
      std::memcpy(point + at, &(x *= -0.7f), sizeof(x));
    const double stamp = 1.6e9 + x;
    std::memcpy(point + 23, &stamp, sizeof(stamp));
    const std::uint32_t red_and_opaque = 0xffff0000u + static_cast<std::uint32_t>(i);
    std::memcpy(point + 12, &red_and_opaque, sizeof(red_and_opaque));
  }
  return cloud;
}

const pcl::PCLPointField&
lastField(const CloudFile& cloud)
{
  return cloud.blob.fields.back();
}

class EveryFormat : public PCDTest, public ::testing::WithParamInterface<PCDFormat> {};

TEST_P(EveryFormat, ReadsWhatItWrites)
{
  const CloudFile cloud = richCloud(31, 7);
  const CloudFile back = readCloud(file("a.pcd", encodeCloud(cloud, GetParam())));
  EXPECT_EQ(back.blob.data, cloud.blob.data);
  EXPECT_EQ(back.blob.width, 31u);
  EXPECT_EQ(back.blob.height, 7u);
  EXPECT_EQ(back.blob.point_step, cloud.blob.point_step);
  EXPECT_EQ(back.viewpoint, cloud.viewpoint);
  ASSERT_EQ(back.blob.fields.size(), cloud.blob.fields.size());
  EXPECT_EQ(lastField(back).name, "count");
  EXPECT_EQ(lastField(back).offset, lastField(cloud).offset);
}

TEST_P(EveryFormat, PCLReadsWhatItWrites)
{
  const CloudFile cloud = richCloud(31, 7);
  const std::string name = file("a.pcd", encodeCloud(cloud, GetParam()));
  pcl::PCLPointCloud2 blob;
  Eigen::Vector4f origin;
  Eigen::Quaternionf orientation;
  int version = 0;
  ASSERT_EQ(pcl::PCDReader().read(name, blob, origin, orientation, version), 0);
  EXPECT_EQ(blob.data, cloud.blob.data);
  EXPECT_EQ(blob.width, 31u);
  EXPECT_EQ(blob.height, 7u);
  EXPECT_EQ(origin.z(), cloud.viewpoint[2]);
  EXPECT_EQ(orientation.y(), cloud.viewpoint[5]);
}

TEST_P(EveryFormat, ReadsWhatPCLWrites)
{
  const CloudFile cloud = richCloud(31, 7);
  const std::string name = path("a.pcd");
  const Eigen::Vector4f origin(1.0f, 2.0f, 3.0f, 0.0f);
  const Eigen::Quaternionf orientation(0.5f, 0.5f, -0.5f, 0.5f);
  pcl::PCDWriter writer;
  constexpr int digits = 17;
  const int status =
      GetParam() == PCDFormat::ascii
          ? writer.writeASCII(name, cloud.blob, origin, orientation, digits)
      : GetParam() == PCDFormat::binary
          ? writer.writeBinary(name, cloud.blob, origin, orientation)
          : writer.writeBinaryCompressed(name, cloud.blob, origin, orientation);
  ASSERT_EQ(status, 0);
  const CloudFile back = readCloud(name);
  EXPECT_EQ(back.blob.data, cloud.blob.data);
  EXPECT_EQ(back.viewpoint, (std::array<float, 7>{1, 2, 3, 0.5f, 0.5f, -0.5f, 0.5f}));
}

INSTANTIATE_TEST_SUITE_P(PCD,
                         EveryFormat,
                         ::testing::Values(PCDFormat::ascii,
                                           PCDFormat::binary,
                                           PCDFormat::binary_compressed),
                         [](const auto& info) { return nameOf(info.param); });

/** A cloud with one field, of one byte. */
CloudFile
cloudOfBytes(std::vector<std::uint8_t> bytes)
{
  CloudFile cloud;
  addField(cloud, "a", pcl::PCLPointField::UINT8);
  cloud.blob.width = static_cast<std::uint32_t>(bytes.size());
  cloud.blob.height = 1;
  cloud.blob.data = std::move(bytes);
  return cloud;
}

std::string
compressed(const CloudFile& cloud)
{
  return encodeCloud(cloud, PCDFormat::binary_compressed);
}

TEST(LZF, RoundTrips)
{
  std::mt19937 random(2);
  for (const int alphabet : {1, 2, 5, 256})
    for (const std::size_t size :
         {1u, 2u, 3u, 31u, 32u, 33u, 264u, 265u, 9000u, 70000u}) {
      std::vector<std::uint8_t> input(size);
      for (auto& byte : input)
        byte = static_cast<std::uint8_t>(
            std::uniform_int_distribution<>(0, alphabet - 1)(random));
      const std::string file = compressed(cloudOfBytes(input));
      EXPECT_EQ(decodePcd("a.pcd", file).blob.data, input);
      EXPECT_EQ(compressed(cloudOfBytes(input)), file);
    }
}

TEST(LZF, CompressesRepetition)
{
  const std::vector<std::uint8_t> input(100000, 7);
  EXPECT_LT(compressed(cloudOfBytes(input)).size(), 1500u);
}

TEST(LZF, RefusesWhatWouldLeaveItsBounds)
{
  const auto decompress = [&](const std::vector<std::uint8_t>& input,
                              std::size_t points) {
    std::string file = "FIELDS a\nSIZE 1\nTYPE U\nCOUNT 1\nPOINTS " +
                       std::to_string(points) + "\nDATA binary_compressed\n";
    for (const std::size_t size : {input.size(), points})
      for (unsigned byte = 0; byte < 4; ++byte)
        file += static_cast<char>(size >> 8 * byte & 0xff);
    file.append(input.begin(), input.end());
    return decodePcd("a.pcd", file).blob.data;
  };
  EXPECT_THROW(decompress({}, 1), InputError) << "nothing";
  EXPECT_THROW(decompress({5, 'a'}, 6), InputError) << "literals beyond the input";
  EXPECT_THROW(decompress({1, 'a', 'b'}, 1), InputError)
      << "literals beyond the output";
  EXPECT_THROW(decompress({0x20, 0}, 3), InputError) << "match before the output";
  EXPECT_THROW(decompress({0, 'a', 0x20}, 4), InputError) << "match without distance";
  EXPECT_THROW(decompress({0, 'a', 0xe0, 1}, 14), InputError)
      << "long match without distance";
  EXPECT_THROW(decompress({0, 'a', 0x20, 0}, 3), InputError)
      << "match beyond the output";
  EXPECT_THROW(decompress({0, 'a'}, 2), InputError) << "too little";
  EXPECT_EQ(decompress({0, 'a', 0x20, 0}, 4),
            (std::vector<std::uint8_t>{'a', 'a', 'a', 'a'}));
}

TEST_F(PCDTest, EveryTruncationIsRefused)
{
  for (const PCDFormat format :
       {PCDFormat::ascii, PCDFormat::binary, PCDFormat::binary_compressed}) {
    const std::string whole = encodeCloud(richCloud(3, 2), format);
    // A number in text that lost digits is still a number: cut before the last one.
    const std::size_t end =
        whole.find_last_of(format == PCDFormat::ascii ? " " : whole);
    for (std::size_t size = 0; size < end; size += 5)
      EXPECT_THROW(readCloud(file("cut.pcd", whole.substr(0, size))), InputError)
          << nameOf(format) << " cut to " << size;
  }
}

TEST_F(PCDTest, AnyByteMayBeWrong)
{
  std::mt19937 random(3);
  std::size_t refused = 0;
  for (const PCDFormat format :
       {PCDFormat::ascii, PCDFormat::binary, PCDFormat::binary_compressed}) {
    const std::string whole = encodeCloud(richCloud(5, 4), format);
    for (int i = 0; i < 300; ++i) {
      std::string damaged = whole;
      damaged[std::uniform_int_distribution<std::size_t>(0, whole.size() - 1)(random)] =
          static_cast<char>(std::uniform_int_distribution<>(0, 255)(random));
      try {
        const CloudFile cloud = readCloud(file("damaged.pcd", damaged));
        EXPECT_EQ(cloud.blob.data.size(), cloud.size() * cloud.blob.point_step);
      }
      catch (const InputError&) {
        ++refused;
      }
    }
  }
  EXPECT_GT(refused, 150u);
}

TEST_F(PCDTest, NumbersInTextAreExact)
{
  const CloudFile cloud = readCloud(file(
      "a.pcd",
      asciiCloud("x y z", "F F F", {"1e-50 nan -inf", "0.1 1e30 1.17549435e-38"})));
  const std::vector<float> x = floatsOf(cloud, "x");
  const std::vector<float> y = floatsOf(cloud, "y");
  const std::vector<float> z = floatsOf(cloud, "z");
  EXPECT_EQ(x[0], 0.0f);
  EXPECT_TRUE(std::isnan(y[0]));
  EXPECT_EQ(z[0], -std::numeric_limits<float>::infinity());
  EXPECT_EQ(x[1], 0.1f);
  EXPECT_EQ(y[1], 1e30f);
  EXPECT_EQ(z[1], std::numeric_limits<float>::min());
}

} // namespace
