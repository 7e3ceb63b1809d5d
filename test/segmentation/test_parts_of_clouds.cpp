// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Parts of a cloud with the numbers of the whole have its surfaces and instances, bit
// by bit.

#include "support/bits.h"
#include "support/errors.h"
#include "support/random.h"

#include <pcl/point_types.h>
#include <pcl/segmentation/cloud_reach.h>
#include <pcl/segmentation/faces_of_parts.h>
#include <pcl/segmentation/instances_of_parts.h>
#include <pcl/segmentation/shape_field_estimation.h>
#include <pcl/features/impl/neighborhoods.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace {

using namespace pcl;
using namespace pcl::test;

using Cloud = PointCloud<PointXYZ>;
constexpr std::size_t curved = 1; // among the classes of surfaces
constexpr double spacing = 0.02;  // meters, between points

/** A floor and a wall beside it, and half of a pipe on the floor: 1.6 m along x. */
Cloud::Ptr
corner()
{
  Random random(5);
  const auto cloud = make_shared<Cloud>();
  const auto add = [&](double x, double y, double z) {
    const auto moved = [&](double value) {
      return static_cast<float>(value + 0.1 * spacing * random.normal());
    };
    cloud->emplace_back(moved(x), moved(y), moved(z));
  };
  constexpr double length = 1.6, width = 0.8, pi = 3.14159265358979;
  for (double x = 0.0; x < length; x += spacing) {
    for (double v = 0.0; v < width; v += spacing) {
      if (v < 0.3 || v > 0.5)
        add(x, v, 0.0);
      add(x, 0.0, v);
    }
    for (double angle = 0.0; angle < pi; angle += spacing / 0.1)
      add(x, 0.4 + 0.1 * std::cos(angle), 0.1 * std::sin(angle));
  }
  return cloud;
}

CloudNumbers
numbersOf(const Cloud& cloud)
{
  CloudNumbers numbers;
  const XYZView places = detail::xyzOf(cloud);
  const PartOfCloud all(places, std::vector<bool>(cloud.size(), true), 1);
  std::vector<float> distances =
      all.measureDistances(std::numeric_limits<double>::infinity());
  const auto middle =
      distances.begin() + static_cast<std::ptrdiff_t>(distances.size() / 2);
  std::nth_element(distances.begin(), middle, distances.end());
  numbers.distance = static_cast<double>(*middle);
  numbers.spacing = spacingAt(*middle, numbers.distance);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto [low, high] = std::minmax_element(
        cloud.begin(), cloud.end(), [axis](const PointXYZ& a, const PointXYZ& b) {
          return a.data[axis] < b.data[axis];
        });
    numbers.low[axis] = low->data[axis];
    numbers.high[axis] = high->data[axis];
  }
  setNoise(all.measureNoise(numbers, cloud.size()), numbers);
  return numbers;
}

/** A part of a cloud: its own places, and what is computed of them. */
struct Part {
  Indices indices; ///< of its own places in the cloud
  Cloud own;
  PartOfFaces faces;
  std::vector<InstancePoint> places;
};

class PartsOfClouds : public ::testing::Test {
protected:
  PartsOfClouds() : cloud(corner()), numbers(numbersOf(*cloud))
  {
    ShapeFieldEstimation<PointXYZ> estimation;
    estimation.setInputCloud(cloud);
    const auto field = make_shared<ShapeField>();
    EXPECT_TRUE(estimation.compute(*field));
    whole = field;
    for (int part = 0; part < 3; ++part)
      parts.push_back(computed(part));
  }

  /** Slabs along x, not of the same width. */
  static int
  partOf(const PointXYZ& point)
  {
    return point.x < 0.45f ? 0 : point.x < 0.97f ? 1 : 2;
  }

  Part
  computed(int number) const
  {
    const double halo = reachOf(numbers, ShapeModel::defaultEdges()).faces;
    Part part;
    double low = std::numeric_limits<double>::infinity(), high = -low;
    for (const PointXYZ& point : *cloud)
      if (partOf(point) == number) {
        low = std::min(low, static_cast<double>(point.x) - halo);
        high = std::max(high, static_cast<double>(point.x) + halo);
      }
    const auto near = make_shared<Cloud>();
    std::vector<bool> is_own;
    for (std::size_t i = 0; i < cloud->size(); ++i) {
      const PointXYZ& point = (*cloud)[i];
      if (point.x < low || point.x > high)
        continue;
      near->push_back(point);
      is_own.push_back(partOf(point) == number);
      if (is_own.back()) {
        part.indices.push_back(static_cast<index_t>(i));
        part.own.push_back(point);
      }
    }
    ShapeFieldEstimation<PointXYZ> estimation;
    estimation.setInputCloud(near);
    estimation.setCloudNumbers(numbers);
    estimation.setEdgesOnly(true);
    ShapeField edges;
    EXPECT_TRUE(estimation.compute(edges));
    part.faces = facesOfPart(edges, numbers, is_own, 1);
    for (std::size_t i = 0; i < near->size(); ++i)
      if (is_own[i])
        part.places.push_back(
            {{(*near)[i].x, (*near)[i].y, (*near)[i].z},
             {edges.normals[i].x(), edges.normals[i].y(), edges.normals[i].z()},
             edges.spacings[i],
             0.0f,
             edges.edge_likelihood[i]});
    return part;
  }

