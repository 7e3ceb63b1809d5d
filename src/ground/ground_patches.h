// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// PURPOSE

#pragma once

#include "ground/ground_cells.h"

#include <pcl/segmentation/ground_detection.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace pcl::segmentation {

constexpr std::int32_t no_patch = -1;

/** \brief The nearest patches: before and behind in the line, on the lines beside it.
 */
using PatchNeighbors = std::array<std::int32_t, 4>;

enum PatchSide : std::size_t { Inner = 0, Outer = 1, Right = 2, Left = 3 };

/** \brief Cell by cell, whether or not it has a surface itself. */
std::vector<PatchNeighbors> patchNeighbors(const GroundCells& cells,
                                           const std::vector<char>& has_surface,
                                           unsigned threads);

/** \brief The nearest patch on a side that is marked; what is between may be anything.
 * \param[in] most patches to go */
std::int32_t nextMarked(const std::vector<PatchNeighbors>& neighbors,
                        const std::vector<char>& marks,
                        std::size_t from,
                        PatchSide side,
                        int most);

/** \brief The nearest marked patch on lines to one side.
 * \param[in] most lines to go */
std::int32_t markedAside(const GroundCells& cells,
                         const std::vector<char>& marks,
                         std::size_t line,
                         std::uint32_t bin,
                         bool to_left,
                         int most);

/** \brief The lowest surface in a cell, and a plane through it and its neighbors. */
struct GroundPatch {
  float x = 0.0f, y = 0.0f, low = 0.0f; ///< the middle of its own points
  float z = 0.0f;                       ///< of the plane there
  float slope_x = 0.0f, slope_y = 0.0f;
  float planar = 0.0f; ///< likelihood; 0 unknown

  /** \brief How high above the plane a point is. */
  float
  above(float px, float py, float pz) const
  {
    return pz - (z + slope_x * (px - x) + slope_y * (py - y));
  }
};

/** \brief How much higher or lower than expected ground may be, from patch to patch. */
float mostRise(const GroundPatch& a, const GroundPatch& b, float max_step);

/** \brief Whether the second patch continues the plane of the first, or is a step
 * beside it. */
bool continues(const GroundPatch& a, const GroundPatch& b, float max_step);

/** \brief Of slopes that are known before: the height of a patch is known to 1 cm,
 * ground turns by 3 degrees, (0.01 / 0.05)^2. */
constexpr float prior_weight = 0.04f;

/** \brief Fit the plane of a patch to the middles of its own and other points.
 * \param[in] prior_weight of the slopes that the patch has, against the points, metres
 * squared \return false if the points lie on a line */
bool fitPlane(GroundPatch& patch,
              const GroundPatch* const* others,
              std::size_t count,
              float prior_weight);

/** \brief A plane through the patch and a neighbor in each of both directions, then one
 * that fits to all neighbors that it passes nearby. Where one line of points is all
 * there is, the ground is as level across it as in the large.
 * \return false if there is none */
bool fitRobustly(const std::vector<GroundPatch>& low,
                 const PatchNeighbors& neighbors,
                 float near,
                 GroundPatch& patch);

struct GroundPatches {
  std::vector<GroundPatch> patches; ///< one a cell; not planar where there is none
  std::vector<PatchNeighbors> neighbors;
};

/** \brief The planarity of the lowest surface, cell by cell. \param[in] feet see
 * feetOf() */
GroundPatches groundPatches(const GroundCells& cells,
                            const std::vector<char>& feet,
                            const GroundParameters& parameters,
                            unsigned threads);

} // namespace pcl::segmentation
