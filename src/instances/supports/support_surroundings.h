// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// What is around a flat part: things on it, its own sides, what is above and below.

#pragma once

#include "instances/supports/support_parts.h"

#include <vector>

namespace pcl::segmentation {

// Around the border of a plane, beyond the band of an edge.
constexpr float around_spacings = 6.0f;

/** \brief A side of what is level, or level beside what is steep: 45 degrees or more.
 */
bool isSteep(const Eigen::Vector3f& normal, const SupportPart& part);

/** \brief How far what is not on a part is from its plane, at least, in spacings. */
float bandOf(const SupportPart& part);

/** \brief The areas of what is around a flat part, square meters. */
struct Surroundings {
  double before = 0.0;  ///< near it, and before its plane
  double on_top = 0.0;  ///< what of that has the part on most sides of it
  double behind = 0.0;  ///< near it, behind its plane, and beside it
  double sides = 0.0;   ///< steep to it, behind and beside it, not far down
  double lower = 0.0;   ///< likewise, but level to it, or deeper than a rim
  double through = 0.0; ///< behind its plane, with the part on most sides of it
  double others = 0.0;  ///< all that is not on the plane, near or not
};

// Of 2 degrees: how far the plane of a part is tilted by noise.
constexpr float max_plane_tilt = 0.035f;

/** \brief The areas of what is before and behind a flat part, near or not, square
 * meters. */
struct Levels {
  double above = 0.0; ///< before its plane, and the part is on most sides of it
  double below = 0.0; ///< behind its plane, anywhere
};

/** \param[in] nodes all of the cloud \param[in] unit the median spacing, meters */
Surroundings surroundingsOf(const SupportPart& part,
                            const std::vector<SurfaceNode>& nodes,
                            float unit,
                            unsigned threads);

/** \param[in] nodes all of the cloud \param[in] unit the median spacing, meters */
Levels levelsOf(const SupportPart& part,
                const std::vector<SurfaceNode>& nodes,
                float unit,
                unsigned threads);

} // namespace pcl::segmentation
