// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Faces, and how they meet: convex, concave or a step.

#include "instances/faces/face_contacts.h"
#include "small_surfaces.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

namespace {

using namespace pcl;
using namespace pcl::test;
using namespace pcl::segmentation;
using PointLabels = pcl::segmentation::Labels;

PointLabels
labelsOf(const Surface& first, const Surface& second)
{
  PointLabels labels(first.size(), 0);
  labels.resize(first.size() + second.size(), 1);
  return labels;
}

TEST(FaceSurfaces, AreaLikelihoodAndPlane)
{
  const Surface flat = floorPatch(5, 6, 7, 30, 40);
  detail::InstanceInput input = inputOf(flat);
  std::fill_n(input.likelihood.begin(), 300, 0.6f);
  std::fill_n(input.likelihood.begin(), 120, std::numeric_limits<float>::quiet_NaN());
  const std::vector<Face> faces = facesOf(input, PointLabels(flat.size(), 0));
  ASSERT_EQ(1U, faces.size());
  EXPECT_EQ(1200U, faces[0].points);
  EXPECT_NEAR(faces[0].area, 0.26 * 1200, 1e-6); // 300 by its sides
  EXPECT_NEAR(faces[0].planar, (180 * 0.6 + 900) / 1200, 1e-6);
  ASSERT_EQ(PrimitiveType::Plane, faces[0].surface.type);
  EXPECT_NEAR(faces[0].surface.coefficients[3], 0.0f, 1e-4f) << "about its origin";
  EXPECT_EQ(7.0f, faces[0].origin.z());
}

TEST(FaceSurfaces, CurvedFacesHaveTheSimplestPrimitiveThatFits)
{
  Random random(31);
  const Surface can = cylinder(600, 6.0, 12.0, random);
  const Surface ball = sphere(600, 6.0, random);
  const Surface both = together(can, ball);
  detail::InstanceInput input = inputOf(both);
  input.likelihood.assign(both.size(), 0.1f);
  const std::vector<Face> faces = facesOf(input, labelsOf(can, ball));
  ASSERT_EQ(2U, faces.size());
  ASSERT_EQ(PrimitiveType::Cylinder, faces[0].surface.type);
  EXPECT_NEAR(faces[0].surface.coefficients[6], 6.0f, 1e-2f);
  ASSERT_EQ(PrimitiveType::Sphere, faces[1].surface.type);
  EXPECT_NEAR(faces[1].surface.coefficients[3], 6.0f, 1e-2f);
  input.likelihood.assign(both.size(), 0.9f);
  EXPECT_EQ(PrimitiveType::None, facesOf(input, labelsOf(can, ball))[0].surface.type)
      << "what is planar is a plane or nothing";
}

/** \brief The border of two faces, which all points belong to.
 * \param[in] have_primitives whether the faces are known to be planes */
FaceContact
contactOf(const Surface& first,
          const Surface& second,
          const Eigen::Vector3f& up = Eigen::Vector3f::UnitZ(),
          bool have_primitives = true)
{
  const Surface both = together(first, second);
  const detail::InstanceInput input = inputOf(both);
  const PointLabels labels = labelsOf(first, second);
  std::vector<Face> faces = facesOf(input, labels);
  if (!have_primitives)
    for (Face& face : faces)
      face.surface = {};
  const auto contacts =
      faceContacts(input, PointGrid(input.points, 1.5f), labels, faces, labels, up);
  EXPECT_EQ(1U, contacts.size());
  EXPECT_EQ(0, contacts.at(0).first);
  EXPECT_EQ(1, contacts.at(0).second);
  return contacts.at(0);
}

TEST(FaceContacts, AnEdgeSeenFromOutsideIsConvexOneFromInsideConcave)
{
  const Surface level = floorPatch(-10, 0, 0, 20, 40);
  const Surface down = wallPatch(0, -10, true, 40, 20); // outside is +x and +z
  const Surface up = wallPatch(0, half, false, 40, 20); // outside is -x and +z
  const FaceContact convex = contactOf(level, down);
  EXPECT_GT(convex.convex, 20.0f);
  EXPECT_LT(convex.convex, 80.0f);
  EXPECT_EQ(0.0f, convex.concave);
  const FaceContact concave = contactOf(level, up);
  EXPECT_GT(concave.concave, 20.0f);
  EXPECT_EQ(0.0f, concave.convex);
}

/** A concave border. */
class FaceSlopes : public testing::Test {
protected:
  FaceContact
  contact(const Eigen::Vector3f& up, bool have_primitives = false) const
  {
    return contactOf(level_, wallPatch(0, half, false, 40, 20), up, have_primitives);
  }

