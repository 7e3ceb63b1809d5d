// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// A tile with a halo equals the whole cloud, to the bit.

#include "support/kernel_targets.h"
#include "support/shapes.h"
#include "support/sweep.h"

#include <gtest/gtest.h>

#include <array>
#include <cstring>
#include <map>

namespace {

using namespace pcl;
using namespace pcl::test;

constexpr double normal_radius = 0.006;
constexpr double radius = 0.004;
constexpr double halo = normal_radius + radius;

struct Results {
  std::vector<float> normals; ///< and curvatures
  std::vector<float> inad;

  std::array<float, 6>
  at(std::size_t i) const
  {
    const float* n = &normals[4 * i];
    return {n[0], n[1], n[2], n[3], inad[2 * i], inad[2 * i + 1]};
  }
};

/** \brief On one thread: numbers of threads have a test of their own. */
Results
resultsOf(const Surface& cloud)
{
  NeighborhoodSweep sweep(cloud.points());
  sweep.setNumberOfThreads(1);
  Results results;
  results.normals = sweptNormals(sweep, NeighborhoodSize::ofRadius(normal_radius));
  results.inad = sweptINAD(sweep,
                           NeighborhoodSize::ofRadius(radius),
                           {results.normals.data(), 4, cloud.size()});
  return results;
}

/** \brief Boxes of random sizes, turned at random: they align with nothing. */
class Tiling {
public:
  using Tile = std::array<int, 3>;

  Tiling(const Surface& cloud, Random& random)
  {
    const Eigen::Vector3d axis(random.normal(), random.normal(), random.normal());
    const Eigen::Matrix3d turn =
        Eigen::AngleAxisd(random.uniform(0, 2 * pi), axis.normalized())
            .toRotationMatrix();
    for (int i = 0; i < 3; ++i)
      size_[i] = random.uniform(0.08, 0.2);
    const Eigen::Vector3d origin(random.uniform(), random.uniform(), random.uniform());
    for (std::size_t i = 0; i < cloud.size(); ++i)
      turned_.emplace_back(turn * cloud.position(i) - origin);
  }

  std::map<Tile, std::vector<std::size_t>>
  tiles() const
  {
    std::map<Tile, std::vector<std::size_t>> tiles;
    for (std::size_t i = 0; i < turned_.size(); ++i) {
      const Eigen::Array3i cell = (turned_[i].array() / size_).floor().cast<int>();
      tiles[{cell[0], cell[1], cell[2]}].push_back(i);
    }
    return tiles;
  }

  bool
  isWithinHalo(const Tile& tile, std::size_t point) const
  {
    const Eigen::Array3d corner = Eigen::Array3d(tile[0], tile[1], tile[2]) * size_;
    const Eigen::Array3d from = turned_[point].array() - corner;
    return (from >= -halo).all() && (from <= size_ + halo).all();
  }

private:
  Eigen::Array3d size_;
  std::vector<Eigen::Vector3d> turned_;
};

class SweepTiles : public testing::TestWithParam<std::string> {
protected:
  SweepTiles()
  {
    Random random(11);
    scene_ = mixedScene(102000, random);
    scene_.addNoise(0.0005, random);
    for (std::size_t i = 0; i < scene_.size(); ++i) {
      if (random.uniform() < 0.01)
        whole_.add({{1, 2, unknown}, {0, 0, 1}});
      place_.push_back(whole_.size());
      whole_.add({scene_.position(i), scene_.normal(i)});
    }
    whole_.add({{-2e4, 1e4, 3e4}, {0, 0, 1}});
  }

  /** \brief The points of one tile and its halo, on their own, beside the whole. */
  void
  expectTileOfWhole(const Tiling& tiling,
                    const Tiling::Tile& tile,
                    const std::vector<std::size_t>& members,
                    const Results& whole) const
  {
    Surface part;
    std::vector<std::size_t> place(scene_.size());
    for (std::size_t i = 0; i < scene_.size(); ++i) {
      if (tiling.isWithinHalo(tile, i)) {
        place[i] = part.size();
        part.add({scene_.position(i), scene_.normal(i)});
      }
    }
    const Results results = resultsOf(part);
    for (const std::size_t i : members) {
      const auto expected = whole.at(place_[i]), result = results.at(place[i]);
      ASSERT_EQ(0, std::memcmp(&expected, &result, sizeof(expected)))
          << "point " << i << " of a tile of " << members.size();
    }
  }

  static constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

  ForcedTarget target_{GetParam()};
  Surface scene_;
  Surface whole_;                  ///< with an outlier and points that are not finite
  std::vector<std::size_t> place_; ///< of the scene's points in the whole
};

TEST_P(SweepTiles, EqualTheWholeCloud)
{
  ASSERT_GE(scene_.size(), 100000U);
  ASSERT_GT(whole_.size(), scene_.size() + 500);
  const Results whole = resultsOf(whole_);
  std::size_t known = 0;
  for (const std::size_t i : place_)
    known += std::isnan(whole.inad[2 * i]) ? 0 : 1;
  ASSERT_GT(known, scene_.size() * 99 / 100);

  Random random(12);
  for (int t = 0; t < 20; ++t) {
    SCOPED_TRACE(t);
    const Tiling tiling(scene_, random);
    const auto tiles = tiling.tiles();
    ASSERT_GT(tiles.size(), 3U);
    for (const auto& [tile, members] : tiles) {
      expectTileOfWhole(tiling, tile, members, whole);
      if (HasFatalFailure())
        return;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Targets,
                         SweepTiles,
                         testing::ValuesIn(kernelTargets()),
                         TargetName());

} // namespace
