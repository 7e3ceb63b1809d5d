// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Where points are dense, and how space is cut into tiles of few points.

#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace pcl::tiling {

/** \brief Which cell of space a point is in, along each axis: whole numbers, which a
 * double holds for any float. */
using CellKey = std::array<double, 3>;

/** \brief The cells of one size, a power of two. */
struct CellGrid {
  int exponent = 0; ///< of the size in meters

  CellKey keyOf(const float* point) const;
  /** \brief The cell that holds one of another grid, whose cells are not larger. */
  CellKey keyOf(const CellGrid& finer, const CellKey& key) const;
  double size() const;
};

/** \brief A cell with points. */
struct Cell {
  CellKey key{};
  std::uint64_t count = 0;
};

/** \brief How many points are in each cell: a hash table that holds cells in place. */
class CellCounts {
public:
  /** \param[in] slots a power of two; the table grows when it has to */
  explicit CellCounts(std::size_t slots = 64) : slots_(slots) {}

  void add(const CellKey& key, std::uint64_t count);

  /** \brief Asks for the memory where a cell will be counted. */
  void prepare(const CellKey& key) const;

  std::size_t
  size() const
  {
    return size_;
  }

  /** \brief The cells, in some order. */
  std::vector<Cell> cells() const;

  /** \brief The cells, in the order of their keys. */
  std::vector<Cell> sorted() const;

  /** \brief The counts of larger cells. \param[in] doublings of their size */
  CellCounts coarser(int doublings) const;

private:
  void grow();

  std::vector<Cell> slots_; ///< empty ones have count 0; at least half of them are
  std::size_t size_ = 0;
};

/** \brief How many points are in each cell, with cells that grow until they are few:
 * the memory is bounded, and the order of points does not matter. */
class DensityCells {
public:
  static constexpr std::size_t default_max_cells = 1 << 18; ///< some 30 MB, if used

  static constexpr int min_exponent = -20; ///< cells of a micrometer

  /** \param[in] exponent of the size of the smallest cells */
  explicit DensityCells(std::size_t max_cells = default_max_cells,
                        int exponent = min_exponent);

  /** \param[in] points finite, coordinate after coordinate */
  void add(const float* points, std::size_t count);

  /** \brief Whether cells of half the size would be too many, or a micrometer. */
  bool areSmallest() const;

  /** \brief The points of other cells, whatever their size. */
  void add(const CellGrid& grid, const std::vector<Cell>& cells);

  const CellGrid&
  grid() const
  {
    return grid_;
  }

  const CellCounts&
  counts() const
  {
    return counts_;
  }

  /** \brief About the distance between neighbors of most points, meters; 0 if all
   * points are in one cell. */
  double typicalDistance() const;

private:
  template <typename KeyAt, typename CountAt>
  void addEach(std::size_t count, const KeyAt& keyAt, const CountAt& countAt);
  void bound();

  std::size_t max_cells_;
  int first_exponent_;
  int doublings_ = 8; ///< at a time: from a micrometer to meters there are twenty
  CellGrid grid_;
  CellCounts counts_;
};

/** \brief Space cut in two, and again, at borders of cells. */
class TileTree {
public:
  struct Node {
    int axis = -1;         ///< of the cut; -1 for a tile
    double cut = 0.0;      ///< cells below it are in the first part
    std::size_t first = 0; ///< node of the first part, or the tile
    std::size_t second = 0;
  };

  TileTree() = default;

  TileTree(const CellGrid& grid, std::vector<Node> nodes) : grid_(grid), nodes_(nodes)
  {}

  /** \brief Cut where it leaves half of the points on either side, across the longest
   * edge. \param[in] max_edge meters, 0 for any */
  TileTree(const DensityCells& cells, std::uint64_t max_points, double max_edge);

  std::size_t tileOf(const CellKey& key) const;

  /** \brief That of its cell. */
  std::size_t tileOf(const float* point) const;

  const CellGrid&
  grid() const
  {
    return grid_;
  }

  const std::vector<Node>&
  nodes() const
  {
    return nodes_;
  }

  std::size_t size() const;

private:
  CellGrid grid_;
  std::vector<Node> nodes_; ///< the first is of all space
};

} // namespace pcl::tiling
