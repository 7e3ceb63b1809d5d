// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Points of a tile on disk, and the manifest.

#include "memory_source.h"
#include "tiling/manifest.h"
#include "tiling/tile_file.h"

#include <gtest/gtest.h>

#include <fstream>

namespace {

using namespace pcl::tiling;
using namespace pcl_shape_test;

class TileFiles : public ::testing::Test {
protected:
  TileFiles() : path(directory.path() + "/file") {}

  void
  write(const Bytes& bytes) const
  {
    WholeFile file(path);
    file.write(bytes.data(), bytes.size());
    file.commit();
  }

  void
  change(std::streamoff at, char byte) const
  {
    std::fstream file(path, std::ios::in | std::ios::out | std::ios::binary);
    file.seekp(at);
    file.put(byte);
  }

  TemporaryDirectory directory;
  const std::string path;
};

/** \brief Points that are as they are in single precision. */
std::vector<Position>
roundedPoints(std::size_t count, unsigned seed)
{
  std::vector<Position> points = unevenPoints(count, seed);
  for (Position& p : points)
    for (double& c : p)
      c = static_cast<double>(static_cast<float>(c));
  return points;
}

TEST_F(TileFiles, GiveThePointsAsTheyWere)
{
  const auto points = unevenPoints(5000, 1);
  write(encodeTile(points));
  EXPECT_EQ(TileFile(path).points(), points);
}

TEST_F(TileFiles, TakeHalfOfTheBytesIfAllCoordinatesAreFloats)
{
  auto points = roundedPoints(5000, 1);
  const std::size_t all = encodeTile(unevenPoints(5000, 1)).size();
  write(encodeTile(points));
  EXPECT_LT(sizeOfFile(path), static_cast<std::int64_t>(6 * all / 10));
  EXPECT_EQ(TileFile(path).points(), points);
  points[4321][1] = 0.1;
  write(encodeTile(points));
  EXPECT_EQ(TileFile(path).points(), points);
}

TEST_F(TileFiles, GiveThePointsInABoxAndWhichTheyAre)
{
  for (const auto& points : {unevenPoints(5000, 2), roundedPoints(5000, 2)}) {
    write(encodeTile(points));
    const Box box{{1.0, 0.5, -1.0}, {9.0, 6.0, 3.0}};
    std::vector<Position> expected, found;
    std::copy_if(points.begin(),
                 points.end(),
                 std::back_inserter(expected),
                 [&](auto& p) { return box.holds(p); });
    std::vector<std::uint32_t> places;
    TileFile(path).addPointsIn(box, found, places);
    ASSERT_EQ(found.size(), places.size());
    for (std::size_t i = 0; i < found.size(); ++i)
      EXPECT_EQ(found[i], points.at(places[i]));
    std::sort(expected.begin(), expected.end());
    std::sort(found.begin(), found.end());
    EXPECT_GT(found.size(), 100U);
    EXPECT_EQ(found, expected);
  }
}

TEST_F(TileFiles, ThatAreDamagedAreErrors)
{
  const auto points = unevenPoints(5000, 3);
  const Bytes bytes = encodeTile(points);
  for (const std::size_t at : {std::size_t{3}, std::size_t{200}, bytes.size() - 9}) {
    write(bytes);
    change(static_cast<std::streamoff>(at), '!');
    EXPECT_THROW(TileFile(path).points(), TilingError) << "byte " << at;
  }
  write(Bytes(bytes.begin(), bytes.end() - 1));
  EXPECT_THROW(TileFile{path}, TilingError);
  write({});
  EXPECT_THROW(TileFile{path}, TilingError);
}

TEST_F(TileFiles, ManifestForgetsAnUnfinishedLine)
{
  Manifest manifest(path, true);
  manifest.add({{"event", "one"}});
  manifest.add({{"event", "two"}, {"number", 0.1}});
  {
    std::ofstream file(path, std::ios::app);
    file << "{\"check\":\"01234567\",\"rec";
  }
  EXPECT_EQ(Manifest(path, false).records(), manifest.records());
  Manifest repaired(path, true);
  repaired.add({{"event", "three"}});
  ASSERT_EQ(Manifest(path, false).records().size(), 3U);
  EXPECT_EQ(Manifest(path, false).records()[1]["number"], 0.1);
}

TEST_F(TileFiles, ManifestThatWasChangedIsAnError)
{
  Manifest manifest(path, true);
  manifest.add({{"event", "one"}});
  manifest.add({{"event", "two"}});
  change(40, 'x');
  try {
    Manifest(path, true);
    FAIL() << "a changed manifest was read";
  }
  catch (const TilingError& error) {
    EXPECT_NE(std::string(error.what()).find("line 1"), std::string::npos)
        << error.what();
  }
}

} // namespace
