/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * Point Cloud Library (PCL) - www.pointclouds.org
 * Copyright (c) 2026, pcl_shape contributors
 *
 * All rights reserved
 */

#pragma once

#include <pcl/tiling/point_source.h>
#include <pcl/tiling/team.h>

#include <cstdint>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace pcl::tiling {

/** \brief Which point of a tile, in the order of the sources. */
struct PointOfTile {
  std::uint32_t tile = 0; ///< its number
  std::uint32_t row = 0;  ///< from 0 to TiledCloud::pointsOf() - 1
};

/** \brief Points of a tile, and those around it. */
struct TilePoints {
  std::vector<Position> points; ///< those of the tile in the order of the sources, then
                                ///< those around it
  std::size_t own = 0;          ///< how many are of the tile
  std::vector<PointOfTile> around; ///< which points of other tiles those around it are
};

/** \brief How a cloud is divided. */
struct TileSettings {
  std::uint64_t max_points = 2000000; ///< of a tile, without those around it
  double max_edge = 0.0;              ///< of a tile, meters; 0 for any
  std::string parameters; ///< whatever else results depend on: it is compared when a
                          ///< run goes on
};

/** \brief Sources divided into tiles on disk, and results for each tile.
 *
 * A directory holds the tiles, the results, and a manifest of what is complete. After a
 * run was killed, the same calls continue where it ended. A point that is not finite
 * belongs to no tile. The bytes of tiles and results depend neither on the number of
 * processes nor on who did what.
 *
 * All methods throw a TilingError that says what is wrong. */
class TiledCloud {
public:
  /** \brief What the points are read from, one after the other. */
  using Sources = std::vector<std::shared_ptr<const PointSource>>;

  /** \brief Creates the directory if it does not exist. Only one run can use it at a
   * time.
   * \param[in] directory of tiles and results alone
   * \param[in] sources of all points
   * \param[in] settings how large tiles are, and what else decides
   * \param[in] team the processes that share the work */
  TiledCloud(const std::string& directory,
             const Sources& sources,
             const TileSettings& settings,
             Team& team);
  ~TiledCloud();
  TiledCloud(const TiledCloud&) = delete;
  TiledCloud& operator=(const TiledCloud&) = delete;

  /** \brief Divide the sources, unless that was done before. */
  void partition();

  /** \brief How many tiles there are. */
  std::size_t size() const;

  /** \brief How many points are not finite, or too large for float. */
  std::uint64_t countNotFinite() const;

  /** \brief How many points are in tiles. */
  std::uint64_t countFinite() const;

  /** \brief How many points a tile has. */
  std::uint64_t pointsOf(std::size_t tile) const;

  /** \brief What to subtract from coordinates before they become floats, as
   * pcl::coordinateOffset() has it for all points; 0 unless setOffset() was called. */
  const Position& offset() const;

  /** \brief Before partition(); tiles are cut by the floats that points become. */
  void setOffset(const Position& offset);

  /** \brief An estimate from the density: the distance between neighbors of most
   * points, meters. */
  double typicalDistance() const;

  /** \brief Whether a point is in a tile: whether it is finite in float, after the
   * offset is subtracted. */
  bool holds(const Position& point) const;

  /** \brief The tile of a point that holds() is true for. */
  std::size_t tileOf(const Position& point) const;

  /** \brief A tile with the points within a distance of it.
   * \param[in] tile from 0 to size() - 1
   * \param[in] halo meters, along each axis from the box of the tile's points; a little
   * more is loaded, by which floats are rounded */
  TilePoints load(std::size_t tile, double halo) const;

  /** \brief The other tiles that have points within a distance of a tile, ascending.
   * \param[in] tile from 0 to size() - 1 \param[in] halo meters, see load() */
  std::vector<std::size_t> tilesAround(std::size_t tile, double halo) const;

  /** \brief What is computed of a tile: any bytes. */
  using Function =
      std::function<std::vector<std::uint8_t>(std::size_t tile, const TilePoints&)>;

  /** \brief Compute what is missing of a result, the largest tiles first.
   * \param[in] name of letters, digits and underscores
   * \param[in] halo see load()
   * \param[in] function called for each tile that is missing
   * \throws TilingError with the first error, after the other tiles are done */
  void run(const std::string& name, double halo, const Function& function);

  /** \brief What is computed of a tile from other results: its points are not read. */
  using ResultFunction = std::function<std::vector<std::uint8_t>(std::size_t tile)>;

  /** \brief Compute what is missing of a result as run() does. */
  void runOnResults(const std::string& name, const ResultFunction& function);

  /** \brief Writes what is computed of a tile. */
  using Write =
      std::function<void(std::size_t tile, const std::vector<std::uint8_t>& bytes)>;

  /** \brief Compute a result of all tiles in one process, unless it is complete.
   * \param[in] name of letters, digits and underscores
   * \param[in] function writes once for each tile that has points
   * \throws TilingError with its error */
  void runAtOnce(const std::string& name,
                 const std::function<void(const Write& write)>& function);

  /** \brief A section of the sources, which one process reads. */
  struct Section {
    std::size_t source = 0; ///< of those that are given
    std::size_t number = 0; ///< see PointSource::readSection()
  };

  /** \brief The sections of all sources, in their order. */
  const std::vector<Section>& sections() const;

  /** \brief Points that a section and a tile share, in the order of both. */
  struct Rows {
    std::uint64_t tile = 0;  ///< which tile
    std::uint64_t first = 0; ///< of them, among the tile's own points
    std::uint64_t count = 0; ///< how many they are
  };

  /** \brief Which points of tiles a section has; the tiles ascend. \param[in] section
   * an index of sections() */
  std::vector<Rows> rowsOf(std::size_t section) const;

  /** \brief Takes bytes that follow those before them. */
  using Sink = std::function<void(const void* data, std::size_t size)>;

  /** \brief Gives what is computed of a section to a sink. */
  using SectionFunction = std::function<void(std::size_t section, const Sink& sink)>;

  /** \brief Compute what is missing of a result of sections, as run() does for tiles.
   * The name must differ from those of results of tiles. */
  void runOnSections(const std::string& name, const SectionFunction& function);

  /** \brief What run() and its likes have computed. \param[in] name of the result
   * \param[in] number of the tile or the section */
  std::vector<std::uint8_t> resultOf(const std::string& name, std::size_t number) const;

  /** \brief The same, some bytes at a time. \throws TilingError at the end if they are
   * damaged */
  void copyTo(const std::string& name, std::size_t number, const Sink& sink) const;

  /** \brief Where it is. */
  std::string pathOf(const std::string& name, std::size_t number) const;

  /** \brief Check a result of all tiles, before parts of it are read by pathOf().
   * \throws TilingError if it is damaged */
  void check(const std::string& name);

  /** \brief Remove a result, in the first process; the next run computes it again if it
   * is asked for. */
  void removeResult(const std::string& name);

  /** \brief A value that the first process finds and all of them use; kept in the
   * manifest, so that it is found once. \param[in] name of the value
   * \param[in] find not called if it is known */
  std::string decide(const std::string& name, const std::function<std::string()>& find);

  /** \brief Remove tiles and results. */
  void remove();

private:
  struct State;
  std::unique_ptr<State> state_;
};

} // namespace pcl::tiling
