// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Curved is what turns across its face by more than the noise: at any sampling, beside
// other faces, and whatever waves a sensor makes.

#include "common/statistics.h"
#include "segmentation/field_of.h"
#include "support/bits.h"
#include "support/random.h"
#include "support/shapes.h"
#include "surfaces/face_evidence.h"
#include "surfaces/face_fit.h"
#include "surfaces/surface_classification.h"

#include <pcl/point_types.h>

#include <boost/math/distributions/normal.hpp>
#include <boost/math/distributions/students_t.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

namespace {

using namespace pcl;
using namespace pcl::test;
using segmentation::FaceFit;
using segmentation::FaceLevel;
using segmentation::medianSpacing;

using Cloud = PointCloud<PointXYZ>;

/** Points of a surface over a rectangle, jittered: place(u, v) for u and v from 0. */
template <typename Place>
Cloud::Ptr
sampled(double width, double height, double spacing, double noise, const Place& place)
{
  Random random(77);
  const auto cloud = make_shared<Cloud>();
  for (double u = 0; u < width; u += spacing)
    for (double v = 0; v < height; v += spacing) {
      const double jitter = 0.3 * spacing;
      Eigen::Vector3d p = place(u + random.uniform(-jitter, jitter),
                                v + random.uniform(-jitter, jitter));
      for (int axis = 0; axis < 3; ++axis)
        p[axis] += noise * random.normal();
      cloud->emplace_back(static_cast<float>(p.x()),
                          static_cast<float>(p.y()),
                          static_cast<float>(p.z()));
    }
  return cloud;
}

double
shareOfCurved(const ShapeField& field)
{
  const std::vector<float>& curved = field.likelihoods.at(1);
  const auto is_curved = [](float likelihood) { return likelihood > 0.5f; };
  return static_cast<double>(std::count_if(curved.begin(), curved.end(), is_curved)) /
         static_cast<double>(curved.size());
}

Cloud::Ptr
cylinder(double radius, double spacing)
{
  const double width = 2.0 * radius; // an arc of 115 degrees
  return sampled(width, width, spacing, 0.0, [&](double u, double v) {
    const double angle = u / radius;
    return Eigen::Vector3d(radius * std::cos(angle), v, 1.0 + radius * std::sin(angle));
  });
}

TEST(Faces, OneCylinderIsCurvedAtAnySampling)
{
  // 8 to 100 distances between points in radius: 4 to 50 spacings.
  for (const double spacing : {0.006, 0.003, 0.001, 0.0005})
    EXPECT_GE(shareOfCurved(fieldOf(cylinder(0.05, spacing))), 0.98) << spacing;
}

TEST(Faces, WavesOfASensorAreNotCurved)
{
  // Crests of 1 to 1.5 mm, 30 to 50 mm apart, as depth cameras of several kinds make.
  const auto table = sampled(0.5, 0.4, 0.0025, 0.0003, [](double u, double v) {
    constexpr double turn = 6.283185307179586;
    const double wave = std::sin(turn * (u + 0.3 * v) / 0.05) +
                        0.5 * std::sin(turn * (v - 0.4 * u) / 0.03);
    return Eigen::Vector3d(u, v, 1.0 + 0.001 * wave);
  });
  EXPECT_LE(shareOfCurved(fieldOf(table)), 0.005);
}

/** Heights of 2 mm (standard deviation) that change over 45 to 70 mm in all directions,
 * as a stereo camera's at a meter. */
class StereoWaves {
public:
  StereoWaves()
  {
    constexpr double turn = 6.283185307179586;
    Random random(3);
    for (Wave& wave : waves_) {
      const double direction = random.uniform(0.0, turn);
      const double number = turn / random.uniform(0.045, 0.07);
      wave = {number * std::cos(direction),
              number * std::sin(direction),
              random.uniform(0.0, turn)};
    }
  }

