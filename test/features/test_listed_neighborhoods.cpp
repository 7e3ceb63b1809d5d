// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Neighborhoods from lists: indices and bad input.

#include "features/listed_neighborhoods.h"
#include "support/shapes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace {

using namespace pcl;
using namespace pcl::test;

/** \brief Neighborhoods that are all points. */
class Listed : public testing::Test {
protected:
  Listed()
  : surface_(plane(50, 0.1, random_))
  , neighborhoods_(surface_.points(), [this](std::size_t, pcl::Indices& found) {
    for (std::size_t i = 0; i < surface_.size(); ++i)
      found.push_back(static_cast<pcl::index_t>(i));
  })
  {}

  Random random_{7};
  Surface surface_;
  detail::ListedNeighborhoods neighborhoods_;
};

TEST_F(Listed, WithoutIndicesAllPointsAreAskedAbout)
{
  std::vector<float> inad(2 * surface_.size(), -1.0f);
  EXPECT_TRUE(neighborhoods_.computeINAD(surface_.trueNormals(), 2.0, inad.data()));
  EXPECT_EQ(std::vector<float>(inad.size(), 0.0f), inad);
}

TEST_F(Listed, NoIndicesGetNoResults)
{
  const std::vector<std::int32_t> none;
  neighborhoods_.setQueryIndices(none.data(), none.size());
  std::vector<float> results(4 * surface_.size(), -1.0f);
  const std::vector<float> untouched = results;
  EXPECT_TRUE(neighborhoods_.computeNormals(results.data(), results.data() + 3, 4));
  EXPECT_TRUE(neighborhoods_.computeINAD(surface_.trueNormals(), 2.0, results.data()));
  EXPECT_EQ(untouched, results);
}

TEST_F(Listed, BadInputIsRefused)
{
  std::vector<float> inad(2 * surface_.size());
  const XYZView normals = surface_.trueNormals();
  const XYZView too_few{normals.first, normals.stride, normals.size - 1};
  EXPECT_THROW(neighborhoods_.computeINAD(too_few, 2.0, inad.data()),
               std::invalid_argument);
  for (const double rate : {-1.0,
                            std::numeric_limits<double>::infinity(),
                            std::numeric_limits<double>::quiet_NaN()}) {
    EXPECT_THROW(neighborhoods_.computeINAD(normals, rate, inad.data()),
                 std::invalid_argument)
        << rate;
  }
}

} // namespace
