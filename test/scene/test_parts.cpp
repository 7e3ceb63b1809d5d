// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Outlines and faces of machined parts, and points sampled over them with their truth.

#include "scene/checksum.h"
#include "scene/parts/part.h"
#include "scene/sensors/part_samples.h"
#include "scene/vector_at.h"
#include "support/errors.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <stdexcept>
#include <string>
#include <utility>

using namespace pcl::scene;
using pcl_shape_test::vectorAt;

namespace {

constexpr double pi = 3.14159265358979323846;

std::vector<Vec3>
rectangle(double length, double width)
{
  const double a = 0.5 * length, b = 0.5 * width;
  return {{-a, -b}, {a, -b}, {a, b}, {-a, b}};
}

/** A plate of 60 by 40 by 10 mm with a hole of 16 mm in its middle. */
Part
plateWithHole()
{
  Part part;
  const Loop outline = Loop::polygon(rectangle(0.06, 0.04), {0.0, 0.0, 0.0, 0.0});
  const Loop hole = Loop::circle({}, 0.008);
  part.addWall(outline, {{{0.0, 0.0}, {0.0, 0.01}}});
  part.addWall(hole, {{{0.0, 0.01}, {0.0, 0.0}}});
  part.addLevel(0.0, false, {outline}, {{hole}});
  part.addLevel(0.01, true, {outline}, {{hole}});
  return part;
}

/** A disc, 40 mm wide and 12 mm high, whose upper rim is rounded by 4 mm. Faces: wall,
 * fillet, bottom, top. */
Part
roundedDisc()
{
  Part part;
  const Loop outline = Loop::circle({}, 0.02);
  part.addWall(
      outline,
      {{{0.0, 0.0}, {0.0, 0.008}}, {{0.0, 0.008}, {0.004, 0.012}, Bend::FromUpright}});
  part.addLevel(0.0, false, {outline}, {});
  part.addLevel(0.012, true, {outline, 0.004}, {});
  return part;
}

std::string
refusal(const PartOptions& options)
{
  return pcl::test::exceptionOf<std::invalid_argument>([&] { samplePart(options); });
}

/** Along a line from outside: where it meets faces, and whether it enters there. */
std::vector<std::pair<double, bool>>
meetings(const Part& part, const Ray& line)
{
  std::vector<std::pair<double, bool>> found;
  for (const auto& face : part.faces())
    face->meet(line, [&](double t) {
      const Vec3 normal = face->normal(line.origin + line.direction * t);
      found.emplace_back(t, dot(normal, line.direction) < 0.0);
    });
  std::sort(found.begin(), found.end());
  return found;
}

Vec3
randomDirection(Random& random)
{
  const double z = random.uniform(-1.0, 1.0);
  const UnitVector heading = fromTurns(random.uniform());
  const double level = std::sqrt(1.0 - z * z);
  return {level * heading.cosine, level * heading.sine, z};
}

} // namespace

TEST(Parts, LoopsEncloseWhatTheyShould)
{
  const double a = 0.06, b = 0.04, r = 0.005;
  const Loop rounded = Loop::polygon(rectangle(a, b), {r, r, r, r});
  EXPECT_NEAR(rounded.area(0.0), a * b - (4.0 - pi) * r * r, 1e-12);
  const double d = 0.002, inner = r - d;
  EXPECT_NEAR(
      rounded.area(d), (a - 2 * d) * (b - 2 * d) - (4.0 - pi) * inner * inner, 1e-12);
  EXPECT_TRUE(rounded.contains({0.0299, 0.0001}, 0.0));
  EXPECT_FALSE(rounded.contains({0.0299, 0.0199}, 0.0)) << "the corner is rounded";
  EXPECT_FALSE(rounded.contains({0.0299, 0.0001}, d));
  EXPECT_NEAR(rounded.distance({0.0, 0.0}, d), 0.5 * b - d, 1e-12);

  const Loop sharp = Loop::polygon(rectangle(a, b), {0.0, 0.0, 0.0, 0.0});
  EXPECT_NEAR(sharp.area(d), (a - 2 * d) * (b - 2 * d), 1e-12);
  const Loop slot = Loop::polygon(rectangle(a, 0.01), {r, r, r, r});
  EXPECT_NEAR(slot.area(0.0), (a - 2 * r) * 2 * r + pi * r * r, 1e-12);

  // An L with one inner corner, which a rounding fills
  const std::vector<Vec3> corners{
      {0, 0}, {0.04, 0}, {0.04, 0.02}, {0.02, 0.02}, {0.02, 0.04}, {0, 0.04}};
  const Loop ell = Loop::polygon(corners, {0.0, 0.0, 0.0, r, 0.0, 0.0});
  EXPECT_NEAR(ell.area(0.0), 0.0012 + (1.0 - pi / 4.0) * r * r, 1e-12);
  EXPECT_TRUE(ell.contains({0.0205, 0.0206}, 0.0));
  EXPECT_FALSE(ell.contains({0.0245, 0.0246}, 0.0));
}