  double
  operator()(double u, double v) const
  {
    double sum = 0.0;
    for (const Wave& wave : waves_)
      sum += std::sin(wave.along_u * u + wave.along_v * v + wave.phase);
    return 0.002 * std::sqrt(2.0 / static_cast<double>(waves_.size())) * sum;
  }

private:
  struct Wave {
    double along_u, along_v, phase;
  };
  std::array<Wave, 16> waves_{};
};

TEST(Faces, LargeFlatWindowsExplainWhatBendsSmallOnes)
{
  // The highest of so many crests bend small windows by more than waves usually do.
  const StereoWaves waves;
  const auto table = sampled(0.8, 0.6, 0.0025, 0.0003, [&](double u, double v) {
    return Eigen::Vector3d(u, v, 1.0 + waves(u, v));
  });
  EXPECT_LE(shareOfCurved(fieldOf(table)), 0.005);
}

TEST(Faces, ABallIsCurvedInSpiteOfSuchWaves)
{
  const StereoWaves waves;
  const auto ball = sampled(0.16, 0.1, 0.0025, 0.0003, [&](double u, double v) {
    const double longitude = u / 0.05, latitude = (v - 0.05) / 0.05;
    const Eigen::Vector3d out(std::cos(latitude) * std::cos(longitude),
                              std::cos(latitude) * std::sin(longitude),
                              std::sin(latitude));
    return Eigen::Vector3d((0.05 + waves(u, v)) * out + Eigen::Vector3d::UnitZ());
  });
  EXPECT_GE(shareOfCurved(fieldOf(ball)), 0.98);
}

TEST(Faces, ADomeIsCurvedWhereNoiseIsAsLargeAsCells)
{
  // White noise of three distances between points, on a table as wide as large windows.
  constexpr double radius = 0.08, middle = 0.19;
  const auto from_middle = [](double u, double v) {
    return std::hypot(u - middle, v - middle);
  };
  const auto cloud =
      sampled(2.0 * middle, 2.0 * middle, 0.0016, 0.0045, [&](double u, double v) {
        const double r = std::min(radius, from_middle(u, v));
        return Eigen::Vector3d(u, v, 1.0 + std::sqrt(radius * radius - r * r));
      });
  const ShapeField field = fieldOf(cloud);
  int dome = 0, found = 0, table = 0, wrong = 0;
  for (std::size_t i = 0; i < cloud->size(); ++i) {
    const bool is_curved = field.likelihoods[1][i] > 0.5f;
    const double r = from_middle((*cloud)[i].x, (*cloud)[i].y);
    if (r < 0.75 * radius) {
      ++dome;
      found += is_curved;
    }
    if (r > 1.3 * radius) {
      ++table;
      wrong += is_curved;
    }
  }
  EXPECT_GE(found, 0.97 * dome);
  EXPECT_LE(wrong, 0.005 * table);
}

TEST(Faces, StepsOfAStaircaseAreFlat)
{
  for (const double noise : {0.0, 0.15}) {
    constexpr double step = 12.0; // distances between points: 6 spacings
    const auto stairs =
        sampled(10 * step, 8 * step, 1.0, noise, [](double u, double v) {
          const double half = std::floor(u / step), rest = u - half * step;
          const double up = std::ceil(half / 2) * step,
                       along = std::floor(half / 2) * step;
          const bool is_tread = std::fmod(half, 2.0) == 0.0;
          return is_tread ? Eigen::Vector3d(along + rest, v, 200 + up)
                          : Eigen::Vector3d(along + step, v, 200 + up - step + rest);
        });
    // With noise, some edge points between steps take a face that was found across one.
    EXPECT_LE(shareOfCurved(fieldOf(stairs)), noise > 0.0 ? 0.04 : 0.005) << noise;
  }
}

TEST(Faces, AThinWallIsCurvedWhereItTurns)
{
  // With noise a cell is nearly as wide as the wall is thick: 5 distances of points.
  constexpr double thickness = 5.0, flat = 30.0, height = 60.0, noise = 0.4;
  for (const double radius : {20.0, 25.0}) {
    const double arc = 0.5 * pi * radius;
    const auto wall =
        sampled(2 * flat + arc, 2 * height, 1.0, noise, [&](double u, double v) {
          const double inward = v > height ? thickness : 0.0;
          const double along = std::clamp(u - flat, 0.0, arc), angle = along / radius;
          const double rest = u - flat - along, r = radius - inward;
          return Eigen::Vector3d(r * std::sin(angle) + rest * std::cos(angle),
                                 v > height ? v - height : v,
                                 200 - r * std::cos(angle) + rest * std::sin(angle));
        });
    const ShapeField field = fieldOf(wall);
    int turning = 0, found = 0;
    for (std::size_t i = 0; i < wall->size(); ++i) {
      const double angle = std::atan2((*wall)[i].x, 200.0 - (*wall)[i].z);
      if (angle > 0.2 && angle < 0.5 * pi - 0.2) {
        ++turning;
        found += field.likelihoods[1][i] > 0.5f;
      }
    }
    EXPECT_GE(found, 0.98 * turning) << radius;
  }
}

TEST(Faces, NeitherOrderNorThreadsMatter)
{
  const auto cloud = cylinder(0.05, 0.002);
  std::vector<std::size_t> order(cloud->size());
  std::iota(order.begin(), order.end(), 0);
  Random random(5);
  for (std::size_t i = order.size(); i > 1; --i)
    std::swap(order[i - 1], order[random.index(i)]);
  const auto other = make_shared<Cloud>();
  for (const std::size_t i : order)
    other->push_back((*cloud)[i]);
  const ShapeField first = fieldOf(cloud, 1), second = fieldOf(other, 3);
  std::vector<float> expected;
  for (const std::size_t i : order)
    expected.push_back(first.likelihoods[1][i]);
  EXPECT_TRUE(sameBits(expected, second.likelihoods[1]));
}

TEST(FaceLinks, AreInTheOrderOfNodesAndOnceEach)
{
  FaceLevel level;
  level.nodes.resize(4);
  segmentation::setLinks({{2, 3}, {0, 3}, {0, 1}, {2, 0}, {0, 1}, {2, 3}}, level);
  EXPECT_EQ(level.link_begins, (std::vector<std::uint32_t>{0, 2, 2, 4, 4}));
  EXPECT_EQ(level.links, (std::vector<std::uint32_t>{1, 3, 0, 3}));
  segmentation::setLinks({}, level);
  EXPECT_EQ(level.link_begins, (std::vector<std::uint32_t>(5, 0)));
  EXPECT_TRUE(level.links.empty());
}

TEST(FaceLinks, DoNotDependOnThreads)
{
  const Cloud::Ptr cloud = sampled(1.0, 1.0, 0.005, 0.0, [](double u, double v) {
    return Eigen::Vector3d(u, v, 0.1 * u * u);
  });
  const ShapeField field = edgeFieldOf(cloud);
  const float usual = medianSpacing(field.spacings);
  const FaceLevel one =
      segmentation::firstFaces(field.points, field, usual, 1).levels.front();
  const FaceLevel three =
      segmentation::firstFaces(field.points, field, usual, 3).levels.front();
  ASSERT_GT(one.nodes.size(), 8192U); // of which threads get parts
  EXPECT_EQ(one.link_begins, three.link_begins);
  EXPECT_EQ(one.links, three.links);
}

TEST(FaceLinks, DoNotLeadFromOneSheetToAnother)
{
  constexpr double half_size = 40.0, noise = 0.4; // distances between points
  for (const double apart : {4.0, 5.0, 6.0}) {
    const Cloud::Ptr cloud =
        sampled(half_size, 2 * half_size, 1.0, noise, [&](double u, double v) {
          const bool is_upper = v > half_size;
          return Eigen::Vector3d(u, is_upper ? v - half_size : v, is_upper ? apart : 0);
        });
    ShapeField field = edgeFieldOf(cloud);
    std::fill(field.normals.begin(), field.normals.end(), Eigen::Vector3f::UnitZ());
    std::fill(field.edge_likelihood.begin(), field.edge_likelihood.end(), 0.0f);
    const FaceLevel level =
        segmentation::firstFaces(field.points, field, medianSpacing(field.spacings), 1)
            .levels.front();
    const auto height = [&](std::uint32_t node) {
      return static_cast<double>(level.nodes[node].position.z());
    };
    std::uint32_t between = 0, across = 0;
    for (std::uint32_t i = 0; i < level.nodes.size(); ++i) {
      between +=
          std::min(std::abs(height(i)), std::abs(height(i) - apart)) > 0.4 * apart;
      for (std::uint32_t k = level.link_begins[i]; k < level.link_begins[i + 1]; ++k)
        across += std::abs(height(i) - height(level.links[k])) > 0.5 * apart;
    }
    EXPECT_EQ(between, 0U) << apart;
    EXPECT_EQ(across, 0U) << apart;
  }
}

/** How many windows each node of the next level has in one. */
std::vector<int>
windowsOfNodes(std::size_t level, double noise)
{
  constexpr double spacing = 0.01;
  const Cloud::Ptr cloud = sampled(1.0, 1.0, spacing, noise, [](double u, double v) {
    return Eigen::Vector3d(u, v, 0.0);
  });
  const ShapeField field = edgeFieldOf(cloud);
  const float usual = medianSpacing(field.spacings);
  segmentation::FacePyramid faces =
      segmentation::firstFaces(field.points, field, usual, 1);
  segmentation::addLevels(level + 2, faces, 1);
  const std::vector<bool> all(faces.levels[level].nodes.size(), true);
  const segmentation::FaceFits fits = segmentation::fitsOf(faces, level, all, 1);
  std::vector<int> windows(faces.levels[level + 1].nodes.size());
  for (std::size_t i = 0; i < fits.size(); ++i)
    windows[faces.levels[level].parents[i]] += fits[i] ? 1 : 0;
  return windows;
}

TEST(FaceWindows, OneForEachNodeOfTheNextLevel)
{
  for (const std::size_t level : {0, 1})
    for (const double noise : {0.0, 0.004}) {
      SCOPED_TRACE(level);
      SCOPED_TRACE(noise);
      const std::vector<int> windows = windowsOfNodes(level, noise);
      EXPECT_EQ(std::count(windows.begin(), windows.end(), 1),
                static_cast<std::ptrdiff_t>(windows.size()));
    }
}

TEST(FaceFits, RankedIsTheNthElement)
{
  Random random(78);
  for (const std::size_t count : {1, 2, 8, 35, 256, 257})
    for (int trial = 0; trial < 20; ++trial) {
      std::vector<float> values;
      for (std::size_t k = 0; k < count; ++k) // repeats, too
        values.push_back(
            std::abs(std::round(10.0f * static_cast<float>(random.normal()))));
      for (const std::size_t rank : {std::size_t{0}, count / 2, count - 1}) {
        std::vector<float> sorted = values;
        std::sort(sorted.begin(), sorted.end());
        EXPECT_EQ(segmentation::ranked(values, rank), sorted[rank]);
      }
    }
}

TEST(JoinedEvidence, WhereAllAroundIsFlatTheModelAddsNothing)
{
  const std::vector<float> of_model{5.0f, -5.0f, 5.0f, -5.0f};
  const segmentation::FaceEvidence of_faces{{-1.0f, -1.0f, 1.0f, -1.0f},
                                            {1.0f, 1.0f, 1.0f, 0.5f}};
  const std::vector<float> joined = detail::joinedEvidence(of_model, of_faces);
  EXPECT_EQ(joined[1], -1.0f);
  EXPECT_EQ(joined[3], -1.0f);
  EXPECT_EQ(joined[5], 1.0f) << "nothing for curved";
  EXPECT_EQ(joined[7], -3.0f) << "at most so much for planar";
}

TEST(FaceWindows, NoiseOfALevelWithoutThemDoesNotBoundTheNext)
{
  const Cloud::Ptr cloud = sampled(0.3, 1.0, 0.01, 0.004, [](double u, double v) {
    return Eigen::Vector3d(u, v, 2.0 * u * u);
  });
  const ShapeField field = edgeFieldOf(cloud);
  const float usual = medianSpacing(field.spacings);
  segmentation::FacePyramid faces =
      segmentation::firstFaces(field.points, field, usual, 1);
  segmentation::addLevels(3, faces, 1);
  std::vector<segmentation::FaceFits> fits;
  for (std::size_t l = 0; l < faces.levels.size(); ++l) {
    const std::vector<bool> wanted(faces.levels[l].nodes.size(), l > 0);
    fits.push_back(segmentation::fitsOf(faces, l, wanted, 1));
  }
  const float noise = 0.2f * usual;
  const auto curved = [&](float first_noise) {
    return segmentation::faceEvidence(
               faces, fits, {first_noise, noise, noise}, usual, 1)
        .curved;
  };
  EXPECT_TRUE(sameBits(curved(noise), curved(0.0f)));
  EXPECT_FALSE(sameBits(curved(noise), curved(0.1f * noise))) << "a bound";
}

TEST(FaceWindows, ATenthOfTheResidualsIsTheNoiseOfACloud)
{
  segmentation::FaceFits fits(100);
  for (std::size_t i = 0; i < fits.size(); ++i) {
    fits[i] = FaceFit();
    fits[i]->residual = static_cast<float>(i);
  }
  EXPECT_EQ(segmentation::noiseOfCloud(fits), 10.0f);
  EXPECT_EQ(segmentation::rankOfNoise(100), 10U);
  EXPECT_EQ(segmentation::rankOfNoise(15), 2U) << "not the least of few";
  EXPECT_EQ(segmentation::rankOfNoise(5), 1U);
  EXPECT_EQ(segmentation::rankOfNoise(1), 0U);
}

/** The evidence of a flat cloud's nodes if all windows were like this one. */
float
evidenceOfAll(const FaceFit& fit, float noise)
{
  const Cloud::Ptr cloud = sampled(0.5, 0.5, 0.01, 0.0, [](double u, double v) {
    return Eigen::Vector3d(u, v, 1.0);
  });
  const ShapeField field = edgeFieldOf(cloud);
  const float usual = medianSpacing(field.spacings);
  const auto faces = segmentation::firstFaces(field.points, field, usual, 1);
  return segmentation::faceEvidence(
             faces,
             {segmentation::FaceFits(faces.levels.front().nodes.size(), fit)},
             {noise * usual},
             usual,
             1)
      .curved.front();
}

TEST(FaceWindows, ABulgeThatIsNotCertainSaysLittle)
{
  FaceFit fit;
  fit.half_width = 0.1f;
  fit.bulge = 0.02f; // a turn by 46 degrees
  fit.residual = 0.0005f;
  fit.inliers = fit.center_cosine = 1.0f;
  fit.freedom = 30.0f;
  fit.bulge_error = 0.001f; // of twenty
  EXPECT_GT(evidenceOfAll(fit, 0.05f), 2.0f);
  fit.bulge_error = 0.02f;
  EXPECT_EQ(evidenceOfAll(fit, 0.05f), -1.0f) << "the model decides";
  fit.bulge = 0.001f; // a turn by 2 degrees
  EXPECT_EQ(evidenceOfAll(fit, 0.05f), -4.0f) << "flat in any case";
}

TEST(FaceWindows, AFoldBetweenPlanesSaysNothing)
{
  FaceFit fit;
  fit.half_width = 0.1f;
  fit.bulge = 0.02f;
  fit.inliers = fit.center_cosine = 1.0f;
  fit.freedom = 30.0f;
  fit.bulge_error = 0.001f;
  fit.residual = fit.bulge / 6.0f;
  EXPECT_TRUE(std::isnan(evidenceOfAll(fit, 0.02f)));
  fit.residual = fit.bulge / 60.0f; // of a cylinder
  EXPECT_GT(evidenceOfAll(fit, 0.02f), 2.0f);
}

TEST(FaceWindows, FewNodesMustBendMore)
{
  FaceFit fit;
  fit.half_width = 0.1f;
  fit.bulge = 0.02f;
  fit.residual = 0.0005f;
  fit.inliers = fit.center_cosine = 1.0f;
  fit.bulge_error = 0.003f; // of nearly seven
  fit.freedom = 30.0f;
  EXPECT_GT(evidenceOfAll(fit, 0.05f), 1.0f);
  fit.freedom = 1.0f;
  EXPECT_LT(evidenceOfAll(fit, 0.05f), 0.0f);
}

TEST(Statistics, StudentsDistributionHasLongerTails)
{
  const double rare = cdf(complement(boost::math::normal(), 4.0));
  for (const double freedom : {4.0, 5.0, 6.0, 7.5, 12.0, 40.0, 1000.0}) {
    const double error = freedom < 6.0 ? 0.08 : 0.03;
    const double exact = quantile(complement(boost::math::students_t(freedom), rare));
    EXPECT_NEAR(segmentation::studentDeviations(4.0, freedom), exact, error * exact)
        << freedom;
  }
}

/** Nodes of one window on a paraboloid whose curvature along x is 1 / radius. */
FaceLevel
paraboloid(float radius)
{
  FaceLevel level;
  level.cell = 1.0f;
  for (int x = -3; x <= 3; ++x)
    for (int y = -3; y <= 3; ++y) {
      segmentation::FaceNode node;
      const auto u = static_cast<float>(x), v = static_cast<float>(y);
      node.position = {u, v, 0.5f * u * u / radius};
      node.normal = {-u / radius, 0.0f, 1.0f};
      node.normal.normalize();
      node.count = 40.0f;
      level.nodes.push_back(node);
    }
  std::swap(level.nodes.front(), level.nodes[24]); // the middle
  return level;
}

std::optional<FaceFit>
fitOf(const FaceLevel& level, std::size_t count)
{
  std::vector<std::uint32_t> window(count);
  std::iota(window.begin(), window.end(), 0);
  return segmentation::FaceFitter(level).fit(window);
}

TEST(FaceFit, TurnAndBulgeOfAParaboloid)
{
  const auto fit = fitOf(paraboloid(10.0f), 49);
  ASSERT_TRUE(fit);
  EXPECT_NEAR(fit->half_width, 4.0f, 1e-4f); // twice the deviation of -3 to 3
  EXPECT_NEAR(fit->bulge, 0.8f, 1e-4f);      // 4^2 / (2 * 10)
  EXPECT_NEAR(fit->turn(), 0.8f, 1e-4f);     // 8 / 10
  EXPECT_LT(fit->residual, 1e-5f);
  EXPECT_EQ(fit->inliers, 1.0f);
}

TEST(FaceFit, OutliersDoNotMoveIt)
{
  FaceLevel level = paraboloid(10.0f);
  for (const std::size_t i : {3, 17, 30, 44})
    level.nodes[i].position.z() += 5.0f;
  const auto fit = fitOf(level, 49);
  ASSERT_TRUE(fit);
  EXPECT_NEAR(fit->turn(), 0.8f, 0.05f);
  EXPECT_NEAR(fit->inliers, 45.0f / 49.0f, 1e-6f);
}

TEST(FaceFit, NodesOfFewPointsSayLess)
{
  FaceLevel level = paraboloid(10.0f);
  for (std::size_t i = 1; i < 49; i += 3) {
    level.nodes[i].position.z() += 0.5f;
    level.nodes[i].count = 2.0f;
  }
  const auto fit = fitOf(level, 49);
  ASSERT_TRUE(fit);
  EXPECT_NEAR(fit->turn(), 0.8f, 0.05f);
  EXPECT_LT(fit->residual, 0.1f);
  EXPECT_GT(fit->inliers, 0.9f);
}

TEST(FaceFit, FewNodesAreNotFittedExactly)
{
  // Twelve nodes, six more than coefficients: by chance hardly ever less than .1 noise.
  constexpr float noise = 0.1f;
  Random random(5);
  for (int draw = 0; draw < 200; ++draw) {
    FaceLevel level = paraboloid(10.0f);
    std::vector<std::uint32_t> window;
    for (std::uint32_t i = 0; window.size() < 12; i += 4)
      window.push_back(i);
    for (const std::uint32_t i : window)
      level.nodes[i].position.z() += noise * static_cast<float>(random.normal());
    const auto fit = segmentation::FaceFitter(level).fit(window);
    ASSERT_TRUE(fit);
    EXPECT_GT(fit->residual, 0.1f * noise) << draw;
    EXPECT_NEAR(fit->freedom, 6.0f, 1e-4f);
  }
}

TEST(FaceFit, NodesThatDoNotDetermineIt)
{
  EXPECT_FALSE(fitOf(paraboloid(10.0f), 7));
  FaceLevel line = paraboloid(10.0f);
  for (auto& node : line.nodes)
    node.position.y() = 0.0f;
  EXPECT_FALSE(fitOf(line, 49));
}

} // namespace