  /** The likelihoods that a part's places have in the whole cloud. */
  std::vector<float>
  ofWhole(const Part& part, std::size_t of_class) const
  {
    std::vector<float> values;
    for (const index_t i : part.indices)
      values.push_back(whole->likelihoods[of_class][static_cast<std::size_t>(i)]);
    return values;
  }

  /** use(part, the faces around it) */
  template <typename Use>
  void
  forEachFaces(const Use& use) const
  {
    for (const Part& part : parts) {
      const XYZView places = detail::xyzOf(part.own);
      FacesAround faces(part.faces, places, numbers, 1);
      for (const Part& other : parts)
        if (&other != &part)
          faces.add(other.faces.linked);
      use(part, faces);
    }
  }

  FacesAround::Noise
  noiseOfFaces() const
  {
    std::array<std::vector<float>, FacesAround::levels> residuals;
    forEachFaces([&](const Part&, const FacesAround& faces) {
      const auto of_part = faces.residuals();
      for (std::size_t l = 0; l < residuals.size(); ++l)
        residuals[l].insert(residuals[l].end(), of_part[l].begin(), of_part[l].end());
    });
    FacesAround::Noise noise{};
    for (std::size_t l = 0; l < noise.size(); ++l)
      if (!residuals[l].empty()) {
        std::sort(residuals[l].begin(), residuals[l].end());
        noise[l] = residuals[l][FacesAround::rankOfNoise(residuals[l].size())];
      }
    return noise;
  }

  const Cloud::Ptr cloud;
  const CloudNumbers numbers;
  ShapeField::ConstPtr whole;
  std::vector<Part> parts;
};

TEST_F(PartsOfClouds, HaveTheSurfacesOfTheWhole)
{
  const FacesAround::Noise noise = noiseOfFaces();
  std::size_t compared = 0;
  forEachFaces([&](const Part& part, const FacesAround& faces) {
    const std::vector<std::vector<float>> likelihoods = faces.likelihoods(noise);
    ASSERT_EQ(likelihoods.size(), whole->likelihoods.size());
    for (std::size_t c = 0; c < likelihoods.size(); ++c)
      EXPECT_TRUE(sameBits(likelihoods[c], ofWhole(part, c))) << "class " << c;
    compared += part.indices.size();
  });
  EXPECT_EQ(compared, cloud->size());
  const std::vector<float>& of_pipe = whole->likelihoods[curved];
  EXPECT_GT(
      std::count_if(of_pipe.begin(), of_pipe.end(), [](float l) { return l > 0.5f; }),
      100); // planes alone would say little
}

TEST_F(PartsOfClouds, HaveOtherSurfacesWithoutWhatIsAround)
{
  const FacesAround::Noise noise = noiseOfFaces();
  for (const Part& part : parts) {
    const XYZView places = detail::xyzOf(part.own);
    const FacesAround alone(part.faces, places, numbers, 1);
    EXPECT_FALSE(sameBits(alone.likelihoods(noise)[curved], ofWhole(part, curved)));
  }
}

/** A piece belongs to the part that its first point is of. */
TEST_F(PartsOfClouds, HaveEachPieceOnce)
{
  std::vector<std::array<float, 3>> firsts;
  std::size_t outward = 0;
  for (std::size_t p = 0; p < parts.size(); ++p) {
    const LinkedPieces& linked = parts[p].faces.linked;
    ASSERT_EQ(linked.link_begins.size(), linked.pieces.size() + 1);
    for (const FacePiece& piece : linked.pieces) {
      EXPECT_EQ(partOf({piece.first[0], piece.first[1], piece.first[2]}),
                static_cast<int>(p));
      firsts.push_back(piece.first);
    }
    for (const std::array<float, 3>& other : linked.others)
      EXPECT_NE(partOf({other[0], other[1], other[2]}), static_cast<int>(p));
    outward += linked.others.size();
  }
  std::sort(firsts.begin(), firsts.end());
  EXPECT_EQ(std::adjacent_find(firsts.begin(), firsts.end()), firsts.end());
  EXPECT_GT(outward, 10U);
}

TEST_F(PartsOfClouds, WithoutASpacingAreRefused)
{
  CloudNumbers none = numbers;
  none.spacing = 0.0f;
  EXPECT_THROW(facesOfPart(*whole, none, std::vector<bool>(cloud->size(), true), 1),
               std::invalid_argument);
}

TEST_F(PartsOfClouds, AreNotAskedForSurfacesByTheField)
{
  ShapeFieldEstimation<PointXYZ> estimation;
  estimation.setInputCloud(cloud);
  estimation.setCloudNumbers(numbers);
  ShapeField field;
  expectParts(errorsOf([&] { EXPECT_FALSE(estimation.compute(field)); }),
              {"setEdgesOnly(true)", "facesOfPart()"});
}

} // namespace