TEST(Parts, APlateHasTheTruthOfItsDrawing)
{
  PartOptions options;
  options.spacing = 0.0005;
  const PartSamples samples = samplePart(plateWithHole(), options);
  const Scene& scene = samples.scene;
  const double area =
      2.0 * (0.06 * 0.04 - pi * 0.008 * 0.008) + 0.2 * 0.01 + 2.0 * pi * 0.008 * 0.01;
  EXPECT_NEAR(static_cast<double>(scene.surface.size()),
              area / (options.spacing * options.spacing),
              1.0);
  for (std::size_t i = 0; i < scene.surface.size(); ++i) {
    const Vec3 p = vectorAt(scene.xyz, i), normal = vectorAt(scene.normals, i);
    const double rho = std::sqrt(p.x * p.x + p.y * p.y);
    const double x = 0.03 - std::abs(p.x), y = 0.02 - std::abs(p.y);
    const double z = std::min(p.z, 0.01 - p.z), hole = rho - 0.008;
    double crease = 0.0;
    if (std::abs(normal.z) > 0.5)
      crease = std::min({x, y, hole});
    else
      crease = std::abs(hole) < 1e-6 ? z : std::min(z, std::max(x, y));
    ASSERT_NEAR(samples.crease_s[i] * options.spacing, crease, 1e-7) << i;
    ASSERT_NEAR(scene.crease_mm[i], 1000.0 * crease, 1e-4);
    if (std::abs(normal.z) > 0.5) {
      ASSERT_NEAR(samples.thin_s[i] * options.spacing, 0.01, 1e-6);
    }
    const bool is_round = std::abs(hole) < 1e-6 && std::abs(normal.z) < 0.5;
    ASSERT_EQ(scene.surface[i], is_round ? SurfaceCurved : SurfacePlanar);
    ASSERT_NEAR(samples.radius_s[i], is_round ? 16.0 : 1e6, 1e-3);
    const double spacings = crease / options.spacing;
    const Edge edge = spacings < 1.5 ? EdgeCrease : spacings < 3.0 ? EdgeVoid : EdgeNot;
    const bool is_between =
        std::min(std::abs(spacings - 1.5), std::abs(spacings - 3.0)) < 1e-3;
    ASSERT_TRUE(is_between || scene.edge[i] == edge) << i;
  }
}

