// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Parts reconstructed from photographs: density, smoothing, noise and outliers.

#include "scene/checksum.h"
#include "scene/parts/part.h"
#include "scene/sensors/photogrammetry.h"
#include "scene/vector_at.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

using namespace pcl::scene;
using pcl_shape_test::vectorAt;

namespace {

/** How far a point is off the plane or surface through the exact one. */
double
offset(const Part& part, const PartSamples& samples, std::size_t i)
{
  const Scene& scene = samples.scene;
  // Only flat faces: their plane is known from any point of them.
  const PartFace& face = *part.faces()[scene.face[i]];
  Random random(1, 1);
  return dot(vectorAt(scene.xyz, i) - face.randomPoint(random),
             vectorAt(scene.normals, i));
}

struct Reconstruction {
  PartOptions options;
  Part part;
  PartSamples samples;

  explicit Reconstruction(std::uint64_t seed)
  {
    options.seed = seed;
    Random random(seed, part_stream);
    part = randomPart(options.size, random);
    samples = reconstructPart(options);
  }

  /** Points of flat faces that are no outliers. */
  bool
  isFlat(std::size_t i) const
  {
    return part.faces()[samples.scene.face[i]]->isFlat() &&
           (samples.scene.surface[i] != SurfaceVoid || samples.crease_s[i] < 3.0F);
  }
};

} // namespace

TEST(Photogrammetry, NoiseIsAThirdOfASpacingAndCreasesAreRounded)
{
  const Reconstruction made(3);
  double far = 0.0, beside = 0.0, mean_beside = 0.0;
  std::size_t far_count = 0, beside_count = 0;
  for (std::size_t i = 0; i < made.samples.scene.width; ++i) {
    if (!made.isFlat(i) || made.samples.thin_s[i] < 6.0F)
      continue;
    const double off = offset(made.part, made.samples, i) / made.options.spacing;
    if (std::abs(off) > 3.0)
      continue; // an outlier beside a crease
    if (1000.0F * made.options.spacing * 6.0 < made.samples.scene.crease_mm[i]) {
      far += off * off;
      ++far_count;
    }
    else if (made.samples.scene.crease_mm[i] < 0.3 * 1000.0 * made.options.spacing) {
      beside += off * off;
      mean_beside += std::abs(off);
      ++beside_count;
    }
  }
  ASSERT_GT(far_count, 3000U);
  ASSERT_GT(beside_count, 100U);
  EXPECT_NEAR(std::sqrt(far / static_cast<double>(far_count)), 0.3, 0.02);
  // On the edge of two half planes the mean within 2.5 is 2.5 * 4 / (3 pi) / 2 away.
  EXPECT_GT(mean_beside / static_cast<double>(beside_count), 0.4);
  EXPECT_LT(mean_beside / static_cast<double>(beside_count), 0.7);
}

TEST(Photogrammetry, DensityFollowsTheTexture)
{
  double least = 1.0, most = 0.0;
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    const Reconstruction made(seed);
    for (std::size_t i = 0; i < made.samples.scene.width; ++i) {
      // The local spacing, from the same length in meters and in spacings
      if (made.samples.crease_s[i] < 1.0F || made.samples.scene.crease_mm[i] > 49.0F)
        continue;
      const double spacing =
          0.001 * made.samples.scene.crease_mm[i] / made.samples.crease_s[i];
      const double density =
          made.options.spacing * made.options.spacing / (spacing * spacing);
      least = std::min(least, density);
      most = std::max(most, density);
    }
  }
  EXPECT_LE(most, 1.0 + 1e-4);
  EXPECT_GT(most, 0.9);
  EXPECT_GE(least, 1.0 / 30.0 - 1e-4);
  EXPECT_LT(least, 0.1);
}

TEST(Photogrammetry, OnePointInTwoHundredIsAWrongMatch)
{
  const Reconstruction made(4);
  std::size_t outliers = 0, flat = 0;
  for (std::size_t i = 0; i < made.samples.scene.width; ++i) {
    if (!made.part.faces()[made.samples.scene.face[i]]->isFlat())
      continue;
    ++flat;
    const double off =
        std::abs(offset(made.part, made.samples, i)) / made.options.spacing;
    ASSERT_LT(off, 22.0);
    if (off < 3.0)
      continue;
    ++outliers;
    ASSERT_EQ(made.samples.scene.surface[i], SurfaceVoid);
    ASSERT_EQ(made.samples.scene.edge[i], EdgeVoid);
  }
  // Of offsets up to 20 in all directions .57 are more than 3 along the normal.
  const double expected = 0.57 * static_cast<double>(flat) / 200.0;
  EXPECT_NEAR(static_cast<double>(outliers), expected, 4.0 * std::sqrt(expected));
}

TEST(Photogrammetry, SameOnEveryMachine)
{
  PartOptions options;
  options.seed = 9;
  options.spacing = 0.002;
  const Scene scene = reconstructPart(options).scene;
  EXPECT_EQ(scene.width, 4003U);
  EXPECT_EQ(pcl_shape_test::checksum(scene), 0xb417694fde4f3b34ULL);
  EXPECT_NEAR(scene.xyz[300], 0.04967554, 1e-6);
}

TEST(Photogrammetry, SeedsDecideAndOptionsAreChecked)
{
  const Reconstruction a(7), b(7);
  EXPECT_EQ(a.samples.scene.xyz, b.samples.scene.xyz);
  EXPECT_EQ(a.samples.scene.edge, b.samples.scene.edge);
  PartOptions options;
  options.size = 5.0;
  EXPECT_THROW(reconstructPart(options), std::invalid_argument);
}
