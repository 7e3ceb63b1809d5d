// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// The lowest surface of each cell, its plane, and how planar it is.

#pragma once

#include "ground/ground_cells.h"

#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

namespace pcl::segmentation {

constexpr std::uint32_t no_patch = std::numeric_limits<std::uint32_t>::max();

/** \brief A surface may continue as far away as its own range. */
constexpr std::uint32_t max_bins_apart = bins_per_octave;

/** \brief In steps, how far from a surface its points are: above the noise, below a low
 * curb. */
constexpr float surface_steps = 0.25f;

/** \brief Half a degree by which the planes of patches may be off, per meter. */
constexpr float plane_error = 0.01f;

/** \brief By how much ground may leave its own plane, per meter: 0.6 m at 20 m, as on a
 * crest with a radius of 330 m. */
constexpr double ground_bend = 0.03;

/** \brief Of slopes that are known before, against the points, square meters: the
 * height of a patch is known to 1 cm, ground turns by 3 degrees, (0.01 / 0.05)^2. */
constexpr float prior_weight = 0.04f;

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

  /** \brief How far above or below the plane ground may be at a place. */
  float
  maxRise(float px, float py, float max_step) const
  {
    return max_step + static_cast<float>(ground_bend) * std::hypot(px - x, py - y);
  }

  /** \brief Whether another patch continues the plane, or is a step beside it. */
  bool
  continuesTo(const GroundPatch& other, float max_step) const
  {
    return std::abs(above(other.x, other.y, other.z)) <=
           maxRise(other.x, other.y, max_step);
  }
};

/** \brief Fits the plane of a patch to the middles of its own and other points. */
class PlaneFit {
public:
  explicit PlaneFit(GroundPatch& patch) : patch_(patch) {}

  void add(const GroundPatch& other);

  /** \param[in] weight of the slopes that the patch has, against the points, square
   * meters \return false if the points lie on a line */
  bool run(float weight);

  /** \brief Whether the points are as far from any line as a quarter of their extent.
   */
  bool isSpread() const;

private:
  GroundPatch& patch_;
  // Sums of offsets from the patch, whose plane need not go through it.
  float n_ = 1.0f, x_ = 0.0f, y_ = 0.0f, z_ = 0.0f;
  float xx_ = 0.0f, xy_ = 0.0f, yy_ = 0.0f, xz_ = 0.0f, yz_ = 0.0f;
};

/** \brief The nearest patches: before and behind in the line, on the lines beside it.
 */
using PatchNeighbors = std::array<std::uint32_t, 4>;

enum PatchSide : std::size_t { Inner = 0, Outer = 1, Right = 2, Left = 3 };

/** \brief The nearest marked cell of a line to a bin, or no_patch. */
std::uint32_t nearestInLine(const GroundCells& cells,
                            const std::vector<char>& marks,
                            std::size_t line,
                            std::uint32_t bin,
                            std::uint32_t max_bins);

struct GroundPatches {
  std::vector<GroundPatch> patches;      ///< one per cell; not planar where none is
  std::vector<PatchNeighbors> neighbors; ///< of each cell
};

/** \brief The planarity of the lowest surface, cell by cell. \param[in] feet see
 * feetOf() */
GroundPatches groundPatches(const GroundCells& cells,
                            const std::vector<char>& feet,
                            float max_step,
                            unsigned threads);

} // namespace pcl::segmentation