TEST(Parts, AFilletIsATorusWithoutCreases)
{
  PartOptions options;
  options.spacing = 0.0003;
  const PartSamples samples = samplePart(roundedDisc(), options);
  std::size_t on_fillet = 0, void_on_top = 0;
  for (std::size_t i = 0; i < samples.scene.surface.size(); ++i) {
    const Vec3 p = vectorAt(samples.scene.xyz, i);
    const Vec3 normal = vectorAt(samples.scene.normals, i);
    const double rho = std::sqrt(p.x * p.x + p.y * p.y);
    ASSERT_NEAR(samples.crease_s[i] * options.spacing, // only its lower rim
                std::sqrt((rho - 0.02) * (rho - 0.02) + p.z * p.z),
                1e-7);
    if (samples.scene.face[i] == 1) {
      ++on_fillet;
      const Vec3 center{0.016 * p.x / rho, 0.016 * p.y / rho, 0.008};
      ASSERT_NEAR(norm(p - center), 0.004, 1e-7);
      ASSERT_NEAR(dot(normal, p - center), 0.004, 1e-7);
      ASSERT_NEAR(samples.radius_s[i] * options.spacing, 0.004, 1e-6);
      ASSERT_EQ(samples.scene.surface[i], SurfaceCurved);
    }
    else if (samples.scene.face[i] == 3) {
      const double beside = (0.016 - rho) / options.spacing;
      void_on_top += samples.scene.surface[i] == SurfaceVoid;
      ASSERT_EQ(samples.scene.surface[i], beside < 4.0 ? SurfaceVoid : SurfacePlanar);
      ASSERT_EQ(samples.scene.edge[i], EdgeNot) << "13 spacings are no tight fillet";
    }
  }
  // Pappus: the quarter circle's length times the way of its middle
  const double area = 0.5 * pi * 0.004 * 2.0 * pi * (0.016 + 0.004 * 2.0 / pi);
  const double expected = area / (options.spacing * options.spacing);
  EXPECT_NEAR(static_cast<double>(on_fillet), expected, 4.0 * std::sqrt(expected));
  EXPECT_GT(void_on_top, 100U);
  options.spacing = 0.001; // now it is one
  const PartSamples coarse = samplePart(roundedDisc(), options);
  std::size_t tight = 0;
  for (std::size_t i = 0; i < coarse.scene.edge.size(); ++i) {
    tight += coarse.radius_s[i] < 10.0F;
    ASSERT_TRUE(coarse.radius_s[i] >= 10.0F || coarse.scene.edge[i] != EdgeNot);
  }
  EXPECT_GT(tight, 300U);
}

TEST(Parts, RoundWallsNeedRoundCorners)
{
  Part part;
  const Loop sharp = Loop::polygon(rectangle(0.06, 0.04), {0.0, 0.0, 0.0, 0.0});
  EXPECT_THROW(part.addWall(sharp, {{{0.0, 0.0}, {0.004, 0.004}, Bend::FromUpright}}),
               std::invalid_argument);
}

TEST(Parts, RandomPartsAreClosed)
{
  std::size_t entered = 0, flat = 0, round = 0;
  std::set<std::size_t> sizes;
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    Random random(seed, part_stream);
    const Part part = randomPart(0.1, random);
    const Sphere bounds = part.bounds();
    sizes.insert(part.faces().size());
    for (const auto& face : part.faces())
      ++(face->isFlat() ? flat : round);
    for (int i = 0; i < 300; ++i) {
      const Vec3 direction = randomDirection(random);
      const Vec3 through =
          bounds.center + randomDirection(random) * (bounds.radius * random.uniform());
      const Ray line{through - direction * (3.0 * bounds.radius), direction};
      const auto found = meetings(part, line);
      ASSERT_EQ(found.size() % 2, 0U) << "seed " << seed << " line " << i;
      for (std::size_t k = 0; k < found.size(); ++k)
        ASSERT_EQ(found[k].second, k % 2 == 0) << "seed " << seed << " line " << i;
      entered += !found.empty();
    }
  }
  EXPECT_GT(entered, 5000U);
  EXPECT_GT(flat, 1000U);
  EXPECT_GT(round, 500U);
  EXPECT_GT(sizes.size(), 20U) << "they are not all alike";
}

