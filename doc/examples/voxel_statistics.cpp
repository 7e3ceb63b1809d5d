/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * Point Cloud Library (PCL) - www.pointclouds.org
 * Copyright (c) 2026, pcl_shape contributors
 *
 * All rights reserved
 */

#include <pcl/tiling/tiled_cloud.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <map>
#include <random>

// A function of your own over tiles with halos: the count and the mean height of the
// points in each voxel, of a cloud that is never in memory as a whole.
using pcl::tiling::Position;

/** \brief A hilly landscape, made anew whenever it is read. A file would be read here.
 */
class Landscape : public pcl::tiling::PointSource {
public:
  std::string
  name() const override
  {
    return "landscape";
  }

  std::string
  state() const override
  {
    return "never changes";
  }

  void
  readSection(std::size_t, const Use& use) const override
  {
    std::mt19937 engine(1);
    const auto random = [&](double size) {
      return size * static_cast<double>(engine()) / 4294967296.0;
    };
    std::vector<Position> points(4096);
    for (int block = 0; block < 100; ++block) {
      for (Position& p : points) {
        p = {random(400.0), random(300.0), 0.0};
        p[2] = 8.0 * std::sin(0.03 * p[0]) * std::cos(0.02 * p[1]);
      }
      use(points.data(), points.size());
    }
  }
};

using Voxel = std::array<long, 3>;

struct Statistics {
  std::uint64_t count = 0;
  double sum = 0.0;
  Position least{}; ///< of its points, the first by coordinates
};

constexpr double voxel_size = 5.0;

std::map<Voxel, Statistics>
statisticsOf(const std::vector<Position>& points)
{
  std::map<Voxel, Statistics> voxels;
  for (const Position& p : points) {
    Voxel voxel;
    for (std::size_t axis = 0; axis < 3; ++axis)
      voxel[axis] = std::lround(std::floor(p[axis] / voxel_size));
    Statistics& s = voxels[voxel];
    s.least = s.count == 0 ? p : std::min(s.least, p);
    ++s.count;
    s.sum += p[2];
  }
  return voxels;
}

int
main()
{
  const auto directory = std::filesystem::temp_directory_path() /
                         ("voxel_statistics_" + std::to_string(std::random_device()()));
  const auto team = pcl::tiling::makeTeam(2);
  pcl::tiling::TileSettings settings;
  settings.max_points = 50000;
  pcl::tiling::TiledCloud cloud(
      directory.string(), {std::make_shared<Landscape>()}, settings, *team);
  cloud.partition();

  // A voxel at a border has points in several tiles. One of them computes it: that of
  // its first point. It sees all points of the voxel, since the halo is as wide as a
  // voxel.
  cloud.run("voxels",
            voxel_size,
            [&](std::size_t tile, const pcl::tiling::TilePoints& points) {
              std::vector<std::uint8_t> result;
              for (const auto& [voxel, s] : statisticsOf(points.points))
                if (cloud.tileOf(s.least) == tile) {
                  const double mean = s.sum / static_cast<double>(s.count);
                  const auto put = [&](const auto& value) {
                    const auto* const bytes =
                        reinterpret_cast<const std::uint8_t*>(&value);
                    result.insert(result.end(), bytes, bytes + sizeof value);
                  };
                  put(s.count);
                  put(mean);
                }
              return result;
            });

  std::uint64_t voxels = 0, points = 0;
  double highest = -1e9;
  for (std::size_t tile = 0; tile < cloud.size(); ++tile) {
    const std::vector<std::uint8_t> result = cloud.resultOf("voxels", tile);
    for (std::size_t at = 0; at < result.size(); at += 16) {
      std::uint64_t count = 0;
      double mean = 0.0;
      std::memcpy(&count, &result[at], 8);
      std::memcpy(&mean, &result[at + 8], 8);
      ++voxels;
      points += count;
      highest = std::max(highest, mean);
    }
  }
  std::printf("%zu tiles, %lu voxels, %lu points, the highest voxel at %.2f m\n",
              cloud.size(),
              voxels,
              points,
              highest);
  cloud.remove();
  return points == cloud.countFinite() ? 0 : 1;
}
