// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Faces, and how they meet: convex, concave or a step.

#include "instances/face_contacts.h"
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

TEST(FaceContacts, NothingStandsOnWalls)
{
  const Surface level = floorPatch(-10, 0, 0, 20, 40);
  const Surface wall = wallPatch(0, half, false, 40, 20);
  const Eigen::Vector3f along = Eigen::Vector3f::UnitY(); // both are steep then
  const FaceContact held = contactOf(level, wall, along, false);
  EXPECT_GT(held.concave, 20.0f);
  EXPECT_GE(held.sloping, held.concave);
  EXPECT_LT(contactOf(level, wall, Eigen::Vector3f::UnitZ(), false).sloping, 5.0f)
      << "on a level face";
  EXPECT_EQ(0.0f, contactOf(level, wall, Eigen::Vector3f::Zero(), false).sloping)
      << "nobody knows which way is up";
  EXPECT_EQ(0.0f, contactOf(level, wall, along).sloping) << "walls of two boxes";
  const Surface down = wallPatch(0, -10, true, 40, 20);
  EXPECT_LT(contactOf(level, down, along, false).sloping, 5.0f) << "a convex edge";
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
