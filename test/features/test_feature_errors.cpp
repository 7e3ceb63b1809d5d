// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Bad settings and clouds of the features are refused with a message.

#include "support/clouds.h"
#include "support/errors.h"

#include <pcl/features/inad.h>
#include <pcl/features/normal_3d_sweep.h>
#include <pcl/search/kdtree.h>

#include <gtest/gtest.h>

#include <limits>

// Bad settings are refused: standard error names the class, the parameter, its value
// and what is allowed, and the output is empty.
namespace {

using namespace pcl;
using namespace pcl::test;

using Cloud = PointCloud<PointXYZ>;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

class INADOf : public INADEstimation<PointXYZ, Normal> {
public:
  static constexpr const char* name = "INADEstimation";

  explicit INADOf(const Surface& surface)
  {
    setInputNormals(trueNormalsOf<Normal>(surface));
  }
};

class NormalsOf : public NormalEstimationSweep<PointXYZ, Normal> {
public:
  static constexpr const char* name = "NormalEstimationSweep";

  explicit NormalsOf(const Surface&) {}
};

template <typename Class>
class FeatureErrors : public testing::Test {
protected:
  FeatureErrors()
  {
    estimation_.setInputCloud(toCloud<PointXYZ>(surface_));
    estimation_.setRadiusSearch(0.02);
  }

  /** \brief Into an output that still holds something. */
  void
  expectRefused(std::vector<std::string> parts)
  {
    typename Class::PointCloudOut output;
    output.resize(3);
    const std::string errors = errorsOf([&] { estimation_.compute(output); });
    parts.insert(parts.begin(), std::string("[pcl::") + Class::name + "::compute]");
    expectParts(errors, parts);
    EXPECT_EQ(1, std::count(errors.begin(), errors.end(), '\n')) << errors;
    EXPECT_TRUE(output.empty());
    EXPECT_EQ(0U, output.width * output.height);
  }

  void
  expectAccepted()
  {
    typename Class::PointCloudOut output;
    EXPECT_EQ("", errorsOf([&] { estimation_.compute(output); }));
    EXPECT_FALSE(output.empty());
  }

  Surface surface_ = grid(10, 0.01);
  Class estimation_{surface_};
};

using Classes = testing::Types<INADOf, NormalsOf>;
TYPED_TEST_SUITE(FeatureErrors, Classes);

TYPED_TEST(FeatureErrors, NothingIsWrongAtFirst) { this->expectAccepted(); }

TYPED_TEST(FeatureErrors, Radius)
{
  this->estimation_.setRadiusSearch(-0.01);
  this->expectRefused({"radius is -0.01", "must be positive and finite"});
  this->estimation_.setRadiusSearch(nan);
  this->expectRefused({"radius is nan", "must be positive and finite"});
  this->estimation_.setRadiusSearch(infinity);
  this->expectRefused({"radius is inf", "must be positive and finite"});
}

TYPED_TEST(FeatureErrors, NeitherRadiusNorK)
{
  this->estimation_.setRadiusSearch(0);
  this->expectRefused({"neither radius nor k", "set one of them"});
}

TYPED_TEST(FeatureErrors, BothRadiusAndK)
{
  this->estimation_.setKSearch(12);
  this->expectRefused({"both radius (0.02", "k (12)", "set one of them to 0"});
}

TYPED_TEST(FeatureErrors, K)
{
  this->estimation_.setRadiusSearch(0);
  this->estimation_.setKSearch(-3);
  this->expectRefused({"k is -3", "1 to 100"});
  this->estimation_.setKSearch(101);
  this->expectRefused({"k is 101", "1 to 100"});
  this->estimation_.setKSearch(100);
  this->expectAccepted();
}

TYPED_TEST(FeatureErrors, KAboveTheNumberOfFinitePoints)
{
  const auto cloud = toCloud<PointXYZ>(this->surface_);
  (*cloud)[4].x = std::numeric_limits<float>::quiet_NaN();
  this->estimation_.setInputCloud(cloud);
  this->estimation_.setRadiusSearch(0);
  this->estimation_.setKSearch(100);
  this->expectRefused({"k is 100", "1 to 99", "finite points"});
}

TYPED_TEST(FeatureErrors, Clouds)
{
  this->estimation_.setInputCloud(make_shared<Cloud>());
  this->expectRefused({"the input cloud is empty", "at least one point"});
  this->estimation_.setInputCloud(nullptr);
  this->expectRefused({"no input cloud is set", "setInputCloud()"});
  const float bad = std::numeric_limits<float>::quiet_NaN();
  this->estimation_.setInputCloud(make_shared<Cloud>(7, 1, PointXYZ(0, bad, 0)));
  this->expectRefused({"the input cloud has no finite point", "its 7 points"});
}

TYPED_TEST(FeatureErrors, SearchSurface)
{
  this->estimation_.setSearchSurface(make_shared<Cloud>());
  this->expectRefused({"the search surface is empty", "at least one point"});
  const float bad = std::numeric_limits<float>::infinity();
  this->estimation_.setSearchSurface(make_shared<Cloud>(7, 1, PointXYZ(0, bad, 0)));
  this->expectRefused({"the search surface has no finite point", "its 7 points"});
}

TYPED_TEST(FeatureErrors, Indices)
{
  this->estimation_.setIndices(indicesOf({0, 5, 100}));
  this->expectRefused({"index 100", "position 2", "0 to 99"});
  this->estimation_.setIndices(indicesOf({-1, 5}));
  this->expectRefused({"index -1", "position 0", "0 to 99"});
  this->estimation_.setIndices(indicesOf({99, 0}));
  this->expectAccepted();
}

TYPED_TEST(FeatureErrors, NoIndicesAreNoError)
{
  this->estimation_.setIndices(indicesOf({}));
  typename TypeParam::PointCloudOut output;
  output.resize(3);
  EXPECT_EQ("", errorsOf([&] { this->estimation_.compute(output); }));
  EXPECT_TRUE(output.empty());
}

TYPED_TEST(FeatureErrors, WithASearchMethodToo)
{
  this->estimation_.setSearchMethod(make_shared<search::KdTree<PointXYZ>>());
  this->estimation_.setRadiusSearch(nan);
  this->expectRefused({"radius is nan"});
  this->estimation_.setInputCloud(make_shared<Cloud>());
  this->expectRefused({"the input cloud is empty"});
}

TYPED_TEST(FeatureErrors, AnErrorDoesNotStick)
{
  this->estimation_.setRadiusSearch(-1);
  this->expectRefused({"radius is -1"});
  this->estimation_.setRadiusSearch(0.02);
  this->expectAccepted();
}

class INADErrors : public FeatureErrors<INADOf> {};

TEST_F(INADErrors, Normals)
{
  estimation_.setInputNormals(make_shared<PointCloud<Normal>>(99, 1));
  expectRefused({"99 normals", "100 points", "one for each"});
  estimation_.setInputNormals(nullptr);
  expectRefused({"no normals are set", "setInputNormals()"});
}

TEST_F(INADErrors, NormalsOfTheInputInsteadOfTheSearchSurface)
{
  estimation_.setSearchSurface(toCloud<PointXYZ>(grid(12, 0.01)));
  expectRefused({"100 normals", "144 points"});
}

TEST_F(INADErrors, OutlierRate)
{
  for (const auto& [rate, text] :
       {std::pair{-1e-9, "-1e-09"}, {nan, "nan"}, {infinity, "inf"}}) {
    estimation_.setOutlierRate(rate);
    expectRefused({std::string("outlier rate is ") + text, "0 (no rejection)"});
  }
}

} // namespace