TEST(Parts, FlatFacesEndAtCreasesOrRoundFaces)
{
  PartOptions options;
  options.seed = 3;
  const PartSamples samples = samplePart(options);
  // No flat face has another one beside it unless a crease is near.
  std::size_t compared = 0;
  for (std::size_t i = 0; i < samples.crease_s.size(); i += 7) {
    if (samples.crease_s[i] < 3.0F || samples.radius_s[i] < 1e6F)
      continue;
    const Vec3 p = vectorAt(samples.scene.xyz, i);
    const Vec3 normal = vectorAt(samples.scene.normals, i);
    for (std::size_t j = 0; j < samples.crease_s.size(); ++j) {
      const Vec3 q = vectorAt(samples.scene.xyz, j);
      const bool is_beside = norm(q - p) < 1.5 * options.spacing;
      if (!is_beside || samples.radius_s[j] < 1e6F || samples.thin_s[i] < 2.0F)
        continue;
      compared += i != j;
      ASSERT_GT(dot(normal, vectorAt(samples.scene.normals, j)), 0.999) << i;
    }
  }
  EXPECT_GT(compared, 1000U);
}

TEST(Parts, EvenPointsKeepTheirDistance)
{
  PartOptions options;
  options.seed = 5;
  options.spacing = 0.002;
  const Scene even = samplePart(options).scene;
  options.spread = Spread::Random;
  const Scene random = samplePart(options).scene;
  const auto nearest = [](const Scene& scene) {
    double least = 1.0;
    for (std::size_t i = 0; i < scene.width; ++i)
      for (std::size_t j = i + 1; j < scene.width; ++j)
        least = std::min(least, norm(vectorAt(scene.xyz, i) - vectorAt(scene.xyz, j)));
    return least;
  };
  EXPECT_GE(nearest(even), 0.75 * options.spacing - 1e-8);
  EXPECT_LT(nearest(random), 0.1 * options.spacing);
  EXPECT_EQ(even.width, random.width) << "the density is the same";
}

TEST(Parts, NoiseIsWhiteAndMovesNoTruth)
{
  PartOptions options;
  options.seed = 6;
  const PartSamples exact = samplePart(options);
  options.sigma = 0.0004;
  const PartSamples noisy = samplePart(options);
  ASSERT_EQ(exact.scene.edge, noisy.scene.edge);
  ASSERT_EQ(exact.crease_s, noisy.crease_s);
  double squares = 0.0, neighbors = 0.0;
  const auto difference = [&](std::size_t i) {
    return static_cast<double>(noisy.scene.xyz[i]) - exact.scene.xyz[i];
  };
  const std::size_t count = exact.scene.xyz.size();
  for (std::size_t i = 0; i + 1 < count; ++i) {
    squares += difference(i) * difference(i);
    neighbors += difference(i) * difference(i + 1);
  }
  EXPECT_NEAR(std::sqrt(squares / static_cast<double>(count)), 0.0004, 0.00001);
  EXPECT_LT(std::abs(neighbors / squares), 0.02);
}

TEST(Parts, SeedsDecide)
{
  PartOptions options;
  options.seed = 7;
  const PartSamples a = samplePart(options), b = samplePart(options);
  EXPECT_EQ(a.scene.xyz, b.scene.xyz);
  EXPECT_EQ(a.scene.edge, b.scene.edge);
  options.seed = 8;
  EXPECT_NE(a.scene.xyz, samplePart(options).scene.xyz);
}

TEST(Parts, SameOnEveryMachine)
{
  PartOptions options;
  options.seed = 9;
  options.spacing = 0.002;
  const Scene scene = samplePart(options).scene;
  EXPECT_EQ(scene.width, 6838U);
  EXPECT_EQ(pcl_shape_test::checksum(scene), 0x4f14f01a5bacfb9bULL);
  EXPECT_NEAR(scene.xyz[300], 0.02658337, 1e-6);
  EXPECT_NEAR(scene.xyz[302], 0.00928636, 1e-6);
}

TEST(Parts, BadOptions)
{
  PartOptions options;
  options.size = 2.0;
  EXPECT_EQ(refusal(options), "size must be 0.01 to 1 m, not 2");
  options = {};
  options.spacing = 0.02;
  EXPECT_EQ(refusal(options), "spacing must be 0.0001 to 0.01 m, not 0.02");
  options = {};
  options.sigma = -1.0;
  EXPECT_EQ(refusal(options), "sigma must be 0 to 0.1 m, not -1");
}
