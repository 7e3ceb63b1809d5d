// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// The edges of plates that are a few spacings thick.

#include "features/noise/thin_plates.h"
#include "features/spacing/local_spacing.h"
#include "segmentation/detection_scenes.h"
#include "segmentation/field_of.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

namespace {

using namespace pcl;
using namespace pcl::test;

constexpr double distance = 0.001; // between points, meters

/** A tilted plate, and how far each point is from its nearest edge. */
struct Plate {
  Cloud::Ptr cloud = make_shared<Cloud>();
  std::vector<double> distances;
};

/** \param[in] size how many points long its sides are */
Plate
plate(const std::array<int, 3>& size, double noise)
{
  Random random(74);
  Plate plate;
  const Eigen::Quaterniond turn = Eigen::Quaterniond(0.8, 0.3, -0.4, 0.33).normalized();
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const std::size_t first = (axis + 1) % 3, second = (axis + 2) % 3;
    for (const double side : {0.0, 1.0})
      for (int i = 0; i < size[first]; ++i)
        for (int j = 0; j < size[second]; ++j) {
          Eigen::Vector3d p;
          p[static_cast<int>(axis)] = side * size[axis];
          p[static_cast<int>(first)] = i + 0.5 + random.uniform(-0.3, 0.3);
          p[static_cast<int>(second)] = j + 0.5 + random.uniform(-0.3, 0.3);
          std::array<double, 3> from_sides{};
          for (std::size_t k = 0; k < 3; ++k) {
            const double x = p[static_cast<int>(k)];
            from_sides[k] = std::min(x, size[k] - x);
          }
          std::sort(from_sides.begin(), from_sides.end());
          plate.distances.push_back(std::hypot(from_sides[0], from_sides[1]));
          p += noise *
               Eigen::Vector3d(random.normal(), random.normal(), random.normal());
          const Eigen::Vector3f q = (distance * (turn * p)).cast<float>();
          plate.cloud->emplace_back(q.x(), q.y(), q.z());
        }
  }
  return plate;
}

TEST(ThinPlates, KeepTheirEdges)
{
  for (const int thickness : {4, 5})
    for (const double noise : {0.0, 0.25}) {
      SCOPED_TRACE(std::to_string(thickness) + " distances thick, noise " +
                   std::to_string(noise));
      const Plate plate = ::plate({100, 90, thickness}, noise);
      const ShapeField field = edgeFieldOf(plate.cloud);
      EXPECT_EQ(0.0, field.resolution);
      std::size_t edges = 0, right = 0, near = 0, found = 0;
      for (std::size_t i = 0; i < plate.distances.size(); ++i) {
        const bool is_edge = field.edge_likelihood[i] > 0.5f;
        const double from_edge = plate.distances[i];
        edges += is_edge ? 1 : 0;
        right += is_edge && from_edge < 3.0 ? 1 : 0;
        near += from_edge < 1.5 ? 1 : 0;
        found += is_edge && from_edge < 1.5 ? 1 : 0;
      }
      EXPECT_GT(static_cast<double>(right), 0.98 * static_cast<double>(edges));
      EXPECT_GT(static_cast<double>(found), 0.95 * static_cast<double>(near));
    }
}

/** In spacings, 0 for other clouds than thin plates. */
double
thicknessOf(const Cloud& cloud)
{
  const detail::Neighborhoods neighborhoods(detail::xyzOf(cloud), 1);
  const std::vector<float> spacings =
      detail::spacingsOf(detail::distancesToTwelfth(neighborhoods));
  return detail::plateThickness(neighborhoods, spacings, 1);
}

TEST(ThinPlates, HaveAThickness)
{
  // Of points at random places a spacing is two mean distances, of a grid's a bit less.
  EXPECT_NEAR(2.1, thicknessOf(*plate({100, 90, 4}, 0.0).cloud), 0.2);
  EXPECT_NEAR(2.6, thicknessOf(*plate({100, 90, 5}, 0.0).cloud), 0.25);
  EXPECT_EQ(0.0, thicknessOf(*plate({100, 90, 10}, 0.0).cloud));
}

TEST(ThinPlates, AreMostOfTheCloud)
{
  Plate plate = ::plate({100, 90, 4}, 0.0);
  Random random(75);
  const std::size_t strays = plate.cloud->size() * 6 / 10; // without neighbors
  for (std::size_t stray = 0; stray < strays; ++stray)
    plate.cloud->emplace_back(static_cast<float>(random.uniform(0.2, 1.2)),
                              static_cast<float>(random.uniform(0.2, 1.2)),
                              static_cast<float>(random.uniform(0.2, 1.2)));
  EXPECT_EQ(0.0, thicknessOf(*plate.cloud));
}

TEST(ThinPlates, AreNotNoiseThatIsAsThick)
{
  for (const double noise : {1.0, 2.0, 3.0}) {
    Plate sheet = plate({150, 150, 40}, noise);
    EXPECT_EQ(0.0, thicknessOf(*sheet.cloud)) << noise;
  }
}

TEST(ThinPlates, AreTheSameInAnyOrder)
{
  const Plate plate = ::plate({100, 90, 4}, 0.25);
  const auto reversed = make_shared<Cloud>(*plate.cloud);
  std::reverse(reversed->begin(), reversed->end());
  EXPECT_EQ(thicknessOf(*plate.cloud), thicknessOf(*reversed));
  std::vector<float> likelihood = edgeFieldOf(reversed).edge_likelihood;
  std::reverse(likelihood.begin(), likelihood.end());
  EXPECT_TRUE(sameBits(edgeFieldOf(plate.cloud).edge_likelihood, likelihood));
}

} // namespace
