// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Models of one and of several classes, and what they refuse.

#include "support/errors.h"

#include <pcl/exceptions.h>
#include <pcl/features/shape_model.h>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace {

using namespace pcl;
using namespace pcl::test;

constexpr float nan = std::numeric_limits<float>::quiet_NaN();
constexpr float infinity = std::numeric_limits<float>::infinity();

/** \brief Two bins each of mu and sigma over 1 rad; these are the counts. */
ShapeHistogram
counts(std::uint64_t c00, std::uint64_t c01, std::uint64_t c10, std::uint64_t c11)
{
  ShapeHistogram histogram(2, 2, 1.0, 1.0);
  histogram.add(0, 0, c00);
  histogram.add(0, 1, c01);
  histogram.add(1, 0, c10);
  histogram.add(1, 1, c11);
  return histogram;
}

const INAD in_00{0.1f, 0.1f};
const INAD in_01{0.1f, 0.9f};
const INAD in_11{0.9f, 0.9f};

std::vector<float>
evaluated(const ShapeModel& model, const INAD& inad)
{
  std::vector<float> values(model.classes().size());
  model.evaluate(inad, values.data());
  return values;
}

ShapeModel
twoClasses()
{
  ShapeModel model;
  model.add("flat", counts(6, 2, 0, 0));
  model.add("round", counts(1, 3, 0, 0), 2.0);
  return model;
}

TEST(ShapeModel, IdealPlaneIsAllInTheFirstBin)
{
  const ShapeModel model = ShapeModel::idealPlane(INADParameters::edges(), 20);
  ASSERT_EQ(1U, model.classes().size());
  const ShapeHistogram& plane = model.classes()[0].histogram;
  EXPECT_EQ("planar", model.classes()[0].name);
  EXPECT_EQ(20U, plane.muBins());
  EXPECT_EQ(plane.total(), plane.count(0, 0));
  EXPECT_EQ(0.015, model.parameters().normal_radius);
  EXPECT_EQ(std::vector<float>{1.0f}, evaluated(model, {0.07f, 0.07f}));
  EXPECT_EQ(std::vector<float>{0.0f}, evaluated(model, {0.08f, 0.07f}));
}

TEST(ShapeModel, ThePapersParameters)
{
  const INADParameters surfaces = INADParameters::surfaces();
  EXPECT_EQ(0.025, surfaces.normal_radius);
  EXPECT_EQ(0.025, surfaces.radius);
  const INADParameters edges = INADParameters::edges();
  EXPECT_EQ(0.015, edges.normal_radius);
  EXPECT_EQ(0.006, edges.radius);
  EXPECT_EQ(2.0, edges.outlier_rate);
  EXPECT_EQ(0, edges.k);
}

TEST(ShapeModel, OneClassGivesItsLikelihood)
{
  ShapeModel model;
  model.add("flat", counts(8, 2, 0, 0));
  EXPECT_EQ(std::vector<float>{0.25f}, evaluated(model, in_01));
  EXPECT_EQ(std::vector<float>{0.0f}, evaluated(model, in_11));
  EXPECT_TRUE(std::isnan(evaluated(model, {nan, 0.1f})[0]));
}

TEST(ShapeModel, SeveralClassesGivePosteriors)
{
  const ShapeModel model = twoClasses();
  // Prior times share of the bin: 1 * 6/8 against 2 * 1/4.
  EXPECT_FLOAT_EQ(0.6f, evaluated(model, in_00)[0]);
  EXPECT_FLOAT_EQ(0.4f, evaluated(model, in_00)[1]);
  EXPECT_FLOAT_EQ(1.0f / 7, evaluated(model, in_01)[0]);
  EXPECT_FLOAT_EQ(6.0f / 7, evaluated(model, in_01)[1]);
}

TEST(ShapeModel, PosteriorIsUnknownWhereEveryClassSaysNothing)
{
  ShapeModel model = twoClasses();
  EXPECT_TRUE(std::isnan(evaluated(model, in_11)[0]));
  EXPECT_TRUE(std::isnan(evaluated(model, in_11)[1]));
  EXPECT_TRUE(std::isnan(evaluated(model, {nan, nan})[0]));
  EXPECT_TRUE(std::isnan(evaluated(model, {1.5f, 0.1f})[0]));
  model.setFloor(2.9); // densities of in_00: 6/8 and 1/4 of a bin of 1/4 rad^2
  EXPECT_FLOAT_EQ(0.6f, evaluated(model, in_00)[0]);
  model.setFloor(3.1);
  EXPECT_TRUE(std::isnan(evaluated(model, in_00)[0]));
}

