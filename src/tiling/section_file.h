// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// The points of a section of the sources on disk, sorted by tile.

#pragma once

#include "tiling/checked_file.h"

#include <pcl/tiling/point_source.h>

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace pcl::tiling {

// Of a section, in memory: 52 bytes each.
constexpr std::size_t points_sorted_at_a_time = std::size_t{1} << 20;

/** \brief Writes points sorted by tile, in batches: a section may be larger than
 * memory. */
class SectionWriter {
public:
  /** \param[in] at_a_time how many points are sorted together */
  SectionWriter(WholeFile& file,
                std::size_t tiles,
                std::size_t at_a_time = points_sorted_at_a_time);

  void add(const Position& point, std::size_t tile);

  /** \brief Call it after the last point. */
  void finish();

private:
  template <typename Coordinate>
  void write();

  WholeFile& file_;
  std::size_t tiles_, at_a_time_;
  bool are_floats_ = true; ///< those that are not written yet
  std::vector<Position> points_;
  std::vector<std::uint32_t> tile_of_; ///< each point
};

/** \brief What a SectionWriter has written. \throws TilingError if it is damaged */
class SectionFile {
public:
  SectionFile(const std::string& path, std::size_t tiles);

  /** \brief How many points each tile has of it. */
  std::vector<std::uint64_t> counts() const;

  /** \brief Append the points of a tile, in their order. */
  void addPointsOf(std::size_t tile, std::vector<Position>& points) const;

private:
  /** The points that were sorted together, by where their table begins. */
  struct Group {
    std::uint64_t begin = 0, points = 0;
    bool are_floats = false;
  };

  std::uint64_t pointsBegin(const Group& group) const;

  template <typename Coordinate>
  void addPoints(const Group& group,
                 std::uint64_t first,
                 std::size_t count,
                 std::uint32_t check,
                 std::vector<Position>& points) const;

  std::string path_;
  std::size_t tiles_;
  std::vector<Group> groups_;
};

} // namespace pcl::tiling
