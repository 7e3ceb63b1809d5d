// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Fields of a cloud in memory: read, appended, replaced.

#include "app_test.h"
#include "io/cloud_file.h"
#include "io/errors.h"
#include "io/pcd.h"

#include <cmath>

namespace {

using namespace pcl::app;
using namespace pcl_shape_test;

class FieldsTest : public AppTest {
protected:
  CloudFile
  cloud(const std::string& fields, const std::string& types, const Words& rows) const
  {
    return readCloud(file("a.pcd", asciiCloud(fields, types, rows)));
  }
};

TEST_F(FieldsTest, AppendsAndKeeps)
{
  CloudFile cloud = this->cloud("x y z ring", "F F F U", {"1 2 3 7", "4 5 6 8"});
  setField(cloud, "edge", std::vector<std::uint32_t>{0, 1});
  EXPECT_EQ(cloud.blob.fields.size(), 5u);
  EXPECT_EQ(labelsOf(cloud, "ring"), (std::vector<std::uint32_t>{7, 8}));
  EXPECT_EQ(labelsOf(cloud, "edge"), (std::vector<std::uint32_t>{0, 1}));
  EXPECT_EQ(floatsOf(cloud, "z"), (std::vector<float>{3, 6}));
}

TEST_F(FieldsTest, ReplacesWhateverTheTypeWas)
{
  CloudFile cloud = this->cloud("edge x y z", "F F F F", {"0.5 1 2 3", "0.5 4 5 6"});
  cloud.blob.fields[0].datatype = pcl::PCLPointField::UINT16;
  cloud.blob.fields[0].count = 2;
  setField(cloud, "edge", std::vector<std::uint32_t>{70000, 1});
  EXPECT_EQ(cloud.blob.fields.size(), 4u);
  EXPECT_EQ(cloud.blob.fields[0].datatype, pcl::PCLPointField::UINT32);
  EXPECT_EQ(cloud.blob.fields[0].count, 1u);
  EXPECT_EQ(labelsOf(cloud, "edge"), (std::vector<std::uint32_t>{70000, 1}));
  EXPECT_EQ(floatsOf(cloud, "x"), (std::vector<float>{1, 4}));
  EXPECT_EQ(floatsOf(cloud, "z"), (std::vector<float>{3, 6}));
}

TEST_F(FieldsTest, RefusesValuesOfAnotherNumber)
{
  CloudFile cloud = this->cloud("x y z", "F F F", {"1 2 3"});
  EXPECT_THROW(setField(cloud, "edge", std::vector<std::uint32_t>{0, 1}),
               std::logic_error);
}

TEST_F(FieldsTest, LabelsAreWholeNumbers)
{
  for (const char* value : {"0.5", "-1", "nan", "4294967296"}) {
    const CloudFile cloud =
        this->cloud("x y z label", "F F F F", {std::string("1 2 3 ") + value});
    EXPECT_THROW(labelsOf(cloud, "label"), InputError) << value;
  }
  EXPECT_EQ(labelsOf(cloud("x y z label", "F F F F", {"1 2 3 65536"}), "label").front(),
            65536u);
  EXPECT_EQ(labelsOf(cloud("x y z label", "F F F I", {"1 2 3 5"}), "label").front(),
            5u);
}

TEST_F(FieldsTest, PointsKeepTheViewpointAndKnowNaN)
{
  CloudFile cloud = this->cloud("x y z", "F F F", {"1 2 3", "nan 5 6"});
  cloud.viewpoint = {1, 2, 3, 0, 1, 0, 0};
  const auto points = pointsOf(cloud);
  EXPECT_FALSE(points->is_dense);
  EXPECT_EQ(countFinite(*points), 1u);
  EXPECT_EQ(points->sensor_origin_, Eigen::Vector4f(1, 2, 3, 0));
  EXPECT_EQ(points->sensor_orientation_.x(), 1.0f);
}

TEST_F(FieldsTest, NormalsAreOptionalFields)
{
  CloudFile cloud = this->cloud("x y z", "F F F", {"1 2 3"});
  EXPECT_THROW(normalsOf(cloud), InputError);
  pcl::PointCloud<pcl::Normal> normals;
  normals.emplace_back(0.0f, 0.6f, 0.8f);
  normals.front().curvature = 0.25f;
  setNormals(cloud, normals);
  const auto back = normalsOf(cloud);
  EXPECT_EQ(back->front().normal_y, 0.6f);
  EXPECT_EQ(back->front().curvature, 0.25f);
}

} // namespace