TEST(ShapeModel, AClassIsExtended)
{
  ShapeModel model = twoClasses();
  model.add("flat", counts(0, 0, 0, 8));
  ASSERT_EQ(2U, model.classes().size());
  EXPECT_EQ(16U, model.classes()[0].histogram.total());
  EXPECT_EQ(1.0f, evaluated(model, in_11)[0]);
}

TEST(ShapeModel, AnExtendedClassKeepsItsPriorUnlessOneIsGiven)
{
  ShapeModel model;
  model.add("first", counts(1, 0, 0, 0), 3.0);
  model.add("second", counts(1, 0, 0, 0));
  model.add("first", counts(1, 0, 0, 0));
  EXPECT_EQ(3.0, model.classes()[0].prior);
  EXPECT_EQ(1.0, model.classes()[1].prior);
  model.add("first", counts(1, 0, 0, 0), 2.0);
  EXPECT_EQ(2.0, model.classes()[0].prior);
}

TEST(ShapeModel, BadClassesAreRefused)
{
  ShapeModel model = twoClasses();
  const auto textOf =
      [&](const std::string& name, const ShapeHistogram& histogram, double prior) {
        return exceptionOf<BadArgumentException>(
            [&] { model.add(name, histogram, prior); });
      };
  expectParts(textOf("", counts(1, 0, 0, 0), 1), {"needs a name"});
  expectParts(textOf("c", counts(0, 0, 0, 0), 1), {"'c' is empty", "at least one"});
  for (const double prior : {0.0, -1.0, double{nan}, double{infinity}}) {
    expectParts(textOf("c", counts(1, 0, 0, 0), prior),
                {"prior of class 'c'", "positive and finite"});
  }
  ShapeHistogram other(3, 2, 1.0, 1.0);
  other.add(0, 0, 1);
  expectParts(textOf("c", other, 1), {"'c' has 3 x 2", "are 2 x 2"});
  EXPECT_EQ(2U, model.classes().size());
}

TEST(ShapeModel, BadParametersAreRefused)
{
  const auto refused = [](double normal_radius, double radius, int k, double rate) {
    return exceptionOf<BadArgumentException>([=] {
      ShapeModel(INADParameters{normal_radius, radius, k, rate});
    });
  };
  const std::string allowed = "both radii must be positive";
  expectParts(refused(0.0, 0.01, 0, 2), {"normal radius 0 m", allowed});
  expectParts(refused(0.01, -0.01, 0, 2), {"radius -0.01 m", allowed});
  expectParts(refused(0.01, nan, 0, 2), {"radius nan m", allowed});
  expectParts(refused(0.01, infinity, 0, 2), {"radius inf m", allowed});
  expectParts(refused(0.01, 0.01, 12, 2), {"k 12", allowed});
  expectParts(refused(0.0, 0.0, 0, 2), {"k 0", allowed});
  expectParts(refused(0.0, 0.0, -2, 2), {"k -2", allowed});
  expectParts(refused(0.01, 0.01, 0, -1), {"outlier rate -1", "0 or positive"});
  expectParts(refused(0.01, 0.01, 0, nan), {"outlier rate nan", "0 or positive"});
  ShapeModel model;
  expectParts(exceptionOf<BadArgumentException>([&] { model.setFloor(-1); }),
              {"floor -1", "0 or positive"});
  EXPECT_NO_THROW(ShapeModel(INADParameters{0.0, 0.0, 12, 0.0}));
}

TEST(ShapeModel, DisagreementNamesWhatDiffers)
{
  const ShapeModel model({0.02, 0.01, 0, 2.0});
  EXPECT_EQ("", model.disagreement({0.02, 0.01, 0, 2.0}));
  EXPECT_EQ("", model.disagreement({0.02 * (1 + 1e-7), 0.01, 0, 2.0}));
  expectParts(model.disagreement({0.03, 0.01, 0, 2.0}),
              {"normal radius 0.03 m", "made with 0.02 m"});
  expectParts(model.disagreement({0.02, 0.015, 0, 1.5}),
              {"radius 0.015 m", "made with 0.01 m", "outlier rate 1.5", "with 2"});
  expectParts(model.disagreement({0.0, 0.0, 12, 2.0}), {"k 12", "with 0"});
}

} // namespace
