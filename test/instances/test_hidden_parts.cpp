// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Groups of faces that are one body behind another one, and those that are not.

#include "instances/objects/hidden_parts.h"
#include "post_scene.h"

#include <gtest/gtest.h>

namespace {

using namespace pcl::test;
using GroupLabels = pcl::segmentation::Labels;

GroupLabels
joined(const FaceScene& scene, GroupLabels groups, unsigned threads = 1)
{
  const pcl::detail::InstanceInput input = scene.input(threads);
  pcl::segmentation::joinHiddenParts(
      input, scene.faces, pcl::segmentation::facesOf(input, scene.faces), groups);
  return groups;
}

TEST(HiddenParts, BehindAPostAreOne)
{
  FaceScene scene = endsOfABox(20.0);
  scene.add(post(8.5));
  EXPECT_EQ(GroupLabels({0, 0, 0, 0, 4}), joined(scene, {0, 0, 2, 2, 4}));
}

TEST(HiddenParts, StayTwoIfNothingIsBetweenThem)
{
  EXPECT_EQ(GroupLabels({0, 0, 2, 2}), joined(endsOfABox(20.0), {0, 0, 2, 2}));
}

TEST(HiddenParts, StayTwoIfTheyShareOnePlaneOnly)
{
  FaceScene scene;
  scene.add(topAt(-30.0));
  scene.add(topAt(10.0));
  scene.add(post(8.5));
  EXPECT_EQ(GroupLabels({0, 1, 2}), joined(scene, {0, 1, 2}));
}

TEST(HiddenParts, StayTwoIfTheirTopsAreOfOtherHeights)
{
  FaceScene scene;
  scene.add(topAt(-30.0));
  scene.add(frontAt(-30.0));
  scene.add(topAt(10.0, 3.0));
  scene.add(frontAt(10.0));
  scene.add(post(8.5));
  EXPECT_EQ(GroupLabels({0, 0, 2, 2, 4}), joined(scene, {0, 0, 2, 2, 4}));
}

TEST(HiddenParts, StayTwoIfTheGapIsLongerThanBoth)
{
  for (const double gap : {36.0, 44.0}) { // the faces are 20 long
    FaceScene scene = endsOfABox(gap);
    scene.add(post(0.43 * gap));
    const bool is_one = gap < 40.0;
    EXPECT_EQ(is_one ? GroupLabels({0, 0, 0, 0, 4}) : GroupLabels({0, 0, 2, 2, 4}),
              joined(scene, {0, 0, 2, 2, 4}))
        << gap;
  }
}

TEST(HiddenParts, AreTheSameForThreadsAndOrder)
{
  FaceScene scene = endsOfABox(20.0);
  scene.add(post(8.5));
  scene.add(topAt(-30.0, -30.0));
  scene.add(topAt(10.0, -30.0));
  const GroupLabels groups = {0, 0, 2, 2, 4, 5, 6}, expected = {0, 0, 0, 0, 4, 5, 6};
  for (const unsigned threads : {1U, 2U, 7U}) {
    EXPECT_EQ(expected, joined(scene, groups, threads)) << threads;
    EXPECT_EQ(expected, joined(shuffled(scene), groups, threads)) << threads;
  }
}

} // namespace
