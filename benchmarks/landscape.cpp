// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Writes a generated landscape with houses, of any size, as strips in PCD files.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

using Point = std::array<double, 3>;

constexpr double spacing = 0.25;          // 16 points a square meter
constexpr double lot = 24.0;              // meters from house to house
constexpr double eaves = 5.0, rise = 3.0; // of a house, above the ground
constexpr double noise = 0.02;            // of heights, standard deviation

/** Random bits of a place: steps of SplitMix64. */
std::uint64_t
hashOf(std::uint64_t a, std::uint64_t b, std::uint64_t c)
{
  std::uint64_t hash = 0;
  for (const std::uint64_t word : {a, b, c}) {
    hash += word + 0x9e3779b97f4a7c15U;
    hash = (hash ^ hash >> 30) * 0xbf58476d1ce4e5b9U;
    hash = (hash ^ hash >> 27) * 0x94d049bb133111ebU;
    hash ^= hash >> 31;
  }
  return hash;
}

/** 0 to 1, some bits of a hash. */
double
shareOf(std::uint64_t hash, int part)
{
  constexpr double values = 65536.0;
  return static_cast<double>(hash >> (16 * part) & 0xffffU) / values;
}

double
ground(double x, double y)
{
  return 9.0 * std::sin(0.011 * x) * std::cos(0.007 * y) +
         2.0 * std::sin(0.05 * x + 0.03 * y);
}

/** A place on the ground, a roof or a wall: a wall takes the points of a strip of the
 * ground beside it. */
Point
onSurface(double x, double y, double share)
{
  const double lot_x = std::floor(x / lot), lot_y = std::floor(y / lot);
  const std::uint64_t hash =
      hashOf(static_cast<std::uint64_t>(lot_x), static_cast<std::uint64_t>(lot_y), 7);
  if (shareOf(hash, 0) > 0.6) // a garden
    return {x, y, ground(x, y)};
  const double half_x = 4.0 + 3.0 * shareOf(hash, 1);
  const double half_y = 3.0 + 3.0 * shareOf(hash, 2);
  const Point middle{(lot_x + 0.5) * lot, (lot_y + 0.5) * lot, 0.0};
  const double off_x = x - middle[0], off_y = y - middle[1];
  const double base = ground(middle[0], middle[1]);
  constexpr double beside = 1.5; // meters of ground whose points are on a wall
  const double out_x = std::abs(off_x) - half_x, out_y = std::abs(off_y) - half_y;
  if (std::max(out_x, out_y) > beside)
    return {x, y, ground(x, y)};
  if (std::max(out_x, out_y) <= 0.0)
    return {x, y, base + eaves + rise * (1.0 - std::abs(off_y) / half_y)};
  const double z = base + eaves * share;
  const auto inside = [](double off, double half) {
    return std::clamp(off, -half, half);
  };
  return out_x > out_y ? Point{middle[0] + std::copysign(half_x, off_x),
                               middle[1] + inside(off_y, half_y),
                               z}
                       : Point{middle[0] + inside(off_x, half_x),
                               middle[1] + std::copysign(half_y, off_y),
                               z};
}

Point
pointAt(std::uint64_t column, std::uint64_t row)
{
  const std::uint64_t hash = hashOf(column, row, 1), more = hashOf(column, row, 2);
  Point point = onSurface((static_cast<double>(column) + shareOf(hash, 0)) * spacing,
                          (static_cast<double>(row) + shareOf(hash, 1)) * spacing,
                          shareOf(hash, 2));
  // Three uniform values have the standard deviation of one half.
  point[2] +=
      2.0 * noise * (shareOf(more, 0) + shareOf(more, 1) + shareOf(more, 2) - 1.5);
  return point;
}

/** Of columns from first to end. */
void
writeStrip(const std::string& path,
           std::uint64_t first,
           std::uint64_t end,
           std::uint64_t rows)
{
  std::ofstream file(path, std::ios::binary);
  const std::string points = std::to_string((end - first) * rows);
  file << "# .PCD v0.7 - Point Cloud Data file format\nVERSION 0.7\nFIELDS x y z\nSIZE "
          "4 4 4\nTYPE F F F\nCOUNT 1 1 1\nWIDTH "
       << points << "\nHEIGHT 1\nVIEWPOINT 0 0 0 1 0 0 0\nPOINTS " << points
       << "\nDATA binary\n";
  std::vector<std::array<float, 3>> line;
  for (std::uint64_t row = 0; row < rows; ++row) {
    line.clear();
    for (std::uint64_t column = first; column < end; ++column) {
      const Point p = pointAt(column, row);
      line.push_back({static_cast<float>(p[0]),
                      static_cast<float>(p[1]),
                      static_cast<float>(p[2])});
    }
    file.write(reinterpret_cast<const char*>(line.data()),
               static_cast<std::streamsize>(line.size() * sizeof line[0]));
  }
  file.close();
  if (!file)
    throw std::runtime_error(path + ": cannot be written; expected room on the disk");
}

void
writeLandscape(const std::string& directory, std::uint64_t points, std::uint64_t files)
{
  const auto edge =
      static_cast<std::uint64_t>(std::lround(std::sqrt(static_cast<double>(points))));
  std::filesystem::create_directories(directory);
  for (std::uint64_t f = 0; f < files; ++f) {
    char name[32];
    std::snprintf(name, sizeof name, "/strip_%03u.pcd", static_cast<unsigned>(f));
    const std::uint64_t first = f * edge / files, end = (f + 1) * edge / files;
    writeStrip(directory + name, first, end, edge);
  }
}

} // namespace

int
main(int argc, char** argv)
try {
  if (argc != 4) {
    std::cerr << "usage: landscape DIRECTORY POINTS FILES\n"
                 "Writes strips of a landscape, about POINTS points in all.\n";
    return 2;
  }
  const std::uint64_t points = std::stoull(argv[2]), files = std::stoull(argv[3]);
  if (points == 0 || files == 0)
    throw std::invalid_argument("0 points or files; expected at least one");
  writeLandscape(argv[1], points, files);
  return 0;
}
catch (const std::exception& error) {
  std::cerr << "landscape: " << error.what() << '\n';
  return 1;
}