  const Surface level_ = floorPatch(-10, 0, 0, 20, 40);
  const Eigen::Vector3f along_ = Eigen::Vector3f::UnitY(); // both are steep then
};

TEST_F(FaceSlopes, NothingStandsBetweenWalls)
{
  const FaceContact held = contact(along_);
  EXPECT_GT(held.concave, 20.0f);
  EXPECT_GE(held.sloping, held.concave);
}

TEST_F(FaceSlopes, ThingsMayStandOnALevelFace)
{
  EXPECT_LT(contact(Eigen::Vector3f::UnitZ()).sloping, 5.0f);
}

TEST_F(FaceSlopes, ThingsMayStandAnywhereIfUpIsUnknown)
{
  EXPECT_EQ(0.0f, contact(Eigen::Vector3f::Zero()).sloping);
}

TEST_F(FaceSlopes, TwoPlanesMayBeWallsOfTwoBoxes)
{
  EXPECT_EQ(0.0f, contact(along_, true).sloping);
}

TEST_F(FaceSlopes, AConvexEdgeIsNone)
{
  const Surface down = wallPatch(0, -10, true, 40, 20);
  EXPECT_LT(contactOf(level_, down, along_, false).sloping, 5.0f);
}

/** A cylinder and a strip before it, and in the gap between them points of neither,
 * which are shared out. */
TEST_F(FaceSlopes, WhatStandsBeforeACurvedFaceIsNotHeldByIt)
{
  constexpr double radius = 6.0, height = 10.0, gap = 3.0;
  Random random(32);
  const Surface can = cylinder(800, radius, height, random);
  const Eigen::Vector3d aside = Eigen::Vector3d(1, -1, 0).normalized();
  const Surface strip =
      patch({radius + gap, 0, 0}, Eigen::Vector3d::UnitZ(), aside, 20, 10);
  const Surface between = patch({radius + 1.0, 0, 0},
                                1.8 * Eigen::Vector3d::UnitX(), // 0.9 apart: they meet
                                Eigen::Vector3d::UnitZ(),
                                2,
                                20);
  const Surface all = together(together(can, strip), between);
  detail::InstanceInput input = inputOf(all);
  std::fill_n(input.likelihood.begin(), can.size(), 0.1f);
  PointLabels labels = labelsOf(can, strip);
  PointLabels grown = labels;
  for (std::size_t i = 0; i < between.size(); ++i) {
    labels.push_back(-1);
    grown.push_back(static_cast<std::int32_t>(i % 2));
  }
  const std::vector<Face> faces = facesOf(input, labels);
  ASSERT_EQ(PrimitiveType::Cylinder, faces.at(0).surface.type);
  ASSERT_EQ(PrimitiveType::Plane, faces.at(1).surface.type);
  const auto contacts = faceContacts(input,
                                     PointGrid(input.points, 1.5f),
                                     labels,
                                     faces,
                                     grown,
                                     Eigen::Vector3f::UnitZ());
  ASSERT_EQ(1U, contacts.size());
  EXPECT_GT(contacts[0].concave, 5.0f);
  EXPECT_EQ(0.0f, contacts[0].convex);
  EXPECT_EQ(0.0f, contacts[0].sloping);
}

TEST(FaceContacts, OneLevelIsConvexAStepConcave)
{
  const Surface level = floorPatch(0, 0, 0, 20, 40);
  const FaceContact same = contactOf(level, floorPatch(10, 0, 0, 20, 40));
  EXPECT_GT(same.convex, 20.0f);
  EXPECT_EQ(0.0f, same.concave);
  const FaceContact step = contactOf(level, floorPatch(10, 0, 0.5, 20, 40));
  EXPECT_GT(step.concave, 20.0f);
  EXPECT_EQ(0.0f, step.convex);
}

TEST(FaceContacts, FacesApartHaveNone)
{
  const Surface first = floorPatch(0, 0, 0, 20, 20);
  const Surface second = floorPatch(11.5, 0, 0, 20, 20);
  const Surface both = together(first, second);
  const detail::InstanceInput input = inputOf(both);
  const PointLabels labels = labelsOf(first, second);
  EXPECT_TRUE(faceContacts(input,
                           PointGrid(input.points, 1.5f),
                           labels,
                           facesOf(input, labels),
                           labels,
                           Eigen::Vector3f::UnitZ())
                  .empty());
}

} // namespace
