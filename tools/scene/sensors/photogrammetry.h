// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// A machined part as photographs from all around reconstruct it.

#pragma once

#include "scene/sensors/part_samples.h"

namespace pcl::scene {

/** \brief What dense matching of photographs makes of a part, from options of which
 * spread and sigma do not count. The spacing s is that of the best texture.
 *
 * - Poor texture has fewer points: the density varies smoothly by a factor of 30.
 * - Windows of matching average over creases: a point is the mean of the surface on its
 *   side of the part within 2.5 s, half of a window of 5 pixels an s apart.
 * - Matches are off by .3 s (one sigma) in each coordinate; a third of a pixel is what
 *   they usually reach.
 * - One point in 200 is a wrong match, up to 20 s from the surface; its labels are
 * void.
 *
 * Labels follow the local spacing, and lengths are those of the exact points.
 *
 * \throws std::invalid_argument that names the parameter, its value and what it must be
 */
PartSamples reconstructPart(const PartOptions& options);

} // namespace pcl::scene
