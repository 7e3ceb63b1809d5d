// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// The points of a tile on disk, in blocks, so that those near a border are read alone.

#pragma once

#include "tiling/checked_file.h"

#include <pcl/tiling/point_source.h>

#include <cstdint>
#include <string>
#include <vector>

namespace pcl::tiling {

/** \brief A box in space. */
struct Box {
  Position low{}, high{};

  static Box of(const std::vector<Position>& points);

  bool
  holds(const Position& p) const
  {
    return p[0] >= low[0] && p[0] <= high[0] && p[1] >= low[1] && p[1] <= high[1] &&
           p[2] >= low[2] && p[2] <= high[2];
  }

  bool
  meets(const Box& other) const
  {
    for (std::size_t axis = 0; axis < 3; ++axis)
      if (other.low[axis] > high[axis] || other.high[axis] < low[axis])
        return false;
    return true;
  }

  Box grown(double by) const;

  void add(const Box& other);
};

/** \brief The bytes of a file with the points of a tile, at least one; in single
 * precision if that loses nothing. */
Bytes encodeTile(const std::vector<Position>& points);

/** \brief A file of points, of which some are read. */
class TileFile {
public:
  /** \brief Reads what is in its blocks. \throws TilingError if the file is damaged */
  explicit TileFile(const std::string& path);

  const Box&
  box() const
  {
    return box_;
  }

  /** \brief All points, as they were given. \throws TilingError if they are damaged */
  std::vector<Position> points() const;

  /** \brief Append the points in a box, in an order of their own, and the place of
   * each among those of the tile. */
  void addPointsIn(const Box& box,
                   std::vector<Position>& points,
                   std::vector<std::uint32_t>& places) const;

private:
  struct Block {
    Box box;
    std::uint64_t begin = 0, size = 0; ///< in points
    std::uint32_t check = 0;
    std::uint32_t padding = 0; ///< written as zero
  };

  template <typename Coordinate>
  static Bytes encoded(const std::vector<Position>& points);

  /** use(position, place) for each point of some blocks that follow each other. */
  template <typename Coordinate, typename Use>
  void forEachOf(std::size_t first, std::size_t end, const Use& use) const;

  /** The same for blocks that are wanted. */
  template <typename Is, typename Use>
  void forEachOfThose(const Is& isWanted, const Use& use) const;

  friend Bytes encodeTile(const std::vector<Position>& points);

  std::string path_;
  Box box_;
  std::uint64_t size_ = 0, data_begin_ = 0;
  bool are_floats_ = false;
  std::vector<Block> blocks_;
};

} // namespace pcl::tiling
