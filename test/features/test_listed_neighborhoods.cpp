// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Neighborhoods from lists: indices and bad input.

#include "support/shapes.h"

#include <pcl/features/impl/neighborhoods.hpp>

#include <gtest/gtest.h>

#include <limits>

namespace {

using namespace pcl;
using namespace pcl::test;

/** \brief Neighborhoods that are all points. */
class Listed : public testing::Test {
protected:
  Listed() : surface_(plane(50, 0.1, random_)), neighborhoods_(surface_.points(), 0)
  {
    neighborhoods_.setFinder(
        [this](index_t, double, int, Indices& found, std::vector<float>&) {
          for (std::size_t i = 0; i < surface_.size(); ++i)
            found.push_back(static_cast<index_t>(i));
        });
  }

  Random random_{7};
  Surface surface_;
  detail::Neighborhoods neighborhoods_;
  const NeighborhoodSize any_ = NeighborhoodSize::ofRadius(1.0);
};

TEST_F(Listed, WithoutIndicesAllPointsAreAskedAbout)
{
  std::vector<float> inad(2 * surface_.size(), -1.0f);
  EXPECT_TRUE(
      neighborhoods_.computeINAD(any_, surface_.trueNormals(), 2.0, inad.data()));
  EXPECT_EQ(std::vector<float>(inad.size(), 0.0f), inad);
}

TEST_F(Listed, NoIndicesGetNoResults)
{
  const Indices nobody;
  const detail::Neighborhoods none = neighborhoods_.among(nobody);
  std::vector<float> results(4 * surface_.size(), -1.0f);
  const std::vector<float> untouched = results;
  EXPECT_TRUE(none.computeNormals(any_, results.data(), results.data() + 3, 4));
  EXPECT_TRUE(none.computeINAD(any_, surface_.trueNormals(), 2.0, results.data()));
  EXPECT_EQ(untouched, results);
}

TEST_F(Listed, BadInputIsRefused)
{
  std::vector<float> inad(2 * surface_.size());
  const XYZView normals = surface_.trueNormals();
  const XYZView too_few{normals.first, normals.stride, normals.size - 1};
  EXPECT_THROW(neighborhoods_.computeINAD(any_, too_few, 2.0, inad.data()),
               std::invalid_argument);
  for (const double rate : {-1.0,
                            std::numeric_limits<double>::infinity(),
                            std::numeric_limits<double>::quiet_NaN()}) {
    EXPECT_THROW(neighborhoods_.computeINAD(any_, normals, rate, inad.data()),
                 std::invalid_argument)
        << rate;
  }
}

} // namespace
