// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// The fields that are computed of each tile.

#pragma once

#include "tiles/tile_numbers.h"

#include <pcl/tiling/tiled_cloud.h>

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace pcl::app {

/** \brief What is wanted of each point. */
struct TileWanted {
  bool normals = false, edges = false, types = false, surfaces = false;
  double inad_radius = 0.0; ///< meters, 0 for no INAD
  double resolution = 0.0;  ///< meters, 0 for the cloud's own
  std::string instances;    ///< of what class; empty for none

  /** \brief Whether it needs the numbers of the whole cloud. */
  bool needsNumbers() const;
  bool needsEdges() const;
  /** \brief Whether it needs to know which surface points are of. */
  bool needsSurfaces() const;
};

/** \brief A field of a result, four bytes a point. */
struct TileField {
  std::string name;
  bool is_float = true;
  std::uint32_t unknown = 0; ///< the bits of points that are not finite
};

/** \brief The fields in the order in which results have them for each point. Normals,
 * if they are wanted, come first: normal_x, normal_y, normal_z and curvature. */
std::vector<TileField> fieldsOf(const TileWanted& wanted);

/** \brief The name of the results, and how many of their bytes are before the fields of
 * the first point. */
inline const std::string results_name = "fields";
constexpr std::size_t result_header = sizeof(std::uint64_t);

/** \brief Compute the fields of all tiles, as far as that was not done before.
 * \param[in] measured the same cloud, if what is wanted needs its numbers
 * \param[in] view_point where the points were seen from, for instances
 * \throws InputError for a cloud that would be sampled evenly as a whole */
void computeFields(pcl::tiling::TiledCloud& cloud,
                   const TileWanted& wanted,
                   const std::optional<MeasuredCloud>& measured,
                   const std::array<float, 3>& view_point,
                   unsigned threads);

} // namespace pcl::app
