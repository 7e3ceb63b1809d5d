// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// How sources are divided into tiles, from the counts of their sections.

#pragma once

#include "tiling/checked_file.h"
#include "tiling/tile_tree.h"

#include <pcl/tiling/point_source.h>

#include <nlohmann/json.hpp>

#include <array>
#include <cstdint>
#include <vector>

namespace pcl::tiling {

/** \brief What a point becomes with the offset subtracted. */
std::array<float, 3> floatsOf(const Position& point, const Position& offset);

/** \brief What is finite in double may be too large for float. */
bool isFinite(const std::array<float, 3>& point);

/** \brief How many points are where. Those of sections can be added in any order. */
struct Survey {
  DensityCells cells;
  std::uint64_t finite = 0, not_finite = 0;

  /** \brief Of one section, in fewer cells. \param[in] exponent see DensityCells */
  static Survey ofSection(int exponent = DensityCells::min_exponent);

  void add(const Position* points, std::size_t count, const Position& offset);

  /** \brief Those of a survey whose bytes these are. */
  void add(const Bytes& bytes);

  Bytes toBytes() const;
};

/** \brief How the sources are divided. */
struct Plan {
  Position offset{};
  TileTree tree;
  std::vector<std::uint64_t> points; ///< of each tile
  std::uint64_t finite = 0, not_finite = 0;
  double typical_distance = 0.0;
};

/** \throws TilingError if no point is finite */
Plan planOf(const Survey& survey,
            const Position& offset,
            std::uint64_t max_points,
            double max_edge);

nlohmann::ordered_json toJson(const Plan& plan);

Plan planOf(const nlohmann::ordered_json& record);

} // namespace pcl::tiling
