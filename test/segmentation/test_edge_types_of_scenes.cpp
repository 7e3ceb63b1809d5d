/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * Point Cloud Library (PCL) - www.pointclouds.org
 * Copyright (c) 2026, pcl_shape contributors
 *
 * All rights reserved
 */

#include "detection_scenes.h"
#include "scene/creases.h"
#include "scene/random_world.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

// The scene generator knows how far creases are. Where they meet, and where the table
// ends, follows from the world's geometry.
namespace {

using namespace pcl;
using namespace pcl::test;
using scene::Vec3;

constexpr double spacing = 0.002;          // mean distance of points, metres
constexpr double other_direction = 0.7071; // cosine of 45 degrees

struct CurvePoint {
  Vec3 position, tangent;
};

/** \brief What is at the points of a scene, by its geometry. */
class Truth {
public:
  explicit Truth(const scene::SampleOptions& options)
  {
    scene::SceneOptions same;
    same.seed = options.seed;
    same.objects = options.objects;
    world_ = scene::randomWorld(same).world;
    world_.table.half_length *= 0.5; // sampleScene() crops it so
    world_.table.half_width *= 0.6;
    findCorners();
  }

  double
  toCorner(const Vec3& p) const
  {
    double nearest = std::numeric_limits<double>::infinity();
    for (const Vec3& corner : corners_) {
      nearest = std::min(nearest, norm(p - corner));
    }
    return nearest;
  }

  /** Whether creases of clearly different directions are that near, met or not. */
  bool
  creasesMeetWithin(const Vec3& p, double reach) const
  {
    std::vector<Vec3> tangents;
    for (const CurvePoint& point : points_) {
      if (norm(point.position - p) < reach) {
        tangents.push_back(point.tangent);
      }
    }
    return std::any_of(tangents.begin(), tangents.end(), [&](const Vec3& one) {
      return std::any_of(tangents.begin(), tangents.end(), [&](const Vec3& other) {
        return std::abs(dot(one, other)) < other_direction;
      });
    });
  }

  double
  toTableRim(const Vec3& p) const
  {
    const scene::Table& table = world_.table;
    const Vec3 d = p - table.centre;
    return std::min(table.half_length - std::abs(dot(d, table.along)),
                    table.half_width - std::abs(dot(d, table.across)));
  }

  std::size_t
  corners() const
  {
    return corners_.size();
  }

private:
  /** Where two creases whose directions differ by more than 45 degrees meet. */
  void
  findCorners()
  {
    const scene::Creases creases(world_, scene::Observer{});
    for (const scene::Curve& part : creases.parts()) {
      constexpr int steps = 200;
      for (int s = 0; s <= steps; ++s) {
        const double parameter = part.parameter(static_cast<double>(s) / steps);
        points_.push_back({part.point(parameter), part.tangent(parameter)});
      }
    }
    for (const CurvePoint& a : points_) {
      if (std::any_of(points_.begin(), points_.end(), [&](const CurvePoint& b) {
            return norm(a.position - b.position) < 0.5 * spacing &&
                   std::abs(dot(a.tangent, b.tangent)) < other_direction;
          })) {
        corners_.push_back(a.position);
      }
    }
  }

  scene::World world_;
  std::vector<CurvePoint> points_; ///< of all creases
  std::vector<Vec3> corners_;
};

/** \brief How many points of one kind there are, and how many were called so. */
struct Share {
  double all = 0, found = 0;

  void
  add(bool is_found)
  {
    all += 1;
    found += is_found ? 1 : 0;
  }

  double
  value() const
  {
    return found / all;
  }
};

struct Shares {
  Share creases, corners, rim, inside, right_corners;
};

void
count(const scene::Scene& scene,
      const Truth& truth,
      const std::vector<EdgeType>& types,
      Shares& shares)
{
  for (std::size_t i = 0; i < types.size(); ++i) {
    const Vec3 p{scene.xyz[3 * i], scene.xyz[3 * i + 1], scene.xyz[3 * i + 2]};
    const double to_crease = scene.crease_mm[i] / 1000;
    const double to_corner = to_crease < 0.02 ? truth.toCorner(p) : 1.0;
    const bool is_edge = types[i] == EdgeType::Crease || types[i] == EdgeType::Corner;
    // A type is a matter of points that were found to be edges.
    if (is_edge && to_crease < 2 * spacing && to_corner > 8 * spacing)
      shares.creases.add(types[i] == EdgeType::Crease);
    if (is_edge && to_corner < 2 * spacing)
      shares.corners.add(types[i] == EdgeType::Corner);
    if (types[i] == EdgeType::Corner)
      shares.right_corners.add(truth.creasesMeetWithin(p, 5 * spacing));
    const bool is_table = scene.instance[i] == 0;
    if (is_table && to_crease > 8 * spacing && truth.toTableRim(p) < 0.1 * spacing)
      shares.rim.add(types[i] == EdgeType::OpenBoundary);
    const double to_rim = is_table ? truth.toTableRim(p) : 1.0;
    if (scene.edge[i] == scene::EdgeNot && to_rim > 2 * spacing)
      shares.inside.add(types[i] == EdgeType::None);
  }
}

TEST(EdgeTypesOfScenes, CreasesCornersAndTheTablesRim)
{
  Shares shares;
  for (const std::uint64_t seed : {31U, 32U, 33U}) {
    scene::SampleOptions options;
    options.seed = seed;
    options.objects = 3;
    options.spacing = spacing;
    const scene::Scene scene = scene::sampleScene(options);
    const Truth truth(options);
    ASSERT_GT(truth.corners(), 0U) << "seed " << seed;
    count(scene, truth, detectedIn(cloudOf(scene)).types, shares);
  }
  ASSERT_GT(shares.rim.all, 100);
  ASSERT_GT(shares.corners.all, 100);
  // Almost all of what is far from any doubt; at corners three faces meet, which two
  // planes do not fit, and creases of stacked objects are too near each other to tell.
  EXPECT_GE(shares.creases.value(), 0.95);
  EXPECT_GE(shares.corners.value(), 0.85);
  EXPECT_GE(shares.right_corners.value(), 0.75);
  EXPECT_GE(shares.rim.value(), 0.90);
  EXPECT_GE(shares.inside.value(), 0.98);
}

} // namespace
