// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Normals from sums of floats are as good as from exact sums.

#include "support/kernel_targets.h"
#include "support/random.h"
#include "support/reference.h"
#include "support/shapes.h"
#include "support/sweep.h"

#include <gtest/gtest.h>

#include <string>

// Normals with one radius for all come from sums of floats where those say what the
// normal is: where they don't, the result must be as good.
namespace {

using namespace pcl;
using namespace pcl::test;

constexpr double radius = 0.02;

class SweepFloatSums : public testing::TestWithParam<std::string> {
protected:
  static std::vector<float>
  normalsAt(const Surface& queries, const Surface& surface)
  {
    NeighborhoodSweep sweep(surface.points());
    sweep.setQueries(queries.points());
    return sweptNormals(sweep, NeighborhoodSize::ofRadius(radius));
  }

  /** \brief Places that see the origin from nearly a radius away. */
  Surface
  farPlaces()
  {
    Surface places;
    for (int i = 0; i < 100; ++i) {
      const Eigen::Vector3d away(random_.normal(), random_.normal(), random_.normal());
      places.add({0.95 * radius * away.normalized(), {0, 0, 1}});
    }
    return places;
  }

  ForcedTarget target_{GetParam()};
  Random random_{21};
};

TEST_P(SweepFloatSums, PointsInOnePlaceHaveNoNormalFromAfar)
{
  Surface heap;
  for (int i = 0; i < 20; ++i)
    heap.add({{1e-4, 2e-4, -3e-4}, {0, 0, 1}});
  for (const float v : normalsAt(farPlaces(), heap))
    ASSERT_TRUE(std::isnan(v));
}

TEST_P(SweepFloatSums, PointsOnALineHaveNoNormalFromAfar)
{
  const Eigen::Vector3d along = Eigen::Vector3d(1, 2, -0.5).normalized();
  for (const double half_length : {0.003 * radius, 0.03 * radius}) {
    Surface line;
    for (int i = -10; i <= 10; ++i)
      line.add({along * (half_length * i / 10), {0, 0, 1}});
    const auto normals = normalsAt(farPlaces(), line);
    std::size_t known = 0;
    for (const float v : normals)
      known += std::isnan(v) ? 0 : 1;
    EXPECT_EQ(0U, known) << half_length;
  }
}

TEST_P(SweepFloatSums, SmallPatchFromAfar)
{
  Surface patch = plane(400, 0.04 * radius, random_);
  patch.move(tiltedPose());
  Surface places;
  for (const auto& place : {Eigen::Vector3d(0.93, 0, 0), Eigen::Vector3d(0, 0.9, 0.2)})
    places.add({place * radius, {0, 0, 1}});
  places.move(tiltedPose());
  const auto normals = normalsAt(places, patch);
  for (std::size_t i = 0; i < places.size(); ++i) {
    const Found found = neighborsWithin(patch.points(), places.points()[i], radius);
    ASSERT_GT(found.size(), 100U);
    const ReferenceNormal expected = referenceNormal(patch.points(), found);
    EXPECT_LT(acuteAngle(expected.normal, vectorAt({normals.data(), 4, 2}, i)), 1e-4);
  }
}

TEST_P(SweepFloatSums, HeapsBesideFewPoints)
{
  for (const int heap : {1000, 4000, 5000, 14000}) {
    Surface cloud = plane(300, 0.05, random_);
    const Eigen::Vector3d place = cloud.position(0);
    for (int i = 0; i < heap; ++i)
      cloud.add({place, {0, 0, 1}});
    cloud.move(tiltedPose());
    const auto normals = sweptNormals(NeighborhoodSweep(cloud.points()),
                                      NeighborhoodSize::ofRadius(radius));
    std::size_t compared = 0;
    for (std::size_t i = 0; i < 300; ++i) {
      const Found found = neighborsWithin(cloud.points(), cloud.points()[i], radius);
      const ReferenceNormal expected = referenceNormal(cloud.points(), found);
      if (found.size() > static_cast<std::size_t>(heap) && expected.gap > 1e-3) {
        const XYZView view{normals.data(), 4, cloud.size()};
        ASSERT_LT(acuteAngle(expected.normal, vectorAt(view, i)), 2e-4)
            << heap << ", point " << i;
        ++compared;
      }
    }
    EXPECT_GT(compared, 20U) << heap;
  }
}

INSTANTIATE_TEST_SUITE_P(Targets,
                         SweepFloatSums,
                         testing::ValuesIn(kernelTargets()),
                         TargetName());

} // namespace
