// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// What hides the space between two faces, and what does not.

#include "instances/objects/lines_of_sight.h"
#include "small_surfaces.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace {

using namespace pcl::test;
using namespace pcl::segmentation;
using Eigen::Vector3f;

constexpr std::uint32_t face_points = 10 * 15; // so few that lines begin at all of them

/** \brief Two faces 18 apart, so that the places on lines between them are at x = -7,
 * -5 ... 7; seen from above. */
Surface
twoFaces()
{
  return together(floorPatch(-13.5, 0, 0, 10, 15), floorPatch(9, 0, 0, 10, 15));
}

/** \brief At a tenth of the height of the viewpoint, from x on to the right: it hides
 * places more than about 1.1 (x - 1) to the right. */
Surface
screenFrom(double x)
{
  return floorPatch(x, -2, 10, 20, 25);
}

bool
areHidden(const Surface& surface)
{
  pcl::detail::InstanceInput input = inputOf(surface);
  input.view_point = {0.0f, 0.0f, 100.0f};
  const LinesOfSight lines(
      input, range(0, face_points), range(face_points, 2 * face_points));
  EXPECT_FLOAT_EQ(18.0f, lines.gap());
  return lines.areHidden(SeenDirections(input));
}

TEST(LinesOfSight, AreHiddenIfHalfOfTheirPlacesAre)
{
  EXPECT_TRUE(areHidden(together(twoFaces(), screenFrom(1.0)))) << "4 of 8";
  EXPECT_FALSE(areHidden(together(twoFaces(), screenFrom(2.0)))) << "3 of 8";
  EXPECT_FALSE(areHidden(twoFaces())) << "nothing is seen";
}

TEST(LinesOfSight, AreNotHiddenIfMoreThanATenthEndsBehindThem)
{
  const Surface half_hidden = together(twoFaces(), screenFrom(1.0));
  EXPECT_FALSE(areHidden(together(half_hidden, floorPatch(-10, -2, -20, 60, 30))));
  EXPECT_TRUE(areHidden(together(half_hidden, floorPatch(-10, -2, 0, 20, 25))))
      << "it is where they are";
}

TEST(SeenDirections, AConeHasThePointsThatAScanFinds)
{
  Random random(5);
  Surface ball = sphere(5000, 10.0, random);
  ball.xyz[3] = std::numeric_limits<float>::quiet_NaN();
  pcl::detail::InstanceInput input = inputOf(ball);
  input.view_point = {3.0f, -2.0f, 1.0f};
  const SeenDirections seen(input);
  const Vector3f axis = Vector3f(1.0f, 2.0f, -0.5f).normalized();
  for (const float angle : {0.003f, 0.05f, 0.4f, 1.7f, 3.0f}) {
    std::vector<std::uint32_t> expected;
    for (std::uint32_t i = 0; i < ball.size(); ++i) {
      const Vector3f from = ball.position(i).cast<float>() - input.view_point;
      if (from.dot(axis) > std::cos(angle) * from.norm())
        expected.push_back(i);
    }
    std::vector<std::uint32_t> found = seen.inCone(axis, angle);
    std::sort(found.begin(), found.end());
    EXPECT_EQ(expected, found) << angle;
  }
}

} // namespace
