// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Files of sections: points sorted by tile, in their order, and what is damaged.

#include "memory_source.h"
#include "tiling/section_file.h"

#include <gtest/gtest.h>

#include <fstream>
#include <vector>

namespace {

using namespace pcl::tiling;
using namespace pcl_shape_test;

class SectionFiles : public ::testing::Test {
protected:
  SectionFiles()
  {
    WholeFile file(path);
    SectionWriter writer(file, tiles, at_a_time);
    for (std::size_t i = 0; i < points.size(); ++i)
      writer.add(points[i], tileOf(i));
    writer.finish();
    file.commit();
  }

  /** \brief Tile 3 has no point, tile 5 those of the last group alone. */
  std::size_t
  tileOf(std::size_t i) const
  {
    constexpr std::size_t last_group = 90;
    return i >= last_group ? 5 : i % 3;
  }

  /** \brief Those of every other group are as they are in single precision. */
  static std::vector<Position>
  pointsOfGroups()
  {
    std::vector<Position> points = unevenPoints(95, 1);
    for (std::size_t i = 0; i < points.size(); ++i)
      if (i / at_a_time % 2 == 0)
        for (double& c : points[i])
          c = static_cast<double>(static_cast<float>(c));
    return points;
  }

  static constexpr std::size_t tiles = 6, at_a_time = 10;
  TemporaryDirectory temporary;
  const std::string path = temporary.path() + "/section";
  const std::vector<Position> points = pointsOfGroups();
};

TEST_F(SectionFiles, GiveThePointsOfTilesInTheirOrder)
{
  const SectionFile file(path, tiles);
  const std::vector<std::uint64_t> counts = file.counts();
  for (std::size_t tile = 0; tile < tiles; ++tile) {
    std::vector<Position> expected{{1.0, 2.0, 3.0}}, found = expected;
    for (std::size_t i = 0; i < points.size(); ++i)
      if (tileOf(i) == tile)
        expected.push_back(points[i]);
    file.addPointsOf(tile, found);
    EXPECT_EQ(found, expected) << tile;
    EXPECT_EQ(counts[tile] + 1, expected.size()) << tile;
  }
}

TEST_F(SectionFiles, WithoutPointsAreEmpty)
{
  const std::string empty = temporary.path() + "/empty";
  {
    WholeFile file(empty);
    SectionWriter(file, tiles).finish();
    file.commit();
  }
  EXPECT_EQ(SectionFile(empty, tiles).counts(), std::vector<std::uint64_t>(tiles));
}

TEST_F(SectionFiles, ThatAreDamagedAreErrorsAndAreRemoved)
{
  const auto size = static_cast<std::streamoff>(sizeOfFile(path));
  std::fstream(path, std::ios::in | std::ios::out | std::ios::binary)
      .seekp(size - 1)
      .put('\x55');
  const SectionFile file(path, tiles);
  std::vector<Position> found;
  file.addPointsOf(1, found); // another tile's points are as they were
  EXPECT_THROW(file.addPointsOf(5, found), TilingError);
  EXPECT_EQ(sizeOfFile(path), -1);
}

TEST_F(SectionFiles, ThatAreTruncatedOrMissingAreErrors)
{
  std::filesystem::resize_file(path, 1000);
  EXPECT_THROW(SectionFile(path, tiles), TilingError);
  EXPECT_THROW(SectionFile(path + "_of_nobody", tiles), TilingError);
}

TEST_F(SectionFiles, AppearCompleteOrNotAtAll)
{
  const std::string other = temporary.path() + "/other";
  {
    WholeFile file(other);
    file.write("abc", 3);
  }
  EXPECT_EQ(sizeOfFile(other), -1);
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(temporary.path()),
                          std::filesystem::directory_iterator()),
            1);
  WholeFile file(other);
  file.write("ab", 2);
  file.write("c", 1);
  file.commit();
  EXPECT_EQ(file.size(), 3U);
  EXPECT_EQ(file.checksum(), checksumOf("abc", 3));
  EXPECT_EQ(readWhole(other), (Bytes{'a', 'b', 'c'}));
}

} // namespace
