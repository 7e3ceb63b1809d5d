// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Faces grouped to bodies, and supports, from given contacts.

#include "instances/faces/face_grouping.h"
#include "instances/supports/support_faces.h"
#include "small_surfaces.h"

#include <gtest/gtest.h>

namespace {

using namespace pcl;
using namespace pcl::test;
using namespace pcl::segmentation;
using PointLabels = pcl::segmentation::Labels;

Face
faceOf(double area, double planar = 1.0)
{
  Face face;
  face.area = area;
  face.planar = planar;
  return face;
}

/** \brief Groups of faces 20 wide. */
PointLabels
groupsOf(std::size_t faces, const std::vector<FaceContact>& contacts)
{
  return groupFaces(
      std::vector<Face>(faces, faceOf(400)), std::vector<char>(faces, 0), contacts);
}

TEST(FaceGrouping, ConvexFacesAreOneBody)
{
  EXPECT_EQ((PointLabels{0, 0}), groupsOf(2, {{0, 1, 40, 0}}));
  EXPECT_EQ((PointLabels{0, 0}), groupsOf(2, {{0, 1, 40, 15}}));
  EXPECT_EQ((PointLabels{0, 1}), groupsOf(2, {{0, 1, 0, 40}}));
  EXPECT_EQ((PointLabels{0, 1}), groupsOf(2, {}));
  EXPECT_EQ((PointLabels{0, 0, 0}), groupsOf(3, {{0, 1, 40, 0}, {1, 2, 40, 0}}));
}

TEST(FaceGrouping, TheMostConvexBorderIsFirst)
{
  // 1 and 2 are joined; with 0 their border is then 30 convex and 60 concave.
  EXPECT_EQ((PointLabels{0, 1, 1}),
            groupsOf(3, {{0, 1, 30, 0}, {0, 2, 0, 60}, {1, 2, 40, 0}}));
  EXPECT_EQ((PointLabels{0, 0, 2}),
            groupsOf(3, {{0, 1, 40, 0}, {0, 2, 0, 60}, {1, 2, 30, 0}}));
}

TEST(FaceGrouping, AShareOfASideIsNeeded)
{
  EXPECT_EQ((PointLabels{0, 1}), groupsOf(2, {{0, 1, 19, 0}})) << "less than 20 wide";
  const std::vector<Face> faces{faceOf(400), faceOf(36)};
  const auto groups = [&](float convex) {
    return groupFaces(faces, {0, 0}, {{0, 1, convex, 0}});
  };
  EXPECT_EQ((PointLabels{0, 0}), groups(3.5f)) << "half of a narrow face's width";
  EXPECT_EQ((PointLabels{0, 1}), groups(2.5f));
}

TEST(FaceGrouping, StripsShareWhatIsAsWideAsTheyAre)
{
  // As large as a square of 20, but 80 long: two pieces of a handle's arc.
  Face strip = faceOf(400);
  strip.length = 80;
  const auto groups = [&](float convex) {
    return groupFaces({strip, strip}, {0, 0}, {{0, 1, convex, 0}});
  };
  EXPECT_EQ((PointLabels{0, 0}), groups(3.0f)) << "half of 5";
  EXPECT_EQ((PointLabels{0, 1}), groups(2.0f));
  strip.length = 40; // 10 wide: a face of a body of its own
  EXPECT_EQ((PointLabels{0, 1}), groups(19.0f));
}

TEST(FaceGrouping, NarrowGroupsAreHeldByWhatTheyTouch)
{
  // The body, a piece of its handle, and what they stand on.
  const std::vector<Face> faces{faceOf(400), faceOf(36), faceOf(2000)};
  const auto groups = [&](const std::vector<FaceContact>& contacts) {
    return groupFaces(faces, {0, 0, 1}, contacts);
  };
  EXPECT_EQ((PointLabels{0, 0, -1}), groups({{0, 1, 4, 8}, {0, 2, 0, 40}}));
  EXPECT_EQ((PointLabels{0, 1, -1}), groups({{0, 1, 4, 8}, {1, 2, 0, 6}}))
      << "a small body beside it";
  EXPECT_EQ((PointLabels{0, 1, -1}), groups({{0, 1, 0, 8}, {0, 2, 0, 40}}))
      << "a small body on it";
  EXPECT_EQ((PointLabels{0, 0, -1}), groups({{0, 1, 0, 8, 4}, {0, 2, 0, 40}}))
      << "nothing stands on a slope";
  EXPECT_EQ((PointLabels{0, 1, -1}), groups({{0, 1, 0, 8, 4}, {1, 2, 0, 6}}))
      << "but beside one";
  EXPECT_EQ((PointLabels{0, 1}), groupsOf(2, {{0, 1, 40, 80, 80}})) << "too wide";
  EXPECT_EQ((PointLabels{0, 1}),
            groupFaces({faceOf(36), faceOf(36)}, {0, 0}, {{0, 1, 0, 8, 8}}))
      << "a pile of small bodies";
}

TEST(FaceGrouping, WhatIsLeftOutJoinsNobody)
{
  EXPECT_EQ((PointLabels{-1, 1, 2}),
            groupFaces(std::vector<Face>(3, faceOf(400)),
                       {1, 0, 0},
                       {{0, 1, 90, 0}, {0, 2, 90, 0}}));
}

/** \brief A large level face, one as high, one above, and how they meet. */
class Supports : public ::testing::Test {
protected:
  Supports()
  : surface_(together(together(floorPatch(0, 0, 0, 30, 30), floorPatch(20, 0, 0, 8, 8)),
                      floorPatch(5, 5, 4, 20, 20)))
  , input_(inputOf(surface_))
  {
    labels_.resize(900, 0);
    labels_.resize(964, 1);
    labels_.resize(surface_.size(), 2);
    faces_ = {faceOf(225), faceOf(16), faceOf(100)};
    faces_[0].points = 900;
    faces_[1].points = 64;
    faces_[2].points = 400;
  }

