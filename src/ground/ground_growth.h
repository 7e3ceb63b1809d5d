// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// PURPOSE

#pragma once

#include "ground/ground_patches.h"

#include <cstddef>
#include <vector>

namespace pcl::segmentation {

/** \brief The ground around a laser in the large: a plane for each octave of the range,
 * fitted to patches that are ground, most of them. */
class CoarseGround {
public:
  CoarseGround(const GroundCells& cells,
               const GroundPatches& all,
               const std::vector<char>& is_level,
               float max_step);

  /** \brief Whether a patch is at the height of the ground there. */
  bool isNear(std::size_t patch) const;

  /** \brief How much higher a patch is than another one, along the ground. */
  double
  rise(std::size_t from, std::size_t to) const
  {
    const Plane& plane = planes_[octaveOf(from)];
    return above(plane, to) - above(plane, from);
  }

private:
  struct Plane {
    double z = 0.0, slope_x = 0.0, slope_y = 0.0;
  };

  double above(const Plane& plane, std::size_t patch) const;

  bool isNear(const Plane& plane, std::size_t patch) const;

  /** To the patches near it, if they are enough. */
  void refit(const std::vector<std::size_t>& patches, Plane& plane) const;

  std::size_t octaveOf(std::size_t patch) const;

  const GroundCells& cells_;
  const GroundPatches& all_;
  float max_step_;
  std::vector<Plane> planes_; ///< from the inside outwards
};

/** \brief Which patches are ground: level enough, planar, and connected over steps that
 * ground may have; and the others like them that are as low and several.
 *
 * The planes of those are fitted again, to ground only. */
std::vector<char> connectedGround(const GroundCells& cells,
                                  const GroundParameters& parameters,
                                  unsigned threads,
                                  GroundPatches& all);

/** \brief The surfaces of the ground near a cell. */
struct NearGround {
  static constexpr std::size_t most = 5;
  std::array<std::int32_t, most> patches{};
  std::size_t count = 0;
};

/** \brief The cell's own patch and the nearest ones on its sides, if they are ground.
 */
NearGround
nearGround(const GroundPatches& all, const std::vector<char>& ground, std::size_t cell);

constexpr std::size_t min_set_patches = 4; // of ground that stands alone

/** \brief A patch that is level and not ground, yet: where it is, in what set. */
struct Rest {
  std::size_t patch, line, set;
};

/** \brief Move the sets that are at the height of the ground nearest to them from the
 * rest to the ground, by vote.
 * \param[in] coarse tells heights along the ground; null: the planes of patches do
 * \return whether there were any */
bool addLowSets(const GroundCells& cells,
                const GroundPatches& all,
                const CoarseGround* coarse,
                float max_step,
                std::vector<Rest>& rest,
                std::vector<char>& ground);

} // namespace pcl::segmentation