  std::vector<char>
  among(const std::vector<FaceContact>& contacts,
        const std::vector<char>& known = {0, 0, 0}) const
  {
    return supportsAmong(input_, labels_, faces_, known, contacts);
  }

  Surface surface_;
  detail::InstanceInput input_;
  PointLabels labels_;
  std::vector<Face> faces_;
};

TEST_F(Supports, CarryOthersAndTakeWhatIsInTheirPlane)
{
  EXPECT_EQ((std::vector<char>{1, 1, 0}), among({{0, 2, 0, 40}, {1, 2, 50, 0}}));
}

TEST_F(Supports, NeedBordersTwoThirdsConcaveOrNoneConvex)
{
  EXPECT_EQ((std::vector<char>{0, 0, 0}), among({{0, 2, 25, 40}}));
  EXPECT_EQ((std::vector<char>{1, 1, 0}), among({{0, 2, 15, 40}, {1, 2, 50, 0}}));
  EXPECT_EQ((std::vector<char>{1, 1, 0}), among({{1, 2, 50, 0}}))
      << "larger than all others";
  EXPECT_EQ((std::vector<char>{0, 0, 0}), among({{0, 2, 5, 0}})) << "a rim";
}

TEST_F(Supports, AreNotKnownByWhatTheyStandOn)
{
  EXPECT_EQ((std::vector<char>{1, 1, 1}), among({{0, 2, 0, 40}}))
      << "each might carry the other";
  EXPECT_EQ((std::vector<char>{1, 0, 0}), among({{0, 2, 0, 40}}, {1, 0, 0}))
      << "2 only meets a known support: a body whose sides are one piece";
}

TEST_F(Supports, ArePlanesAndLarge)
{
  faces_[0].planar = 0.4;
  EXPECT_EQ((std::vector<char>{0, 0, 1}), among({{0, 2, 0, 40}}));
  faces_[0].planar = 1.0;
  faces_[2].area = 50;
  EXPECT_EQ((std::vector<char>{0, 0, 0}), among({{0, 1, 90, 0}, {0, 2, 10, 40}}));
}

} // namespace
